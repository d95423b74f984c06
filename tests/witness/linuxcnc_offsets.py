#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets LinuxCNC offset the contours of the corpus itself, and holds its path against the equidistant.

    linuxcnc_offsets.py DGT CORPUS

What `dgt compile --post linuxcnc --compensation control` writes has the programmed contours with
G41.1, G42.1 and G40. LinuxCNC's interpreter (`rs274 -g`) offsets them with its own arithmetic. Its
motions are walked along the moves of `dgt path`, with the outer corners round as LinuxCNC has them:
  (1) the same kinds of motions in the same order, nothing left over;
  (2) each ends within kStop of the exact end on each axis, and no point of LinuxCNC's curve is
      further than kCurve from the exact move: the contour is rounded to the grid, and where two
      elements meet the tool is off by what that makes of it;
  (3) arcs shorter than kStop may stand at a joint that rounding has bent;
  (4) LinuxCNC goes round a corner in the block behind it: at that block's feed, and behind the codes
      and dwells that stand between;
  (5) a closed contour that begins in an outer corner need not be cut round that corner at its end.
Then programs are spoiled (another width, another side, the offset not taken back, an end moved), and
each has to be noticed. Exit 1 on a disagreement, 77 when there is no LinuxCNC.
"""
import json
import math
import re
import shutil
import sys

import linuxcnc_reads as reads
import path_walk
import rs274

kCurve = 0.0012  # mm; measured: 0.0011
kStop = 0.0015  # mm; measured: 0.0010
kSkipped = 77


class Reading(reads.Reading):
    """One program: LinuxCNC's calls walked along the exact path."""

    def __init__(self, path, calls):
        super().__init__(path, calls, kCurve)
        self.bends = 0
        self.corner = None
        self.skipped = closing_corners(path)

    def expect(self, name, what):
        """As programs are, but for the grid: what LinuxCNC calculates lies anywhere."""
        call = self.peek()
        if call is None or call.name != name:
            raise reads.Mismatch(f"{what}: {name} expected, {self.show(call)} found")
        self.next += 1
        self.motions += call.moves
        return call

    def follow(self, move, what):
        if id(move) in self.skipped:
            return
        if move.get("role") == "corner":
            self.corner = (move, what)
            return
        if move["kind"] in ("line", "arc", "rapid") and self.corner:
            corner, self.corner = self.corner, None
            super().follow(*corner)
        if move["kind"] in ("line", "arc"):
            self.skip_bends(move)
        super().follow(move, what)

    def check_feed(self, move, block, what):
        if move.get("role") != "corner":
            super().check_feed(move, block, what)

    def skip_bends(self, move):
        """Arcs about a joint that rounding has bent outward."""
        while True:
            call = self.peek()
            if call is None or call.name != "ARC_FEED" or math.dist(self.at, call.end) > kStop:
                return
            arc = path_walk.WrittenArc(self.at, call.end, call.centre, call.turns > 0)
            if arc.length > kStop or path_walk.spread(move, self.at) <= kStop:
                return
            self.next += 1
            self.bends += 1
            self.cut_tolerance += arc.length
            self.at = call.end

    def take(self, move, what):
        call = self.peek()
        if move["kind"] == "arc" and call is not None and call.name == "ARC_FEED":
            self.next += 1
            self.motions += 1
            if call.turns != (1 if move["ccw"] else -1):
                raise reads.Mismatch(f"{what}: turns {call.turns}")
            written = path_walk.WrittenArc(self.at, call.end, call.centre, move["ccw"])
            self.cut += math.hypot(written.length, call.height - self.height)
            self.cut_tolerance += kCurve * (2 + written.sweep)
            return call, written
        return super().take(move, what)

    def is_near(self, point):
        return all(abs(a - b) <= kStop for a, b in zip(self.at, point))

    def check_end(self, call, exact, what):
        error = max(abs(a - b) for a, b in zip(call.end, exact))
        self.end_error = max(self.end_error, error)
        if error > kStop:
            raise reads.Mismatch(f"{what}: ends {error:.6f} mm off on an axis, {call.values}")

    def check_length(self):
        """Corners that are left out are counted as they are in the path."""
        left_out = sum(math.radians(abs(move["sweep"])) * move["radius"]
                       for move in self.path["moves"] if id(move) in self.skipped)
        off = abs(self.cut + left_out - self.path["length"]["cut"])
        if off > self.cut_tolerance + kStop * self.motions:
            raise reads.Mismatch(f"cuts {self.cut:.6f} mm, the path {self.path['length']['cut']}")


def closing_corners(path):
    """The corners that closed contours begin in, where they end on them."""
    found = set()
    moves = path["moves"]
    for k, move in enumerate(moves):
        follows = moves[k + 1]["role"] if k + 1 < len(moves) else "lead-out"
        if move.get("role") == "corner" and follows not in ("contour", "fillet", "chamfer",
                                                            "tangent", "corner"):
            found.add(id(move))
            end = move["from"]
            for later in moves[k + 1:]:
                later["from"] = end
                if later["kind"] in ("line", "arc", "rapid"):
                    break
    return found


def calls_of(text):
    """As rs274.read(), where not every block makes one motion."""
    named = rs274.name_blocks
    rs274.name_blocks = lambda calls, text: None
    try:
        return rs274.read(text)
    finally:
        rs274.name_blocks = named


def compiled(dgt, full):
    done = reads.run_dgt(dgt, "compile", full, "--post", "linuxcnc", "--compensation", "control")
    if done.returncode == 1:
        return None, re.search(r"error: (.*?\[DGT\d+\])", done.stderr)[1]
    if done.returncode != 0:
        raise reads.Mismatch(f"dgt compile: exit {done.returncode}")
    return done.stdout, ""


def path_of(dgt, full):
    done = reads.run_dgt(dgt, "path", full, "--set", "corner=round")
    if done.returncode != 0:
        raise reads.Mismatch(f"dgt path: exit {done.returncode}")
    return json.loads(done.stdout)


def check(path, text):
    reading = Reading(path, calls_of(text))
    reading.run()
    return reading


def spoilings(text):
    width = re.search(r"G4[12]\.1 D([\d.]+)", text)
    if width:
        yield "a width off by 0.006", text.replace(
            width[0], width[0][:-len(width[1])] + f"{float(width[1]) + 0.006:.6f}", 1)
        sides = {"G41.1": "G42.1", "G42.1": "G41.1"}
        yield "the other side", re.sub(r"G4[12]\.1", lambda m: sides[m[0]], text)
        if re.search(r"\nG40\n(?:.*\n)*?G0", text):  # what is not taken back moves what follows
            yield "not taken back", text.replace("\nG40\n", "\n", 1)
    ends = list(re.finditer(r"G01 X(-?[\d.]+)", text))
    for k in (len(ends) // 3, 2 * len(ends) // 3):
        if k < len(ends):
            word = ends[k]
            yield "an end off by 0.01", (text[:word.start(1)] + f"{float(word[1]) + 0.01:.3f}" +
                                         text[word.end(1):])


def unnoticed(dgt, full, text):
    missed = []
    tried = 0
    for what, spoiled in spoilings(text):
        tried += 1
        try:
            check(path_of(dgt, full), spoiled)
            missed.append(what)
        except (reads.Mismatch, rs274.Refused):
            pass
    return tried, missed


def main():
    dgt, corpus = sys.argv[1:]
    if shutil.which("rs274") is None:
        print("no rs274: install linuxcnc-uspace to let LinuxCNC offset the contours")
        return kSkipped
    missed = count = tried = 0
    print(f"{'program':32} motions  curve     end   bends   (largest, mm)")
    for short, full in reads.programs(corpus):
        try:
            text, refusal = compiled(dgt, full)
            if text is None:
                print(f"{short:32} refused: {refusal}")
                continue
            if "G41.1" not in text and "G42.1" not in text:
                continue
            count += 1
            r = check(path_of(dgt, full), text)
            print(f"{short:32} {r.motions:7} {r.deviation:.5f} {r.end_error:.5f} {r.bends:4}")
            if count % 8 == 1:
                more, through = unnoticed(dgt, full, text)
                tried += more
                for what in through:
                    missed += 1
                    print(f"{short:32} NOT NOTICED: {what}")
        except (reads.Mismatch, rs274.Refused) as fault:
            missed += 1
            print(f"{short:32} MISS: {fault}")
    print(f"{count} programs offset by LinuxCNC, {tried} spoiled, {missed} disagree")
    return 1 if missed or not count else 0


if __name__ == "__main__":
    sys.exit(main())
