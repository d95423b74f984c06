#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spoils programs block by block and holds that linuxcnc_reads.py misses none of the faults.

    linuxcnc_sees_faults.py DGT CORPUS

Each spoiled text differs from what the compiler wrote in one thing. Exit 1 when one passes, 77
when there is no LinuxCNC.
"""
import os
import re
import shutil
import sys

import linuxcnc_reads as reads
import rs274


def changed_word(block, letter, change):
    return re.sub(rf"(?<={letter})-?[\d.]+", lambda m: f"{float(m[0]) + change:.3f}", block)


def swapped(block, a, b):
    return block.replace(a, "?").replace(b, a).replace("?", b)


def spoilings(blocks, k):
    """What can be spoiled at block k: a name and the blocks in its place."""
    block = blocks[k]
    if re.match(r"G0[0-3]", block):
        yield "left out", []
        for letter in "XYZ":
            if letter in block:
                # Beyond the half unit by which the writer rounds, wherever it rounded to.
                yield f"{letter} off by two units", [changed_word(block, letter, 0.002)]
    if re.match(r"G0[01]", block):
        yield "rapid for cut", [swapped(block, "G00", "G01")]
    if re.match(r"G0[23]", block):
        yield "wrong sense", [swapped(block, "G02", "G03")]
        yield "chord for arc", ["G01" + re.sub(r" [IJ]-?[\d.]+", "", block[3:])]
        for letter in "IJ":
            yield f"{letter} off by 0.1", [changed_word(block, letter, 0.1)]
        yield "centre mirrored", [changed_sign(block)]
    if "F" in block:
        yield "feed", [changed_word(block, "F", 1)]
    if block in ("M07", "M08", "M0", "M1", "M3", "M5") or block.startswith(("G04", "S")):
        yield "left out", []
        yield "said twice", [block, block]
        if k + 1 < len(blocks):
            yield "after the next", None
    if block.startswith("G04"):
        yield "dwell", [changed_word(block, "P", 0.01)]
    if block == "M02":
        yield "left out", []


def changed_sign(block):
    return re.sub(r"(?<=[IJ])-?[\d.]+", lambda m: f"{-float(m[0]):.3f}", block)


def spoiled_texts(text):
    blocks = text.splitlines()
    for k, block in enumerate(blocks):
        for name, instead in spoilings(blocks, k):
            if instead is None:
                new = blocks[:k] + [blocks[k + 1], block] + blocks[k + 2:]
            else:
                new = blocks[:k] + instead + blocks[k + 1:]
            yield f"block {k + 1} `{block}`: {name}", "\n".join(new) + "\n"


# Between them: lines, arcs both ways, full circles, rapids, codes, dwells, feeds, heights.
kPrograms = ["1P", "5P", "rows/contour_f", "rows/contour_g", "rows/contour_m", "rows/contour_s",
             "rows/contour_t", "rows/contour_z"]


def main():
    dgt, corpus = sys.argv[1:]
    if shutil.which("rs274") is None:
        print("no rs274: install linuxcnc-uspace")
        return reads.kSkipped
    passed = count = 0
    for short in kPrograms:
        full = os.path.join(corpus, short + ".bgt")
        path = reads.path_of(dgt, full)
        text, certified = reads.compiled(dgt, full, "linuxcnc")
        reads.check(path, text, certified)
        for what, spoiled in spoiled_texts(text):
            count += 1
            try:
                reads.check(path, spoiled, certified)
            except (reads.Mismatch, rs274.Refused):
                continue
            passed += 1
            print(f"{short}: not seen: {what}")
    print(f"{count} faults, {passed} not seen")
    return 1 if passed or not count else 0


if __name__ == "__main__":
    sys.exit(main())
