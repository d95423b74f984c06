# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a correct DGT program and runs it: variables, texts, loops, macros, definition files.

Knows only correct programs; anything else is a ProgramFault without ceremony.
"""
import os
import re

import geometry as g
from contour import ContourRun, Tool
from definitions import Frame, define

NUMBER = re.compile(r"([+-]*)(N(\d+)|\d+\.?\d*|\.\d+)")
COMPARISON = {"X>": 3, "Y>": 4, "X<": 5, "Y<": 6}


class ProgramFault(Exception):
    pass


class Program:
    def __init__(self, offset_side="auto"):
        self.variables = {}
        self.texts = {}
        self.elements = {}
        self.offset_side = offset_side
        self.tool = Tool()
        self.contours = []
        self.contour = None
        self.folder = "."

    # --- the text ---

    def run_file(self, name):
        self.folder = os.path.dirname(os.path.abspath(name))
        self.run_lines(read_lines(name))
        self.close_contour()

    def run_lines(self, lines, definitions_only=False):
        at = 0
        while at < len(lines):
            number, line = lines[at]
            if line.upper().startswith("FOR"):
                end = matching_next(lines, at)
                count = Scanner(squeeze(line)[3:], self).number()
                for _ in range(int(count)):
                    self.run_lines(lines[at + 1 : end], definitions_only)
                at = end + 1
                continue
            try:
                self.run_line(line, definitions_only)
            except (g.NoSolution, ProgramFault, KeyError, IndexError) as fault:
                raise ProgramFault(f"line {number}: {line}: {fault!r}") from fault
            at += 1

    def run_line(self, line, definitions_only):
        pragma = re.match(r"\s*'@\s*offset-side\s+(\w+)", line)
        if pragma:
            self.offset_side = pragma.group(1)
        line = without_comment(line)
        text = squeeze(line)
        if not text:
            return
        word = line.split()[0].upper()
        if definitions_only and not re.match(r"[LCPO]\d+=", text):
            raise ProgramFault("not a definition")
        if word == "MAC":
            self.close_contour()
            self.run_macro(line.split(None, 2))
        elif word == "OPR":
            self.close_contour()
            self.run_lines(read_lines(self.find(line.split()[1], [""], [".bgt"])), True)
        elif re.match(r"N\d+=", text):
            self.assign(text)
        elif re.match(r"B\d+=", text):
            name, value = text.split("=", 1)
            self.texts[name] = value.strip('"')
        elif re.match(r"[LCPO][N\d]+=", text):
            self.close_contour()
            self.define(text)
        elif text[0] == "K":
            self.close_contour()
            head = re.match(r"K(\d+)=?", text)
            self.contour = ContourRun(int(head.group(1)), self.tool, self.offset_side)
            self.contour_items(text[head.end() :])
        elif self.contour and "," in text:
            self.contour_items(text)
        else:
            self.close_contour()
            self.plain_words(text)

    def close_contour(self):
        if self.contour:
            done = self.contour.finish()
            self.contours += [done] if done else []
            self.contour = None

    # --- statements ---

    def assign(self, text):
        name, expression = text.split("=", 1)
        scanner = Scanner(expression, self)
        value = scanner.number()
        while not scanner.done():
            operator = scanner.take()
            operand = scanner.number()
            value = {"+": lambda a, b: a + b, "-": lambda a, b: a - b,
                     "*": lambda a, b: a * b, "/": lambda a, b: a / b}[operator](value, operand)
        self.variables[int(name[1:])] = value

    def define(self, text):
        name, right = text.split("=", 1)
        head = Scanner(name, self)
        kind = head.take()
        operands, selector = [], 1
        for letter, value in pair_points(Scanner(right, self).items()):
            if letter == "I":
                selector = int(value)
            elif letter in "LCP":
                operands.append((letter, self.look_up(letter, value)))
            else:
                operands.append(("P" if letter == "XY" else letter, value))
        self.elements[kind, int(head.number())] = define(kind, operands, selector)

    def look_up(self, letter, number):
        """An element by its number; the number is text, since -0 reverses as well."""
        reverse, plain = number.startswith("-"), number.lstrip("-")
        found = self.elements[letter, int(float(plain))]
        return found.reversed() if reverse else found

    def run_macro(self, words):
        arguments = squeeze(words[2]) if len(words) > 2 else ""
        values = [Scanner(a, self).number() for a in arguments.split(",")[:-1]]
        self.variables.update(enumerate(values, start=1))
        self.run_lines(read_lines(self.find(words[1], ["", "mac"], [".mac", ".bgt"])))
        self.close_contour()

    def find(self, name, folders, extensions):
        for folder in (os.path.join(self.folder, f) for f in folders):
            for extension in extensions:
                for entry in sorted(os.listdir(folder)) if os.path.isdir(folder) else []:
                    if entry.lower() == (name + extension).lower():
                        return os.path.join(folder, entry)
        raise ProgramFault(f"no file for {name}")

    def plain_words(self, text):
        rapid = False
        for letter, value in pair_points(Scanner(text, self).items()):
            if letter == "G" and value == 54:
                rapid = "thread"
            elif letter == "G":
                rapid = True
            elif letter == "P":
                self.tool.straight(self.look_up("P", value), "position", rapid=rapid)
            elif letter == "XY" and rapid == "thread":
                self.tool.thread(value)
            elif letter == "XY":
                self.tool.straight(value, "position", rapid=rapid)
            else:
                self.tool.word(letter, value)

    def contour_items(self, text):
        for letter, value in pair_points(Scanner(text, self).items()):
            if letter in "LCP" and value is not None:
                self.contour.item(letter, self.look_up(letter, value))
            elif letter == "O":
                number = int(value)
                frame = self.elements["O", number] if number else Frame()
                self.contour.item("O", frame)
            else:
                self.contour.item(letter, value)


class Scanner:
    """Letters with their numbers, one after the other."""

    def __init__(self, text, program):
        self.text, self.at, self.program = text, 0, program

    def done(self):
        return self.at >= len(self.text)

    def take(self):
        self.at += 1
        return self.text[self.at - 1]

    def number_text(self):
        """The next number as text, variables put in; None where none stands."""
        found = NUMBER.match(self.text, self.at)
        if not found:
            return None
        self.at = found.end()
        value = found.group(2)
        if found.group(3):
            value = repr(self.program.variables.get(int(found.group(3)), 0.0))
        sign = "-" if (found.group(1).count("-") + value.startswith("-")) % 2 else ""
        return sign + value.lstrip("-")

    def number(self):
        return float(self.number_text())

    def items(self):
        while not self.done():
            letter = self.take()
            if letter == ",":
                continue
            if letter == "B":
                text = self.program.texts["B" + self.number_text()]
                yield from Scanner(text, self.program).items()
            elif self.text[self.at - 1 : self.at + 1] in COMPARISON:
                self.at += 1
                yield "I", COMPARISON[self.text[self.at - 2 : self.at]]
            else:
                value = self.number_text()
                if value is not None and letter not in "LCP":
                    value = float(value)
                yield letter, value


def pair_points(items):
    """X and Y that follow each other become one XY."""
    x = None
    for letter, value in items:
        if x is not None:
            if letter == "Y":
                yield "XY", complex(x, value)
                x = None
                continue
            yield "X", x
            x = None
        if letter == "X":
            x = value
        else:
            yield letter, value
    if x is not None:
        yield "X", x


def read_lines(name):
    with open(name, encoding="utf-8-sig") as file:
        return [(n, line.rstrip("\r\n")) for n, line in enumerate(file.read().split("\n"), 1)]


def without_comment(line):
    return line.split("'", 1)[0]


def squeeze(line):
    return re.sub(r"\s", "", without_comment(line)).upper()


def matching_next(lines, at):
    depth = 0
    for k in range(at, len(lines)):
        word = squeeze(lines[k][1])
        depth += word.startswith("FOR")
        depth -= word == "NEXT"
        if depth == 0:
            return k
    raise ProgramFault("FOR without NEXT")
