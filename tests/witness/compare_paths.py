#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Holds `dgt path` against the independent calculation, program by program.

    compare_paths.py DGT CORPUS

Every program of the corpus must agree with the witness within kWitness, and with the tables in
CORPUS/expected, where one exists, within kTable (they carry nine decimals). Prints the largest
difference of each program; exit 1 when one disagrees.
"""
import json
import math
import os
import subprocess
import sys

from dgt_witness import path_of
from geometry import NoSolution
from reader import ProgramFault

kWitness = 1e-9  # mm, and degrees of sweep
kTable = 1e-8


class Mismatch(Exception):
    pass


def number_difference(a, b, where, tolerance):
    if abs(a - b) > tolerance:
        raise Mismatch(f"{where}: {a!r} and {b!r}")
    return abs(a - b)


def move_difference(ours, other, where, tolerance, keys):
    worst = 0.0
    for key in keys:
        if key not in ours and key not in other:
            continue
        a, b = ours.get(key), other.get(key)
        if isinstance(a, list) and isinstance(b, list):
            for u, v in zip(a, b):
                worst = max(worst, number_difference(u, v, f"{where} {key}", tolerance))
        elif isinstance(a, float) and isinstance(b, (int, float)) and not isinstance(b, bool):
            # Tables round the sweep to six decimals of a degree.
            loose = 1e-6 if key == "sweep" and tolerance == kTable else tolerance
            difference = number_difference(a, b, f"{where} {key}", loose)
            worst = max(worst, 0.0 if key == "sweep" else difference)
        elif a != b:
            raise Mismatch(f"{where} {key}: {a!r} and {b!r}")
    return worst


GEOMETRY = ["kind", "from", "to", "center", "radius", "ccw", "sweep"]
EVERYTHING = GEOMETRY + ["z", "seconds", "code", "role"]


def moves_difference(ours, other, where, tolerance, keys):
    worst = 0.0
    for k, (a, b) in enumerate(zip(ours, other), start=1):
        feed = ["feed"] if keys is EVERYTHING and a["kind"] in ("line", "arc") else []
        worst = max(worst, move_difference(a, b, f"{where} move {k}", tolerance, keys + feed))
    if len(ours) != len(other):
        raise Mismatch(f"{where}: {len(ours)} and {len(other)} moves")
    return worst


def path_difference(ours, other, tolerance, keys):
    if len(ours["contours"]) != len(other["contours"]):
        raise Mismatch("number of contours")
    worst = 0.0
    for a, b in zip(ours["contours"], other["contours"]):
        where = f"K{a['id']}"
        for key in ("id", "side", "closed"):
            if key in b and a[key] != b[key]:
                raise Mismatch(f"{where} {key}: {a[key]!r} and {b[key]!r}")
        number_difference(a["offset"], b["offset"], f"{where} offset", tolerance)
        for key in ("programmed", "moves"):
            worst = max(worst, moves_difference(a[key], b[key], f"{where} {key}", tolerance, keys))
    worst = max(worst, moves_difference(ours["moves"], other["moves"], "path", tolerance, keys))
    for a, b in zip(ours["start"], other["start"]):
        number_difference(a, b, "start", tolerance)
    return worst


def check_length(path):
    """The printed lengths against the moves they sum up (flat moves only: z is not followed)."""
    if any("z" in m for m in path["moves"]):
        return
    sums = {"cut": 0.0, "rapid": 0.0}
    for m in path["moves"]:
        if m["kind"] in ("line", "rapid"):
            sums["cut" if m["kind"] == "line" else "rapid"] += math.dist(m["from"], m["to"])
        elif m["kind"] == "arc":
            sums["cut"] += math.radians(abs(m["sweep"])) * m["radius"]
    for key, total in sums.items():
        number_difference(path["length"][key], total, f"length {key}", 1e-7)


def programs(corpus):
    for folder, _, files in sorted(os.walk(corpus)):
        for name in sorted(files):
            full = os.path.join(folder, name)
            if name.endswith(".bgt"):
                yield os.path.relpath(full, corpus), full


def run_dgt(dgt, name):
    done = subprocess.run([dgt, "path", name], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Mismatch(f"dgt: exit {done.returncode}: {done.stderr.strip().splitlines()[:1]}")
    return json.loads(done.stdout)


def check(dgt, corpus, short, full):
    ours = run_dgt(dgt, full)
    check_length(ours)
    witness = path_difference(ours, path_of(full), kWitness, EVERYTHING)
    table = os.path.join(corpus, "expected", short.replace(".bgt", ".json"))
    if not os.path.exists(table):
        return f"{witness:9.1e}"
    with open(table, encoding="utf-8") as file:
        expected = path_difference(ours, json.load(file), kTable, GEOMETRY)
    return f"{witness:9.1e} {expected:9.1e}"


def main():
    dgt, corpus = sys.argv[1:]
    missed = count = 0
    print(f"{'program':32} {'witness':>9} {'table':>9}   largest difference, mm")
    for short, full in programs(corpus):
        count += 1
        try:
            print(f"{short:32} {check(dgt, corpus, short, full)}")
        except (Mismatch, ProgramFault, NoSolution) as fault:
            missed += 1
            print(f"{short:32} MISS: {fault}")
    print(f"{count} programs, {missed} disagree")
    return 1 if missed or not count else 0


if __name__ == "__main__":
    sys.exit(main())
