# SPDX-License-Identifier: GPL-3.0-or-later
"""Walks a written curve along the exact move it stands for, and bounds their distance.

Distances are in the plane, in millimetres. A written arc is sampled; to the largest sample comes
what the curve can do between two samples, so that the result is a bound and no estimate (but for
the last digits of doubles).

Written arcs are taken as LinuxCNC runs them: the radius goes evenly from that of the start to that
of the end.
"""
import math

kSampleAngle = math.radians(0.5)
kLeastSamples = 32


class Strays(Exception):
    """The written curve does not follow the exact one."""


def turn_between(a, b):
    """The turn from direction a to direction b, in (-π, π]."""
    turn = math.remainder(b - a, math.tau)
    return math.pi if turn == -math.pi else turn


def direction(centre, point):
    return math.atan2(point[1] - centre[1], point[0] - centre[0])


class WrittenLine:
    """Of length 0: what stands for a move that was not written."""

    def __init__(self, start, end):
        self.start, self.end = start, end
        self.length = math.dist(start, end)
        self.sweep = 0.0
        self.mismatch = 0.0

    def points(self):
        n = kLeastSamples
        for k in range(n + 1):
            yield tuple(a + (b - a) * k / n for a, b in zip(self.start, self.end))

    def between_samples(self, centre):
        """By how much the distance from `centre` can pass the larger of two neighbour samples.

        Along a line that distance f has f'' <= 1/f, so a step h adds at most h²/8f."""
        nearest = min(math.dist(centre, p) for p in self.points()) - self.length / kLeastSamples
        step = self.length / kLeastSamples
        return step * step / (8 * nearest) if nearest > step else step / 2


class WrittenArc:
    def __init__(self, start, end, centre, ccw):
        self.start, self.end, self.centre = start, end, centre
        self.first, self.last = math.dist(centre, start), math.dist(centre, end)
        self.mismatch = abs(self.first - self.last)
        self.from_direction = direction(centre, start)
        turn = turn_between(self.from_direction, direction(centre, end)) * (1 if ccw else -1)
        # From a point to itself: the whole circle, as every control reads it.
        self.sweep = turn if turn > 0 else turn + math.tau
        self.sense = 1 if ccw else -1
        self.length = self.sweep * (self.first + self.last) / 2
        self.samples = max(kLeastSamples, math.ceil(self.sweep / kSampleAngle))

    def points(self):
        yield self.start
        for k in range(1, self.samples):
            part = k / self.samples
            radius = self.first + (self.last - self.first) * part
            angle = self.from_direction + self.sense * self.sweep * part
            yield (self.centre[0] + radius * math.cos(angle),
                   self.centre[1] + radius * math.sin(angle))
        yield self.end

    def between_samples(self, centre):
        """As for lines. With d the distance of the centres, f² = d² + r² + 2dr cos θ has
        |f''| <= d(r+d)/(r-d) by θ; to this comes what the radius changes within a step."""
        apart = math.dist(self.centre, centre)
        radius = min(self.first, self.last)
        step = self.sweep / self.samples
        change = self.mismatch / self.samples
        if apart > radius / 2:
            return step * radius / 2 + change
        return step * step / 8 * apart * (radius + apart) / (radius - apart) + change


class LineWalk:
    """Along an exact line or rapid: one written line, whose distance is largest at an end."""

    def __init__(self, move, _at, _allowed):
        self.move = move
        self.largest = 0.0

    def take(self, written):
        self.largest = max(self.largest, math.dist(written.start, self.move["from"]),
                           math.dist(written.end, self.move["to"]))

    def at_end(self):
        return True


class ArcWalk:
    """Along an exact arc, piece after piece, never back by more than the allowed deviation."""

    def __init__(self, move, at, allowed):
        self.move = move
        self.centre, self.radius = move["center"], move["radius"]
        self.sense = 1 if move["ccw"] else -1
        self.sweep = math.radians(abs(move["sweep"]))
        self.allowed = allowed
        self.largest = 0.0
        self.last_direction = direction(self.centre, at)
        start = direction(self.centre, move["from"])
        self.turned = turn_between(start, self.last_direction) * self.sense
        self.furthest = self.turned

    def distance(self, point):
        """From the point of the exact arc that has been reached; beyond its ends, from the end."""
        off = abs(math.dist(point, self.centre) - self.radius)
        if self.turned < 0:
            off = max(off, math.dist(point, self.move["from"]))
        if self.turned > self.sweep:
            off = max(off, math.dist(point, self.move["to"]))
        return off

    def take(self, written):
        largest = 0.0
        for point in written.points():
            now = direction(self.centre, point)
            self.turned += turn_between(self.last_direction, now) * self.sense
            self.last_direction = now
            if (self.furthest - self.turned) * self.radius > 2 * self.allowed:
                raise Strays("runs backwards along the exact arc")
            self.furthest = max(self.furthest, self.turned)
            largest = max(largest, self.distance(point))
        self.largest = max(self.largest, largest + written.between_samples(self.centre))

    def at_end(self):
        """Tells the end of a full circle from its beginning; where exactly it ends is checked
        by the caller, against the end itself."""
        return (self.sweep - self.turned) * self.radius < 4 * self.allowed


def spread(move, point):
    """No point of the exact move is further from the point."""
    if move["kind"] != "arc":
        return max(math.dist(point, move["from"]), math.dist(point, move["to"]))
    reach = min(2 * move["radius"], move["radius"] * math.radians(abs(move["sweep"])))
    return math.dist(point, move["from"]) + reach


def walk(move, at, allowed):
    return (ArcWalk if move["kind"] == "arc" else LineWalk)(move, at, allowed)
