#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads LinuxCNC's own programs, and holds what is understood against LinuxCNC's interpreter.

    linuxcnc_agrees.py DGT [FOLDER]

FOLDER has the programs of the package linuxcnc-uspace. Each goes through `dgt path` and through
`rs274 -g`:
  (1) what dgt reads without an error makes the same motions in the same order: kinds, ends, heights,
      sense of arcs, and the middle of each arc, to the digits that rs274 prints;
  (2) what LinuxCNC refuses, dgt refuses;
  (3) what dgt refuses alone uses what it does not read, and says so with a code at a place.
Then a few programs that must fail in both. Moves that go nowhere are left out on both sides. Exit 1
on a disagreement, 77 when there is no LinuxCNC or no program of it.
"""
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

import rs274

kPrograms = "/usr/share/linuxcnc/ncfiles"
kSkipped = 77
kInch = 25.4
# rs274 prints four decimals of the program's unit; ends and centres together move the middle of an
# arc by a few times that.
kDigits = 0.0001
kMostMotions = 200000
kKerfUnknown = "[DGT1403]"

# What LinuxCNC lacks rather than refuses: no machine, no tool table, no feed is needed to read.
kNotOurs = re.compile(r"feed rate|tool|spindle|units per rev|file not found|no percent sign",
                      re.IGNORECASE)

kMustFail = {
    "radii that differ": "G21 G90 F100\nG0 X0 Y0\nG2 X10 Y0 I4 J0\nM2\n",
    "radius too small": "G21 G90 F100\nG0 X0 Y0\nG2 X10 Y0 R4\nM2\n",
    "two motions": "G21 G90 F100\nG0 G1 X10\nM2\n",
    "a word twice": "G21 G90 F100\nG1 X10 X20\nM2\n",
    "no motion": "G21 G90 F100\nG80\nX10\nM2\n",
    "an arc without centre": "G21 G90 F100\nG0 X0\nG2 X10 Y5\nM2\n",
    "an unknown G": "G21 G90 G100\nM2\n",
    "an open comment": "G21 G90 (open\nM2\n",
    "a centre without an arc": "G21 G90 F100\nG1 X10 I5\nM2\n",
    "a dwell without its time": "G21 G90\nG4\nM2\n",
}


class Mismatch(Exception):
    pass


class Motion:
    """A line, arc or rapid in mm."""

    def __init__(self, kind, end, height, middle=None, ccw=None, block=""):
        self.kind = kind
        self.end = end
        self.height = height
        self.middle = middle
        self.ccw = ccw
        self.block = block

    def __str__(self):
        return f"{self.kind} to {self.end[0]:.4f} {self.end[1]:.4f} {self.height:.4f} {self.block}"


def middle_of_arc(begin, end, centre, ccw):
    a0 = math.atan2(begin[1] - centre[1], begin[0] - centre[0])
    a1 = math.atan2(end[1] - centre[1], end[0] - centre[0])
    turn = (a1 - a0) if ccw else (a0 - a1)
    turn %= 2 * math.pi
    if turn < 1e-9:
        turn = 2 * math.pi
    at = a0 + (turn / 2 if ccw else -turn / 2)
    radius = (math.dist(begin, centre) + math.dist(end, centre)) / 2
    return (centre[0] + radius * math.cos(at), centre[1] + radius * math.sin(at))


def motions_of_linuxcnc(text):
    """The motions up to the end of the program, and the unit of the coarsest digits."""
    motions = []
    at = (0.0, 0.0)
    height = 0.0
    unit = 1.0
    coarsest = 1.0
    names = {"STRAIGHT_TRAVERSE": "rapid", "STRAIGHT_FEED": "line", "ARC_FEED": "arc"}
    for name, inside in rs274.all_calls(rs274.canonical_text(text)):
        if name == "USE_LENGTH_UNITS":
            unit = kInch if "INCHES" in inside else 1.0
            coarsest = max(coarsest, unit)
        if name not in names:
            continue
        values = [value * unit for value in rs274.numbers(inside)]
        end = (values[0], values[1])
        top = values[5] if name == "ARC_FEED" else values[2]
        if name == "ARC_FEED":
            turns = round(values[4] / unit)
            if abs(turns) != 1:
                raise Mismatch(f"an arc of {turns} turns")
            middle = middle_of_arc(at, end, (values[2], values[3]), turns > 0)
            motions.append(Motion("arc", end, top, middle, turns > 0))
        elif math.dist(at, end) > 1e-9 or abs(top - height) > 1e-9:
            motions.append(Motion(names[name], end, top))
        at, height = end, top
        if len(motions) > kMostMotions:
            raise Mismatch("too long")
    return motions, coarsest


def motions_of_dgt(path):
    motions = []
    height = 0.0
    at = tuple(path["start"])
    if math.dist(at, (0, 0)) > 0:
        motions.append(Motion("rapid", at, height, block="the start"))
    for move in path["moves"]:
        if move["kind"] not in ("rapid", "line", "arc"):
            continue
        end = tuple(move["to"])
        top = move.get("z", height)
        block = f"(line {move['source']['line']})"
        if move["kind"] == "arc":
            middle = middle_of_arc(at, end, tuple(move["center"]), move["ccw"])
            motions.append(Motion("arc", end, top, middle, move["ccw"], block))
        elif math.dist(at, end) > 1e-9 or abs(top - height) > 1e-9:
            motions.append(Motion(move["kind"], end, top, block=block))
        at, height = end, top
    return motions


def without_arrival(motions):
    """From the place of the first cut on: where a program begins, and on what way, is our choice."""
    cut = next((k for k, m in enumerate(motions) if m.kind != "rapid"), len(motions))
    return motions[max(cut - 1, 0):]


def compare(ours, theirs, digits, with_heights):
    ours, theirs = without_arrival(ours), without_arrival(theirs)
    for k, (a, b) in enumerate(zip(ours, theirs), 1):
        if a.kind != b.kind or a.ccw != b.ccw:
            raise Mismatch(f"motion {k}: {a} here, {b} there")
        off = abs(a.height - b.height) if with_heights else 0
        if math.dist(a.end, b.end) > 2 * digits or off > 2 * digits:
            raise Mismatch(f"motion {k} ends elsewhere: {a} here, {b} there")
        # The radii of an arc may differ; its middle lies between them.
        if a.middle and math.dist(a.middle, b.middle) > 20 * digits + 0.03:
            raise Mismatch(f"motion {k} bulges elsewhere: {a.middle} here, {b.middle} there")
    if len(ours) != len(theirs):
        longer = ours if len(ours) > len(theirs) else theirs
        raise Mismatch(f"{len(ours)} motions here, {len(theirs)} there; "
                       f"{longer[min(len(ours), len(theirs))]}")


def read_by_dgt(dgt, name):
    done = subprocess.run([dgt, "path", "--from", "gcode", "--lang", "en", name],
                          capture_output=True, text=True, check=False)
    if done.returncode == 0:
        return json.loads(done.stdout), done.stderr
    if done.returncode != 1 or not re.search(r":\d+:\d+: error: .*\[DGT\d{4}\]", done.stderr):
        raise Mismatch(f"dgt path: exit {done.returncode}: {done.stderr[-200:]}")
    return None, re.search(r":(\d+:\d+: error: .*)", done.stderr)[1]


def check(dgt, name, text):
    path, refusal = read_by_dgt(dgt, name)
    try:
        theirs, unit = motions_of_linuxcnc(text)
    except rs274.Refused as fault:
        if path is None:
            return "refused by both"
        if kNotOurs.search(str(fault)):
            return "LinuxCNC lacks its machine"
        raise Mismatch(f"dgt reads what LinuxCNC refuses: {fault}") from fault
    if path is None:
        return "not read: " + refusal[:90]
    if any(contour["offset"] for contour in path["contours"]) or kKerfUnknown in refusal:
        return "has a kerf, which is that of LinuxCNC's tool table there"
    ours = motions_of_dgt(path)
    # The length of a tool, G43 H, is that of LinuxCNC's tool table.
    compare(ours, theirs, kDigits * unit, not re.search(r"[Gg]43", text))
    return f"same {len(ours)} motions"


def programs(folder):
    for where, _, files in sorted(os.walk(folder)):
        for name in sorted(files):
            if name.endswith((".ngc", ".nc", ".tap")):
                yield os.path.join(where, name)


def must_fail(dgt):
    missed = 0
    with tempfile.TemporaryDirectory() as folder:
        for what, text in kMustFail.items():
            name = os.path.join(folder, "part.ngc")
            with open(name, "w", encoding="ascii") as file:
                file.write(text)
            path, _ = read_by_dgt(dgt, name)
            try:
                rs274.canonical_text(text)
                print(f"must fail: {what}: LinuxCNC reads it")
                missed += 1
            except rs274.Refused:
                pass
            if path is not None:
                print(f"must fail: {what}: dgt reads it")
                missed += 1
    return missed


def main():
    dgt = sys.argv[1]
    folder = sys.argv[2] if len(sys.argv) > 2 else kPrograms
    if shutil.which("rs274") is None or not os.path.isdir(folder):
        print("no rs274 or no programs of LinuxCNC: install linuxcnc-uspace to compare with it")
        return kSkipped
    missed = same = count = 0
    for full in programs(folder):
        with open(full, encoding="utf-8", errors="replace") as file:
            text = file.read()
        short = os.path.relpath(full, folder)
        count += 1
        try:
            outcome = check(dgt, full, text.encode("ascii", "replace").decode())
            same += outcome.startswith("same")
        except (Mismatch, subprocess.TimeoutExpired) as fault:
            missed += 1
            outcome = f"MISS: {fault}"
        print(f"{short:60} {outcome}")
    missed += must_fail(dgt)
    print(f"{count} programs, {same} with the same motions, {missed} disagree")
    return 1 if missed or not same else 0


if __name__ == "__main__":
    sys.exit(main())
