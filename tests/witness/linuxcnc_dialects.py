#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets LinuxCNC read what is written for GRBL and for wire machines of Fanuc's kind.

    linuxcnc_dialects.py DGT CORPUS

There is no interpreter of theirs to ask; G-code is common ground, and LinuxCNC's interpreter reads
most of it. Each program of the corpus is walked along its path as in linuxcnc_reads.py: motions,
ends, curves, feeds, the places of torch and codes.

grbl: read as it stands. Beside that each block is held against what GRBL 1.1 takes, from its
documentation: its words, lines of 79 characters, and its rule for arcs, that the two radii differ
by no more than 0.005 mm, or else by no more than 0.5 mm and a thousandth of the radius. The radii
are calculated here from the numbers in the text.

fanuc-wire: what LinuxCNC cannot read is said in its words first, so that the places are held and the
words are not: M60 and M50 (the wire) become M07 and M08, the dwell G04 X becomes G04 P, and a program
without a feed gets one. G92 has to be where the path starts, and LinuxCNC goes there. Not read: what
M60, M50 and D1 do on a machine, and G41 D1, which LinuxCNC enters in another way.

Then blocks are spoiled, and each has to be noticed. Exit 1 on a disagreement, 77 when there is no
LinuxCNC.
"""
import math
import re
import shutil
import sys

import linuxcnc_offsets
import linuxcnc_reads as reads
import rs274

kSkipped = 77
kGrblWord = re.compile(r"G(?:0|1|2|3|4|17|20|21|90|91|93|94)|M(?:0|1|2|3|4|5|7|8|9|30)|"
                       r"[FIJKNPRSTXYZ]-?\d+(?:\.\d+)?")
kGrblLine = 79
kGrblRadius, kGrblMostRadius, kGrblPart = 0.005, 0.5, 0.001  # mm, mm, of the radius


class Reading(reads.Reading):
    """A torch of these dialects is switched by `on` and `off`, canonical calls in their order."""

    def __init__(self, path, calls, certified, dialect):
        super().__init__(path, calls, certified)
        codes = {reads.plain(m["code"]) for m in path["moves"] if m["kind"] == "code"}
        self.switches_torch = not codes & dialect.torch_codes
        self.dialect = dialect

    def switch_torch(self, on, what):
        if not self.switches_torch or on == self.torch:
            return
        for name in self.dialect.on if on else self.dialect.off:
            self.expect(name, f"torch before {what}")
        self.torch = on

    def say_code(self, code, what):
        for codes, names in ((self.dialect.on_codes, self.dialect.on),
                             (self.dialect.off_codes, self.dialect.off)):
            if code in codes:
                for name in names:
                    self.expect(name, f"{what} {code}")
                return
        super().say_code(code, what)


class Grbl:
    name = "grbl"
    on, off = ("SET_SPINDLE_SPEED", "START_SPINDLE_CLOCKWISE"), ("STOP_SPINDLE_TURNING", )
    torch_codes = {"M3", "M4", "M5", "M7", "M8", "53", "54"}
    on_codes, off_codes = {"M7", "53"}, {"M8", "54"}

    @staticmethod
    def for_linuxcnc(text, _path):
        return text

    @staticmethod
    def check_text(text):
        """GRBL's own rules; returns the largest difference of two radii."""
        at, largest = (0.0, 0.0), 0.0
        for number, line in enumerate(text.splitlines(), 1):
            words = line.split()
            if len(line) > kGrblLine or not all(kGrblWord.fullmatch(word) for word in words):
                raise reads.Mismatch(f"block {number} `{line}`: not for GRBL")
            value = {word[0]: float(word[1:]) for word in words}
            to = (value.get("X", at[0]), value.get("Y", at[1]))
            if words and words[0] in ("G2", "G3"):
                centre = (at[0] + value.get("I", 0), at[1] + value.get("J", 0))
                radius = math.dist(at, centre)
                off = abs(math.dist(to, centre) - radius)
                largest = max(largest, off)
                if off > kGrblRadius and (off > kGrblMostRadius or off > kGrblPart * radius):
                    raise reads.Mismatch(f"block {number} `{line}`: radii differ by {off:.6f} mm")
            if words and words[0] in ("G0", "G1", "G2", "G3"):
                at = to
        return largest


class FanucWire:
    name = "fanuc-wire"
    on, off = ("MIST_ON", ), ("FLOOD_ON", )
    torch_codes = {"M60", "M50", "M3", "M4", "M5", "M7", "M8", "53", "54"}
    on_codes, off_codes = {"M60", "M3", "M4", "M7", "53"}, {"M50", "M5", "M8", "54"}

    @staticmethod
    def for_linuxcnc(text, path):
        x, y = path["start"]
        lines = text.splitlines()
        frame = re.fullmatch(r"G92 X(-?[\d.]+) Y(-?[\d.]+)", lines[2])
        if lines[0] != "%" or not frame or math.dist((float(frame[1]), float(frame[2])),
                                                     (x, y)) > reads.kHalfUnit * math.sqrt(2):
            raise reads.Mismatch(f"the path starts at X{x} Y{y}, the program says {lines[2]}")
        said = {"M60": "M07", "M50": "M08"}
        lines = [said.get(line, re.sub(r"^G04 X", "G04 P", line)) for line in lines]
        # The tool of LinuxCNC is not where the wire is threaded: it is brought there.
        lines[2] = f"F{reads.kDefaultFeed:g}"
        if path["moves"]:
            lines[2] += f"\nG00 X{frame[1]} Y{frame[2]}"
        return "\n".join(lines) + "\n"

    @staticmethod
    def check_text(_text):
        return 0.0


def check(path, text, certified, dialect):
    radii = dialect.check_text(text)
    calls = linuxcnc_offsets.calls_of(dialect.for_linuxcnc(text, path))
    reading = Reading(path, calls, certified, dialect)
    reading.run()
    return reading, radii


def spoilings(text):
    lines = text.splitlines()
    for k, line in enumerate(lines):
        for letter in "XY":
            word = re.search(rf"(?<![A-Z]){letter}(-?[\d.]+)", line)
            if word and not line.startswith("G04"):
                changed = line[:word.start(1)] + f"{float(word[1]) + 0.002:.3f}" + line[word.end(1):]
                yield f"{line} {letter}", "\n".join(lines[:k] + [changed] + lines[k + 1:]) + "\n"
        if re.search(r"[IJ]", line):
            turned = re.sub(r"[IJ]-?[\d.]+", lambda m: f"{m[0][0]}{-float(m[0][1:]):.3f}", line)
            if turned != line:
                yield f"{line} centre", "\n".join(lines[:k] + [turned] + lines[k + 1:]) + "\n"
        if line in ("M60", "M50", "M3", "M5"):
            yield f"{line} left out", "\n".join(lines[:k] + lines[k + 1:]) + "\n"


def unnoticed(path, text, certified, dialect):
    tried, missed = 0, []
    for what, spoiled in spoilings(text):
        tried += 1
        try:
            check(path, spoiled, certified, dialect)
            missed.append(what)
        except (reads.Mismatch, rs274.Refused):
            pass
    return tried, missed


def main():
    dgt, corpus = sys.argv[1:]
    if shutil.which("rs274") is None:
        print("no rs274: install linuxcnc-uspace to let LinuxCNC read the programs")
        return kSkipped
    missed = total = 0
    for dialect in (Grbl, FanucWire):
        count = tried = refused = 0
        curve = radii = 0.0
        for short, full in reads.programs(corpus):
            try:
                text, certified = reads.compiled(dgt, full, dialect.name)
                if text is None:
                    refused += 1
                    continue
                count += 1
                path = reads.path_of(dgt, full)
                reading, mismatch = check(path, text, certified, dialect)
                curve = max(curve, reading.deviation)
                radii = max(radii, mismatch, reading.mismatch)
                if short in ("1P.bgt", "kvad-square.bgt", "rows/contour_t.bgt"):
                    more, through = unnoticed(path, text, certified, dialect)
                    tried += more
                    missed += len(through)
                    for what in through:
                        print(f"{dialect.name} {short}: NOT NOTICED: {what}")
            except (reads.Mismatch, rs274.Refused) as fault:
                missed += 1
                print(f"{dialect.name} {short}: MISS: {fault}")
        total += count
        print(f"{dialect.name}: {count} programs, {refused} not for it; curves at most {curve:.5f} mm "
              f"off, radii differ by at most {radii:.5f} mm; {tried} spoiled blocks")
    print(f"{missed} disagree")
    return 1 if missed or not total else 0


if __name__ == "__main__":
    sys.exit(main())
