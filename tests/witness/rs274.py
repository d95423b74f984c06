# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs LinuxCNC's interpreter (`rs274 -g`) on a program and reads the canonical calls it prints.

What LinuxCNC understood, not what the text seems to say: positions are absolute millimetres, the
centre of an arc is absolute, the end of a program has been acted upon.
"""
import re
import subprocess
import tempfile


class Refused(Exception):
    """LinuxCNC does not accept the program, or understood what no part program should say."""


class Call:
    """One canonical call: its name, its numbers, and for motions the block it came from."""

    def __init__(self, name, values):
        self.name = name
        self.values = values
        self.block = ""

    @property
    def moves(self):
        return self.name in kMotions

    @property
    def end(self):
        return (self.values[0], self.values[1])

    @property
    def height(self):
        return self.values[5] if self.name == "ARC_FEED" else self.values[2]

    @property
    def centre(self):
        return (self.values[2], self.values[3])

    @property
    def turns(self):
        return self.values[4]


kMotions = ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED")
# What a program may cause besides motions; anything else is a surprise and refused.
kActions = {
    "DWELL", "MIST_ON", "MIST_OFF", "FLOOD_ON", "FLOOD_OFF", "START_SPINDLE_CLOCKWISE",
    "START_SPINDLE_COUNTERCLOCKWISE", "STOP_SPINDLE_TURNING", "SET_SPINDLE_SPEED", "PROGRAM_STOP",
    "OPTIONAL_PROGRAM_STOP", "SET_FEED_RATE", *kMotions
}
kSilent = {"SET_FEED_REFERENCE", "ON_RESET", "COMMENT"}
kAllZero = {"SET_G92_OFFSET", "SET_XY_ROTATION", "SET_FEED_MODE"}  # mode 0: per minute
# Begins what the end of a program sets back.
kEndBegins = "SET_G5X_OFFSET"

kCall = re.compile(r"\s*\d+ N\S+\s+(\w+)\((.*)\)\s*$")
kMotionBlock = re.compile(r"\s*G0?[0-3](?!\d)")
kTimeout = 120  # seconds
kTriesAfterCrash = 3


def canonical_text(text, program="rs274"):
    """What the interpreter prints for the program.

    A run that a signal ended is tried again: interpreters that happen to start together share one
    segment of memory and may crash on it. What LinuxCNC refuses, it refuses with an exit code.
    """
    for _ in range(kTriesAfterCrash):
        done = run_once(text, program)
        if done.returncode >= 0:
            break
    if done.returncode != 0:
        lines = [line for line in done.stderr.splitlines() if line != "executing"]
        raise Refused(f"LinuxCNC: exit {done.returncode}: {' / '.join(lines)}")
    return done.stdout


def run_once(text, program):
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/part.ngc", "w", encoding="ascii") as file:
            file.write(text)
        return subprocess.run([program, "-g", "part.ngc"], cwd=folder, capture_output=True,
                              stdin=subprocess.DEVNULL, text=True, check=False, timeout=kTimeout)


def numbers(inside):
    return [float(word) for word in re.findall(r"[-+]?\d+(?:\.\d+)?", inside)]


def all_calls(printed):
    for line in printed.splitlines():
        match = kCall.match(line)
        if not match:
            raise Refused(f"LinuxCNC printed what the witness cannot read: {line!r}")
        yield match[1], match[2]


def name_blocks(calls, text):
    """Every block with a motion word causes one motion, so they are counted off together."""
    blocks = [(k, line) for k, line in enumerate(text.splitlines(), 1) if kMotionBlock.match(line)]
    motions = [call for call in calls if call.moves]
    if len(blocks) != len(motions):
        raise Refused(f"{len(blocks)} blocks with motions, {len(motions)} motions")
    for call, (number, line) in zip(motions, blocks):
        call.block = f"block {number} `{line.strip()}`"


def read(text):
    """The calls a program causes, in order; without those of LinuxCNC's own begin and end."""
    printed = list(all_calls(canonical_text(text)))
    ends = [k for k, (name, _) in enumerate(printed) if name == kEndBegins]
    if len(ends) != 2 or "PROGRAM_END" not in (name for name, _ in printed[ends[1]:]):
        raise Refused("LinuxCNC saw no end of the program")
    calls = []
    for k, (name, inside) in enumerate(printed):
        if name == "USE_LENGTH_UNITS" and inside != "CANON_UNITS_MM":
            raise Refused(f"units {inside}")
        if name == "SELECT_PLANE" and inside != "CANON_PLANE_XY":
            raise Refused(f"plane {inside}")
        # The first number of SET_G5X_OFFSET is the number of the frame.
        origin = numbers(inside)[1:] if name == kEndBegins else numbers(inside)
        if (name in kAllZero or name == kEndBegins) and any(origin):
            raise Refused(f"{name}({inside})")
        if k > ends[1]:
            if name in kMotions:
                raise Refused("a motion after the end of the program")
        elif name in kActions:
            calls.append(Call(name, numbers(inside)))
        elif name not in kSilent | kAllZero | {kEndBegins, "USE_LENGTH_UNITS", "SELECT_PLANE"}:
            raise Refused(f"LinuxCNC does {name}({inside}), which no program here asks for")
    name_blocks(calls, text)
    return calls
