#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tool path of a DGT program, calculated a second time.

Written from the language's description alone, in plain floats, sharing no line with the program it
checks. Prints the same JSON as `dgt path`. Good to about 1e-10 mm; correct programs only.
"""
import json
import sys

from reader import Program


def path_of(name, offset_side="auto"):
    program = Program(offset_side)
    program.run_file(name)
    start = program.tool.start
    return {"schema": "dgt-path/1", "units": "mm", "start": [start.real, start.imag],
            "contours": program.contours, "moves": program.tool.moves}


if __name__ == "__main__":
    json.dump(path_of(sys.argv[1]), sys.stdout, indent=1)
    print()
