# SPDX-License-Identifier: GPL-3.0-or-later
"""A contour's items become moves: once as programmed, once with every element offset.

Both passes walk the same items. The first decides (which intersection, which fillet) and writes
its decisions down; the second takes them over.
"""
import copy
import math

import geometry as g
from definitions import Frame

kSame = 1e-9  # mm; points closer than this are one point


class Tool:
    """Where the tool stands, what is modal, and the moves made so far."""

    def __init__(self):
        self.at = 0j
        self.start = 0j
        self.feed = None
        self.rapid_lines = False  # F0
        self.height = None  # Z for the next move
        self.moves = []

    def has_moved(self):
        return any(m["kind"] in ("line", "arc", "rapid") for m in self.moves)

    def thread(self, point):
        if self.has_moved():
            self.straight(point, "thread", rapid=True)
        else:
            self.at = self.start = point

    def word(self, letter, value):
        if letter == "F":
            self.rapid_lines = value == 0
            self.feed = self.feed if value == 0 else value
        elif letter == "T":
            self.record({"kind": "dwell", "seconds": value, "role": "contour"}, self.at)
        elif letter in "MS":
            self.record({"kind": "code", "code": f"{letter}{value:g}", "role": "contour"}, self.at)
        elif letter == "Z":
            self.height = value
        else:
            raise g.NoSolution(f"the word {letter} has no place here")

    def straight(self, point, role, rapid=False):
        """False when the tool stands there already."""
        if abs(point - self.at) < kSame:
            return False
        kind = "rapid" if rapid or self.rapid_lines else "line"
        self.record({"kind": kind, "role": role}, point)
        return True

    def arc(self, circle, point, role, full=False):
        if self.rapid_lines:
            raise g.NoSolution("a rapid arc")
        if abs(point - self.at) < kSame and not full:
            raise g.NoSolution("an arc that ends where it begins")
        sweep = math.copysign(360, circle.r) if full else g.arc_degrees(circle, self.at, point)
        self.record({"kind": "arc", "role": role, "center": xy(circle.centre),
                     "radius": abs(circle.r), "ccw": circle.r > 0, "sweep": sweep}, point)

    def record(self, move, point):
        move.update({"from": xy(self.at), "to": xy(point)})
        if move["kind"] in ("line", "arc", "rapid"):
            if self.height is not None:
                move["z"], self.height = self.height, None
        if self.feed is not None:
            move["feed"] = self.feed
        self.moves.append(move)
        self.at = point


def xy(point):
    return [point.real + 0.0, point.imag + 0.0]


class ContourRun:
    def __init__(self, number, tool, offset_side):
        self.number = number
        self.tool = tool
        self.offset_side = offset_side
        self.items = []
        self.frame = self.base = Frame()

    def item(self, letter, value):
        """Takes the next item; A and O are used up here, everything kept is in the world."""
        if letter == "A":
            self.frame = self.base.turned(value)
        elif letter == "O":
            self.frame = self.base = value
        elif letter in ("L", "C"):
            self.items.append(("element", self.frame.place(value)))
        elif letter in ("P", "XY"):
            self.items.append(("point", self.frame.place(value)))
        elif letter == "X":
            self.items.append(("axis", self.frame.place(g.Line(1 + 0j, value))))
        elif letter == "Y":
            self.items.append(("axis", self.frame.place(g.Line(1j, value))))
        else:
            self.items.append((letter, value))

    def finish(self):
        """The contour as `dgt path` tells it; None for an empty one."""
        if not self.items:
            return None
        width = next((v for letter, v in self.items if letter == "W"), 0.0)
        sign = self.sign_of_offset()
        decisions = []
        shadow = copy.deepcopy(self.tool)
        programmed = Pass(shadow, 0.0, decisions, replay=False)
        programmed.run(self.items)
        first = len(self.tool.moves)
        Pass(self.tool, sign, decisions, replay=True).run(self.items)
        side = {0.0: "none", 1.0: "left", -1.0: "right"}[sign]
        return {"id": self.number, "offset": width, "side": side,
                "closed": is_closed(programmed.pieces),
                "programmed": shadow.moves[first:], "moves": self.tool.moves[first:]}

    def sign_of_offset(self):
        """+1 when a positive W lies left of the elements, -1 when right, 0 without an offset."""
        widths = [v for letter, v in self.items if letter in ("W", "U") and v != 0]
        if not widths:
            return 0.0
        if self.offset_side != "auto":
            return 1.0 if self.offset_side == "left" else -1.0
        if any(letter == "W" and v < 0 for letter, v in self.items):
            raise g.NoSolution("W < 0 tells no side")
        at, approach = self.tool.at, None
        for letter, value in self.items:
            if letter == "point":
                approach = value
            elif letter == "element":
                height = value.height(at if approach is None else approach)
                if abs(height) < kSame:
                    raise g.NoSolution("no side can be told")
                return math.copysign(1.0, height)
        raise g.NoSolution("an offset without an element")


class Pass:
    """One walk over the items, `sign` 0 for the contour as programmed."""

    def __init__(self, tool, sign, decisions, replay):
        self.tool = tool
        self.sign = sign
        self.decisions = iter(decisions) if replay else decisions
        self.replay = replay
        self.width = 0.0  # offset to the left in force
        self.current = None  # (element, its offset) being followed
        self.started = False  # False: the first pair only positions
        self.lead = None  # the point or axis line the tool came to last
        self.begun_at = None  # foot where an element approached from a point was begun
        self.joint = None  # R, V or D read since the element
        self.selector = 1
        self.rapid_once = False
        self.thread_next = False
        self.pieces = []

    def run(self, items):
        for letter, value in items:
            handler = {"element": self.element, "point": self.point, "axis": self.axis}.get(letter)
            if handler:
                handler(value)
            else:
                self.word(letter, value)
        if self.joint:
            self.leave_by_distance()

    def word(self, letter, value):
        if letter in ("W", "U"):
            if letter == "W" and self.current:
                raise g.NoSolution("W after the first element")
            self.width = self.sign * value
        elif letter in ("R", "V"):
            self.joint = (letter, value)
        elif letter == "D":
            self.joint = (letter, value)
            self.leave_by_distance()
        elif letter == "I":
            self.selector = int(value)
        elif letter == "G" and value == 0:
            self.rapid_once = True
        elif letter == "G" and value == 54:
            self.thread_next = True
        else:
            self.tool.word(letter, value)

    # --- decisions ---

    def decide(self, make):
        """What the programmed pass decided."""
        if self.replay:
            return next(self.decisions)
        made = make()
        self.decisions.append(made)
        return made

    def crossing(self, a, b):
        points = g.meet(a, b)
        chosen = self.decide(lambda: g.select(points, self.selector))
        self.selector = 1
        return points[min(chosen, len(points) - 1)]

    # --- moves ---

    def straight(self, point, role):
        if self.tool.straight(point, role, rapid=self.rapid_once):
            self.rapid_once = False

    def follow(self, element, point, role="contour", full=False):
        begin = self.tool.at
        if isinstance(element, g.Line):
            self.tool.straight(point, role)
        else:
            self.tool.arc(element, point, role, full)
        self.pieces.append((element, begin, point))

    def travel(self, point, full=False):
        """Along the current element to a point of it; in the first pair straight there."""
        if self.started:
            self.follow(self.current[0], point, full=full)
        else:
            self.straight(point, "lead-in")

    # --- items ---

    def element(self, plain):
        shifted = plain.offset(self.width)
        if self.current is None:
            self.begin(shifted)
        elif self.joint is None:
            self.travel(self.crossing(self.current[0], shifted))
            self.started = True
        else:
            self.blend(plain, shifted)
        self.current = (shifted, self.width, plain)
        self.lead = self.joint = None

    def begin(self, element):
        self.begun_at = None
        self.started = self.lead is not None
        if isinstance(self.lead, complex):
            self.begun_at = element.foot(self.lead)
            self.straight(self.begun_at, "lead-in")
        elif self.lead is not None:
            self.straight(self.crossing(self.lead, element), "lead-in")

    def point(self, point):
        if self.thread_next:
            self.thread_next = False
            self.tool.thread(point)
            return
        role = "contour" if isinstance(self.lead, complex) else "position"
        if self.current:
            foot = self.current[0].foot(point)
            alone = self.begun_at is not None and self.tool.at == self.begun_at
            full = alone and abs(foot - self.begun_at) < kSame
            self.travel(foot, full=full and isinstance(self.current[0], g.Circle))
            role = "lead-out"
        self.straight(point, role)
        self.current, self.lead = None, point

    def axis(self, line):
        if self.current:
            self.travel(self.crossing(self.current[0], line))
        self.current, self.lead = None, line

    def leave_by_distance(self):
        letter, distance = self.joint
        element, width, _ = self.current
        if letter != "D" or not isinstance(element, g.Line):
            raise g.NoSolution("the contour ends in a joint")
        end = self.decide(lambda: self.tool.at + distance * element.direction)
        self.started = True
        self.follow(element, end + width * element.normal)
        self.current = self.lead = self.joint = None

    # --- fillets, chamfers, tangents ---

    def blend(self, plain, shifted):
        letter, size = self.joint
        before, width, plain_before = self.current
        if letter == "R":
            if width != self.width:
                raise g.NoSolution("a fillet between two offsets")
            fillet = self.decide(lambda: self.choose_fillet(before, shifted, size))
            self.selector = 1
            self.smooth(fillet.offset(width), shifted, "fillet")
        elif isinstance(plain, g.Circle):
            if width != self.width:
                raise g.NoSolution("a tangent between two offsets")
            self.smooth(g.tangent_of_circles(before, shifted), shifted, "tangent")
        else:
            corner = g.meet_lines(plain_before, plain)
            edge = g.line_through(corner - size * plain_before.direction,
                                  corner + size * plain.direction).offset(width)
            self.travel(g.meet_lines(before, edge))
            self.follow(edge, g.meet_lines(edge, shifted), "chamfer")
        self.started = True

    def smooth(self, between, shifted, role):
        """Along the element in oriented contact with both its neighbours."""
        self.travel(g.contact(self.current[0], between))
        self.follow(between, g.contact(between, shifted), role)

    def choose_fillet(self, before, after, size):
        found = []
        for radius in [size, -size] if size > 0 else [size]:
            try:
                centres = g.centres_touching(before, after, radius)
            except g.NoSolution:
                continue
            for centre in centres:
                circle = g.Circle(centre, radius)
                a, b = g.contact(before, circle), g.contact(circle, after)
                if a is not None and b is not None:
                    sweep = abs(g.arc_degrees(circle, a, b))
                    found.append((round(sweep, 9), self.reach(before, a), len(found), circle))
        found.sort()
        if self.selector > len(found):
            raise g.NoSolution("no fillet")
        return found[self.selector - 1][-1]

    def reach(self, element, point):
        """How far along the element from where the tool stands; ahead before behind."""
        if not self.started:
            return (0, 0.0)
        if isinstance(element, g.Line):
            ahead = g.dot(element.direction, point - self.tool.at)
            return (ahead < 0, abs(ahead))
        return (0, abs(g.arc_degrees(element, self.tool.at, point) * element.r))


def is_closed(pieces):
    """The cut ends where it began, on the first piece of it, or begins on the last."""
    if not pieces:
        return False
    begin, end = pieces[0][1], pieces[-1][2]
    if abs(begin - end) < kSame:
        return True
    return len(pieces) > 2 and (lies_on(pieces[0], end) or lies_on(pieces[-1], begin))


def lies_on(piece, point):
    element, begin, end = piece
    if abs(element.height(point)) > kSame:
        return False
    if isinstance(element, g.Line):
        return abs(begin - point) + abs(point - end) <= abs(begin - end) + kSame
    return abs(g.arc_degrees(element, begin, point)) <= abs(g.arc_degrees(element, begin, end))
