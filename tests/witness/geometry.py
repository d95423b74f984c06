# SPDX-License-Identifier: GPL-3.0-or-later
"""Oriented lines and circles in plain floats; points and vectors are complex numbers.

A line is its unit left normal n and p: the points with n.x = p, run along -i n. A circle is its
centre and signed radius, counter-clockwise positive. Two elements are in oriented contact when
they touch and run the same way there: n.c - p = r, or |c1 - c2| = |r1 - r2|.

Floats cannot tell a tangency from a near miss, so whatever is within kTouch of a contact is one.
"""
import cmath
import math
from dataclasses import dataclass

kTouch = 1e-9  # mm; contacts made by a definition come out within some 1e-14


class NoSolution(Exception):
    """The elements do not meet, or no element of the kind asked for exists."""


@dataclass(frozen=True)
class Line:
    normal: complex
    p: float

    @property
    def direction(self):
        return -1j * self.normal

    def reversed(self):
        return Line(-self.normal, -self.p)

    def offset(self, left):
        return Line(self.normal, self.p + left)

    def height(self, point):
        """Signed distance of a point, positive on the left."""
        return dot(self.normal, point) - self.p

    def foot(self, point):
        return point - self.height(point) * self.normal


@dataclass(frozen=True)
class Circle:
    centre: complex
    r: float

    def reversed(self):
        return Circle(self.centre, -self.r)

    def offset(self, left):
        radius = self.r - left
        if radius * self.r <= 0:
            raise NoSolution(f"circle of radius {self.r} is eaten by an offset of {left}")
        return Circle(self.centre, radius)

    def height(self, point):
        """Signed distance of a point, positive on the left: inside of a counter-clockwise one."""
        return math.copysign(1, self.r) * (abs(self.r) - abs(point - self.centre))

    def foot(self, point):
        ray = point - self.centre
        if abs(ray) < kTouch:
            raise NoSolution("the normal through the centre has no direction")
        return self.centre + abs(self.r) * ray / abs(ray)

    def heading(self, point):
        """Direction of travel at a point of the circle."""
        ray = point - self.centre
        return math.copysign(1, self.r) * 1j * ray / abs(ray)


def dot(a, b):
    return a.real * b.real + a.imag * b.imag


def unit(degrees):
    """The unit vector at an angle; multiples of 90 degrees without rounding."""
    quarters, rest = divmod(degrees, 90.0)
    turn = (1, 1j, -1, -1j)[int(quarters) % 4]
    return turn * (1 if rest == 0 else cmath.rect(1, math.radians(rest)))


def arc_degrees(circle, start, end):
    """Degrees from start to end in the sense of the circle, in (0, 360), signed like the radius."""
    turn = cmath.phase((end - circle.centre) / (start - circle.centre))
    if circle.r < 0:
        turn = -turn
    return math.copysign(math.degrees(turn % (2 * math.pi)), circle.r)


# --- lines -----------------------------------------------------------------------------------


def line_along(point, direction):
    normal = 1j * direction / abs(direction)
    return Line(normal, dot(normal, point))


def line_through(a, b):
    if abs(a - b) < kTouch:
        raise NoSolution("the points coincide")
    return line_along(a, b - a)


def line_at_angle_touching(circle, degrees):
    normal = 1j * unit(degrees)
    return Line(normal, dot(normal, circle.centre) - circle.r)


def line_leading(vector, rise):
    """Normal of the line with n.vector = rise that runs along `vector` rather than against it."""
    ahead = abs(vector) ** 2 - rise**2
    if ahead < -kTouch:
        raise NoSolution("no tangent: a point inside, or circles within each other")
    return (rise + 1j * math.sqrt(max(ahead, 0.0))) * vector / abs(vector) ** 2


def tangent_from_point(point, circle):
    """From the point towards its contact; from a point on the circle, in the circle's direction."""
    if abs(circle.height(point)) < kTouch:
        return line_along(point, circle.heading(point))
    normal = line_leading(circle.centre - point, circle.r)
    return Line(normal, dot(normal, point))


def tangent_of_circles(a, b):
    """From the contact on the first towards that on the second."""
    normal = line_leading(b.centre - a.centre, b.r - a.r)
    return Line(normal, dot(normal, a.centre) - a.r)


# --- meetings --------------------------------------------------------------------------------


def contact(a, b):
    """Where two elements in oriented contact touch; None when they are in none."""
    if isinstance(a, Line) and isinstance(b, Line):
        return None
    if isinstance(a, Circle) and isinstance(b, Circle):
        gap = abs(a.centre - b.centre)
        if abs(gap - abs(a.r - b.r)) > kTouch or gap < kTouch:
            return None
        return a.centre - a.r * (a.centre - b.centre) / (a.r - b.r)
    line, circle = (a, b) if isinstance(a, Line) else (b, a)
    if abs(line.height(circle.centre) - circle.r) > kTouch:
        return None
    return circle.centre - circle.r * line.normal


def meet(a, b):
    """[I1, I2], or one point for two lines and for a touch. Moving along the first: I1 is where it
    enters the disc of the second; for a circle and a line, where the line leaves the disc."""
    touch = contact(a, b)
    if touch is not None:
        return [touch]
    if isinstance(a, Line):
        return [meet_lines(a, b)] if isinstance(b, Line) else meet_line_circle(a, b)
    if isinstance(b, Line):
        return list(reversed(meet_line_circle(b, a)))
    return meet_circles(a, b)


def meet_lines(a, b):
    cross = (a.normal.conjugate() * b.normal).imag
    if abs(cross) < 1e-12:
        raise NoSolution("parallel lines")
    return -1j * (a.p * b.normal - b.p * a.normal) / cross


def meet_line_circle(line, circle):
    height = line.height(circle.centre)
    foot = circle.centre - height * line.normal
    if abs(height + circle.r) < kTouch:  # they touch and run against each other
        return [foot]
    square = circle.r**2 - height**2
    if square < 0:
        raise NoSolution(f"line passes circle by {abs(height) - abs(circle.r)}")
    half = math.sqrt(square) * line.direction
    return [foot - half, foot + half]


def meet_circles(a, b):
    vector = b.centre - a.centre
    gap = abs(vector)
    if gap < kTouch:
        raise NoSolution("circles about one centre")
    if abs(gap - abs(a.r + b.r)) < kTouch:  # they touch and run against each other
        return [a.centre + a.r * vector / (a.r + b.r)]
    along = (gap**2 + a.r**2 - b.r**2) / (2 * gap)
    square = a.r**2 - along**2
    if square < 0:
        raise NoSolution("circles that do not meet")
    half = math.sqrt(square)
    points = [a.centre + complex(along, s * half) * vector / gap for s in (1, -1)]
    enters = [q for q in points if dot(a.heading(q), q - b.centre) < 0]
    leaves = [q for q in points if dot(a.heading(q), q - b.centre) >= 0]
    return enters + leaves


def select(points, selector):
    """Number of the point a selector names: 1, 2, or 3...6 for larger X, larger Y, smaller X,
    smaller Y."""
    if selector <= 2:
        if selector > len(points):
            raise NoSolution("a selector that selects nothing")
        return selector - 1
    value = {3: lambda q: q.real, 4: lambda q: q.imag,
             5: lambda q: -q.real, 6: lambda q: -q.imag}[selector]
    best = max(range(len(points)), key=lambda k: value(points[k]))
    if any(k != best and abs(value(points[k]) - value(points[best])) < kTouch
           for k in range(len(points))):
        raise NoSolution("candidates equal in the selected coordinate")
    return best


# --- circles ---------------------------------------------------------------------------------


def circle_through(a, b, c):
    """Counter-clockwise, through three points."""
    u, v = b - a, c - a
    cross = (u.conjugate() * v).imag
    if abs(cross) < kTouch:
        raise NoSolution("the points lie on a line")
    centre = a + 1j * (v * abs(u) ** 2 - u * abs(v) ** 2) / (-2 * cross)
    return Circle(centre, abs(centre - a))


def locus(element, r):
    """Where the centres of the circles of signed radius r in oriented contact with it lie,
    directed as the element is."""
    if isinstance(element, Line):
        return element.offset(r)
    return Circle(element.centre, math.copysign(abs(element.r - r), element.r))


def centres_touching(a, b, r):
    """Centres of the circles of signed radius r in oriented contact with both."""
    return meet(locus(a, r), locus(b, r))
