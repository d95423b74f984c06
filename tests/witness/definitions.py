# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands right of the `=` of an element: every row of the language's tables of forms."""
import geometry as g


class Frame:
    """A coordinate system: its origin in the world and the angle of its X axis."""

    def __init__(self, origin=0j, degrees=0.0):
        self.origin = origin
        self.degrees = degrees

    def turned(self, degrees):
        return Frame(self.origin, self.degrees + degrees)

    def place(self, thing):
        turn = g.unit(self.degrees)
        if isinstance(thing, complex):
            return self.origin + turn * thing
        if isinstance(thing, g.Circle):
            return g.Circle(self.place(thing.centre), thing.r)
        normal = turn * thing.normal
        return g.Line(normal, thing.p + g.dot(normal, self.origin))


def define(kind, operands, selector):
    """`operands`: (letter, value) in the order written, points and elements already looked up:
    P a complex, L and C geometry, X Y A D R M numbers. Like kinds keep their order."""
    letters = "".join(sorted(letter for letter, _ in operands))
    values = {}
    for letter, value in operands:
        values.setdefault(letter, []).append(value)
    first = {letter: found[0] for letter, found in values.items()}
    try:
        form = FORMS[kind + letters]
    except KeyError:
        raise g.NoSolution(f"no form {kind}={letters}") from None
    result = form(first, values)
    if isinstance(result, list):  # the forms with two solutions
        return result[g.select(result, selector)]
    return result


def circles_touching(a, b, r):
    return [g.Circle(centre, r) for centre in g.centres_touching(a, b, r)]


# Kind, then the letters of the operands in alphabetical order. v: first of each kind, all: lists.
FORMS = {
    "LX": lambda v, all: g.Line(1 + 0j, v["X"]),
    "LY": lambda v, all: g.Line(1j, v["Y"]),
    "LPP": lambda v, all: g.line_through(*all["P"]),
    "LLP": lambda v, all: g.line_along(v["P"], v["L"].direction),
    "LDL": lambda v, all: v["L"].offset(v["D"]),
    "LCP": lambda v, all: g.tangent_from_point(v["P"], v["C"]),
    "LAP": lambda v, all: g.line_along(v["P"], g.unit(v["A"])),
    "LAC": lambda v, all: g.line_at_angle_touching(v["C"], v["A"]),
    "LCC": lambda v, all: g.tangent_of_circles(*all["C"]),
    "LALP": lambda v, all: g.line_along(v["P"], v["L"].direction * g.unit(v["A"])),
    "CPR": lambda v, all: g.Circle(v["P"], v["R"]),
    "CPPP": lambda v, all: g.circle_through(*all["P"]),
    "CLLR": lambda v, all: circles_touching(*all["L"], v["R"])[0],
    "CCLR": lambda v, all: circles_touching(v["L"], v["C"], v["R"]),
    "CCCR": lambda v, all: circles_touching(*all["C"], v["R"]),
    "CAMPR": lambda v, all: g.Circle(v["P"] + v["M"] * g.unit(v["A"]), v["R"]),
    "PP": lambda v, all: v["P"],
    "PC": lambda v, all: v["C"].centre,
    "PLL": lambda v, all: g.meet_lines(*all["L"]),
    "PCL": lambda v, all: g.meet(v["L"], v["C"]),
    "PCC": lambda v, all: g.meet(*all["C"]),
    "PAMP": lambda v, all: v["P"] + v["M"] * g.unit(v["A"]),
    "OAP": lambda v, all: Frame(v["P"], v["A"]),
}
