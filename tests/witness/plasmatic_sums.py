#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Adds up the increments of every program of the corpus written in the guide's G-code.

    plasmatic_sums.py DGT CORPUS

The sums are whole tenths of a millimetre, added without rounding. They must lead from the start
to within half a unit of the end of `dgt path` on each axis, and to exactly 0 where the path ends
where it starts. Prints a table; exit 1 when a program drifts.
"""
import re
import sys
from fractions import Fraction

from linuxcnc_reads import Mismatch, compiled, path_of, programs

kUnit = Fraction(1, 10)  # mm
kHalfUnit = float(kUnit) / 2 + 1e-9


def sums(text):
    """The sums of X and of Y, in units, and the number of blocks that move."""
    blocks = text.split("\n")
    if blocks[:2] != ["G21", "G91"] or blocks[-2:] != ["M02", ""]:
        raise Mismatch("not a program of increments from G21, G91 to M02")
    total, moving = {"X": 0, "Y": 0}, 0
    for block in blocks:
        if not re.match(r"G0[0-3] ", block):
            if re.search(r"[XY]", block) and not block.startswith("G04 X"):
                raise Mismatch(f"`{block}` moves without saying how")
            continue
        moving += 1
        for axis, word in re.findall(r"([XY])(\S+)", block):
            units = Fraction(word) / kUnit
            if units.denominator != 1:
                raise Mismatch(f"`{block}`: {word} is no whole number of units")
            total[axis] += units.numerator
    return total["X"], total["Y"], moving


def check(path, text):
    x, y, moving = sums(text)
    end = path["moves"][-1]["to"] if path["moves"] else path["start"]
    closed = end == path["start"]
    if closed and (x, y) != (0, 0):
        raise Mismatch(f"closed, but the increments sum to {x}, {y} units")
    for total, a, b, axis in zip((x, y), path["start"], end, "XY"):
        off = abs(total * float(kUnit) - (b - a))
        if off > kHalfUnit:
            raise Mismatch(f"{axis} ends {off:.6f} mm off")
    return x, y, moving, closed


def main():
    dgt, corpus = sys.argv[1:]
    missed = count = closed_count = 0
    print(f"{'program':32} blocks  sum X  sum Y   (units of 0.1 mm)")
    for short, full in programs(corpus):
        try:
            text, _ = compiled(dgt, full, "plasmatic")
            if text is None:
                print(f"{short:32} not for this dialect")
                continue
            count += 1
            x, y, moving, closed = check(path_of(dgt, full), text)
            closed_count += closed
            print(f"{short:32} {moving:6} {x:6} {y:6}   {'closed' if closed else 'open'}")
        except Mismatch as fault:
            missed += 1
            print(f"{short:32} MISS: {fault}")
    print(f"{count} programs, {closed_count} of them closed, {missed} drift")
    return 1 if missed or not closed_count else 0


if __name__ == "__main__":
    sys.exit(main())
