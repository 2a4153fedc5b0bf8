# SPDX-License-Identifier: MIT-0
"""A subject in Python. It computes in fractions, so nothing is rounded. It expands straight lines of
RS274: G0 and G1 with X, Y and Z, F, G20 and G21, G90 and G91, M2 and M30; the rest it skips."""
import re
from fractions import Fraction

from gonogo_pipe import Subject, alarm, serve, skip

WORD = re.compile(rb"([A-Z])([-+]?(?:\d+\.?\d*|\.\d+))")
GROUPS = {0: "motion", 1: "motion", 20: "unit", 21: "unit", 90: "distance", 91: "distance"}


class Alarm(Exception):
    def __init__(self, cls, word):
        super().__init__(cls)
        self.cls, self.word = cls, word


class NotSupported(Exception):
    pass


def words_of(line):
    """The words of one line as (letter, number), blanks dropped and in upper case."""
    text, at, words = re.sub(rb"[ \t]", b"", line).upper(), 0, []
    while at < len(text):
        word = WORD.match(text, at)
        is_read = word and word[1] in b"NGXYZFM" and (word[1] != b"N" or word[2].isdigit())
        if not is_read:
            raise NotSupported(text[at:at + 1].decode("latin-1"))
        words.append((word[1].decode(), Fraction(word[2].decode())))
        at = word.end()
    return words


class Acme(Subject):
    name, version = "acme-python", "1.0.0"
    dialects = None  # a part of "basic" only: nothing is declared, and what is skipped is not claimed
    features = ["blocks", "bytes"]
    numeric = {"kind": "exact"}

    def run(self, program, emit):
        self.modes = {"motion": None, "unit": 21, "distance": 90}
        self.at, self.feed = {}, Fraction(0)
        lines = re.split(rb"\r\n|\r|\n", program)
        for b, line in enumerate(lines, 1):
            try:
                if self.block(line, b, emit):
                    return None
            except Alarm as found:
                return alarm(found.cls, cls=found.cls, b=b, word=found.word)
            except NotSupported as missing:
                return skip(str(missing), "This example reads straight lines only.")
        last = max(1, len(lines) - (lines[-1] == b""))  # a line feed ends a line and begins none
        return alarm("program-end", cls="program-end", b=last)

    def block(self, line, b, emit):
        """Executes one line; true at the end of the program."""
        values, groups = {}, set()
        feed_unit = self.unit()  # F counts in the unit before the block
        for letter, number in words_of(line):
            seen = values
            if letter == "G":
                if number not in GROUPS:
                    raise NotSupported("G%g" % number)
                seen, key = groups, GROUPS[number]
                self.modes[key] = int(number)
            else:
                key = letter
            if letter == "M" and number not in (2, 30) or letter == "N" and (values or groups):
                raise NotSupported(letter)
            if key in seen:
                raise Alarm("duplicate-word", letter)
            seen.add(key) if seen is groups else seen.update({key: number})
        if "F" in values:
            self.feed = values["F"] * feed_unit
        if self.feed < 0:
            raise Alarm("value-sign", "F")
        axes = {k: v for k, v in values.items() if k in "XYZ"}
        if axes or "motion" in groups:
            self.move(axes, b, emit)
        return "M" in values

    def unit(self):
        return Fraction("25.4") if self.modes["unit"] == 20 else 1

    def move(self, axes, b, emit):
        if self.modes["motion"] is None:
            raise Alarm("missing-word", "G")
        if self.modes["motion"] == 1 and self.feed == 0:
            raise Alarm("feed-missing", "F")
        if not axes:
            return
        for axis, way in axes.items():
            begin = self.at.get(axis, 0) if self.modes["distance"] == 91 else 0
            self.at[axis] = begin + way * self.unit()
        to = {axis.lower(): self.at[axis] for axis in axes}
        if self.modes["motion"] == 0:
            emit("rapid", b=b, to=to)
        else:
            emit("feed", b=b, to=to, f=self.feed)


serve(Acme)
