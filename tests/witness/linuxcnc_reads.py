#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets LinuxCNC read every program of the corpus and holds what it understood against the path.

    linuxcnc_reads.py DGT CORPUS

What `dgt compile --post linuxcnc` writes goes through LinuxCNC's own interpreter (`rs274 -g`, of
the package linuxcnc-uspace). Its canonical motions are walked along the moves of `dgt path`:
  (1) every motion is of the kind of its move, moves and codes stand in the same order, nothing is
      left over; a move may be missing only where it rounds to nothing;
  (2) every motion ends within half a unit of the exact end on each axis (the inner joints of a
      divided arc: within the certified deviation of the arc);
  (3) no point of the curve LinuxCNC runs is further from the exact move than the deviation that
      the compiler certified for the program;
  (4) the two radii of an arc agree to one unit;
  (5) torch, codes, dwells, feeds and heights are those of the path and the dialect's policy;
  (6) the length cut is that of the path, within what (3) leaves open.
rs274 prints four decimals and the programs have three, so its print costs nothing; that every
number lies on the grid is checked. Prints a table; exit 1 when a program disagrees, 77 when there
is no LinuxCNC.
"""
import json
import math
import os
import re
import shutil
import subprocess
import sys

import path_walk
import rs274

kUnit = 0.001  # mm, of the dialect
kHalfUnit = kUnit / 2 + 1e-9  # a coordinate half-way between two may go to either
kDouble = 1e-9  # mm, for the last digits of doubles
kDefaultFeed = 1000.0  # mm/min, written where the program says none
kSkipped = 77

kTorchCodes = {"M3", "M4", "M5", "M7", "M8", "53", "54"}
kCodes = {
    "M0": "PROGRAM_STOP", "M1": "OPTIONAL_PROGRAM_STOP", "0": "PROGRAM_STOP",
    "M3": "START_SPINDLE_CLOCKWISE", "M4": "START_SPINDLE_COUNTERCLOCKWISE",
    "M5": "STOP_SPINDLE_TURNING",
    "M7": "MIST_ON", "53": "MIST_ON", "M8": "FLOOD_ON", "54": "FLOOD_ON",
}


class Mismatch(Exception):
    pass


class Reading:
    """One program: LinuxCNC's calls walked along the exact path."""

    def __init__(self, path, calls, certified):
        self.path = path
        self.calls = calls
        self.certified = certified
        self.next = 0
        self.at = None
        self.height = self.exact_height = 0.0  # before its first Z a tool stands at 0
        self.feed = None
        self.said_feed = None
        self.torch = False
        codes = {plain(m["code"]) for m in path["moves"] if m["kind"] == "code"}
        self.switches_torch = not codes & kTorchCodes
        self.deviation = self.end_error = self.mismatch = 0.0
        self.cut = self.rapid = self.cut_tolerance = 0.0
        self.motions = 0

    def run(self):
        if self.path["moves"]:
            first = self.expect("STRAIGHT_TRAVERSE", "the rapid to the start")
            self.at = first.end
            self.check_end(first, self.path["start"], "the start")
        for k, move in enumerate(self.path["moves"], 1):
            self.follow(move, f"move {k} ({move['kind']}, line {move['source']['line']})")
        self.switch_torch(False, "the end")
        if self.peek() is not None:
            raise Mismatch(f"left over: {self.show(self.peek())}")
        self.check_length()

    # --- calls

    def peek(self):
        """The next call but feeds, which are a state."""
        while self.next < len(self.calls) and self.calls[self.next].name == "SET_FEED_RATE":
            self.feed = self.calls[self.next].values[0]
            self.next += 1
        return self.calls[self.next] if self.next < len(self.calls) else None

    @staticmethod
    def show(call):
        return "the end of the program" if call is None else call.block or call.name

    def expect(self, name, what):
        call = self.peek()
        if call is None or call.name != name:
            seen = "" if call is None else f" ({call.name})"
            raise Mismatch(f"{what}: {name} expected, {self.show(call)}{seen} found")
        self.next += 1
        self.motions += call.moves
        for value in call.values if call.moves else []:
            if abs(value / kUnit - round(value / kUnit)) > 1e-6:
                raise Mismatch(f"{call.block}: {value} is not on the grid")
        return call

    # --- what is not a motion

    def switch_torch(self, on, what):
        if self.switches_torch and on != self.torch:
            self.expect("MIST_ON" if on else "FLOOD_ON", f"torch before {what}")
            self.torch = on

    def say_code(self, code, what):
        if code.startswith("S"):
            call = self.expect("SET_SPINDLE_SPEED", f"{what} {code}")
            if abs(call.values[-1] - float(code[1:])) > 1e-4:
                raise Mismatch(f"{what}: {code} read as {call.values[-1]}")
        elif code in kCodes:
            self.expect(kCodes[code], f"{what} {code}")
        elif code not in ("M2", "M30"):
            raise Mismatch(f"{what}: the witness does not know {code}")

    def check_feed(self, move, block, what):
        if "feed" in move:
            self.said_feed = move["feed"]
        elif self.said_feed is None:
            self.said_feed = kDefaultFeed
        if self.feed is None or abs(self.feed - self.said_feed) > 1e-3:
            raise Mismatch(f"{what}, {block}: feed {self.feed}, not {self.said_feed}")

    # --- motions

    def follow(self, move, what):
        if move["kind"] == "dwell":
            call = self.expect("DWELL", what)
            if abs(call.values[0] - move["seconds"]) > 1e-4:
                raise Mismatch(f"{what}: {call.values[0]} s, not {move['seconds']}")
        elif move["kind"] == "code":
            self.say_code(plain(move["code"]), what)
        else:
            self.travel(move, what)

    def travel(self, move, what):
        cuts = move["kind"] != "rapid"
        from_height = self.exact_height
        self.exact_height = move.get("z", from_height)
        self.cut_tolerance += 2 * self.certified if cuts else 0
        if self.is_dropped(move):
            if cuts:
                self.record(path_walk.spread(move, self.at), what, "a move that was left out")
            return
        self.switch_torch(cuts, what)
        walk = path_walk.walk(move, self.at, self.certified + kUnit)
        while True:
            call, written = self.take(move, what)
            try:
                walk.take(written)
            except path_walk.Strays as fault:
                raise Mismatch(f"{what}, {call.block}: {fault}") from fault
            if cuts:
                self.record(walk.largest, what, call.block)
                self.check_feed(move, call.block, what)
            self.at = call.end
            self.height = call.height
            last = walk.at_end() and (move["kind"] != "arc" or self.is_near(move["to"]))
            self.check_height(walk, from_height, last, f"{what}, {call.block}")
            if last:
                return self.check_end(call, move["to"], what)

    def take(self, move, what):
        """The next motion, which must be of the kind of the move."""
        name = {"rapid": "STRAIGHT_TRAVERSE", "line": "STRAIGHT_FEED", "arc": "ARC_FEED"}
        call = self.peek()
        # A piece of an arc may be so flat that it is written as a line.
        flat = move["kind"] == "arc" and call is not None and call.name == "STRAIGHT_FEED"
        call = self.expect("STRAIGHT_FEED" if flat else name[move["kind"]], what)
        if call.name == "ARC_FEED":
            if call.turns != (1 if move["ccw"] else -1):
                raise Mismatch(f"{what}, {call.block}: turns {call.turns}")
            written = path_walk.WrittenArc(self.at, call.end, call.centre, move["ccw"])
            if written.mismatch > kUnit + kDouble:
                raise Mismatch(f"{what}, {call.block}: radii {written.first}, {written.last}")
        else:
            written = path_walk.WrittenLine(self.at, call.end)
        self.mismatch = max(self.mismatch, written.mismatch)
        if move["kind"] == "rapid":
            self.rapid += math.hypot(written.length, call.height - self.height)
        else:
            self.cut += math.hypot(written.length, call.height - self.height)
            self.cut_tolerance += self.certified * (2 + written.sweep)
        return call, written

    def is_near(self, point):
        return all(abs(a - b) <= kHalfUnit for a, b in zip(self.at, point))

    def is_dropped(self, move):
        """Both ends round to one point and the next call does not go there."""
        if not self.is_near(move["to"]) or abs(self.height - self.exact_height) > kHalfUnit:
            return False
        return path_walk.spread(move, self.at) <= self.certified + kUnit

    # --- checks

    def record(self, distance, what, block):
        self.deviation = max(self.deviation, distance)
        if distance > self.certified + kDouble:
            raise Mismatch(f"{what}, {block}: {distance:.6f} mm off, certified {self.certified}")

    def check_end(self, call, exact, what):
        error = max(abs(a - b) for a, b in zip(call.end, exact))
        self.end_error = max(self.end_error, error)
        if error > kHalfUnit:
            raise Mismatch(f"{what}, {call.block}: ends {error:.6f} mm off on an axis")

    def check_height(self, walk, from_height, last, what):
        """Half a unit at the end of a move; on the way a unit, from the rounded heights."""
        part = 1.0 if last else walk.turned / walk.sweep
        exact = from_height + (self.exact_height - from_height) * part
        if abs(self.height - exact) > (kHalfUnit if last else 2 * kHalfUnit):
            raise Mismatch(f"{what}: at Z{self.height}, not Z{exact}")

    def check_length(self):
        """A written line or arc within the deviation d of the exact one is longer or shorter by at
        most d at each end and d for each radian it turns; so is what a missing move leaves out."""
        off = abs(self.cut - self.path["length"]["cut"])
        if off > self.cut_tolerance + 1e-6:
            raise Mismatch(f"cuts {self.cut:.6f} mm, the path {self.path['length']['cut']}")


def plain(code):
    """`M07` as `M7`."""
    return re.sub(r"(?<![\d.])0+(?=\d)", "", code)


def programs(corpus):
    for folder, _, files in sorted(os.walk(corpus)):
        for name in sorted(files):
            if name.endswith(".bgt"):
                full = os.path.join(folder, name)
                yield os.path.relpath(full, corpus), full


def run_dgt(dgt, *arguments):
    return subprocess.run([dgt, *arguments, "--lang", "en"], capture_output=True, text=True,
                          check=False)


def compiled(dgt, full, post):
    """The program's text and its certified deviation; nothing where the dialect cannot say it."""
    done = run_dgt(dgt, "compile", full, "--post", post)
    if done.returncode == 1:
        return None, None
    certificate = re.search(r"at most ([\d.]+) mm off the exact path", done.stderr)
    if done.returncode != 0 or not certificate:
        raise Mismatch(f"dgt compile: exit {done.returncode}: {done.stderr.strip()[-200:]}")
    return done.stdout, float(certificate[1])


def path_of(dgt, full):
    done = run_dgt(dgt, "path", full)
    if done.returncode != 0:
        raise Mismatch(f"dgt path: exit {done.returncode}")
    return json.loads(done.stdout)


def check(path, text, certified):
    reading = Reading(path, rs274.read(text), certified)
    reading.run()
    return reading


def main():
    dgt, corpus = sys.argv[1:]
    if shutil.which("rs274") is None:
        print("no rs274: install linuxcnc-uspace to let LinuxCNC read the programs")
        return kSkipped
    missed = count = 0
    print(f"{'program':32} motions certified  curve    end   radii    length   (largest, mm)")
    for short, full in programs(corpus):
        try:
            text, certified = compiled(dgt, full, "linuxcnc")
            if text is None:
                print(f"{short:32} not for this dialect")
                continue
            count += 1
            r = check(path_of(dgt, full), text, certified)
            length = r.cut - r.path["length"]["cut"]
            print(f"{short:32} {r.motions:7} {certified:9.4f} {r.deviation:.5f} {r.end_error:.5f} "
                  f"{r.mismatch:.5f} {length:+9.6f}")
        except (Mismatch, rs274.Refused) as fault:
            missed += 1
            print(f"{short:32} MISS: {fault}")
    print(f"{count} programs read by LinuxCNC, {missed} disagree")
    return 1 if missed or not count else 0


if __name__ == "__main__":
    sys.exit(main())
