# SPDX-License-Identifier: GPL-3.0-or-later
"""A subject for the helper's tests: each word of a program makes it do one thing."""
import os
import sys
from decimal import Decimal
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "helpers"))
from gonogo_pipe import Subject, alarm, serve, skip  # noqa: E402


class Sample(Subject):
    name, version = "sample", "1.2"
    dialects = {"rs274": ["basic"]}
    features = ["blocks", "bytes"]

    def __init__(self):
        print("printed while it is made")
        self.kept = 0

    def configure(self, dialect, profile):
        if "break" in profile:
            raise RuntimeError("configure broke")
        return "units" if profile.get("units") == "inch" else None

    def reset(self):
        self.kept = 0

    def run(self, program, emit):
        word, _, rest = program.partition(b" ")
        if word == b"length":
            emit("dwell", s=len(rest))
        elif word == b"sum":
            emit("dwell", s=sum(rest))
        elif word == b"many":
            for i in range(int(rest)):
                emit("rapid", b=i + 1, to={"x": i})
        elif word == b"numbers":
            emit("feed", b=1, f=Fraction(11, 3), fm=None,
                 to={"x": 0.1, "y": Decimal("0.10"), "z": {"root": [0, 1, 2]}, "a": -0.0, "c": 7})
        elif word == b"print":
            emit("rapid", to={"x": 1})
            print("noise on sys.stdout")
            os.write(1, b"noise on descriptor 1\n")
            os.read(0, 1)
        elif word == b"keep":
            self.kept += 1
            emit("dwell", s=self.kept)
        elif word == b"alarm":
            emit("rapid", b=1, to={"x": 1})
            return alarm("E61", cls="feed-missing", b=2, word="F")
        elif word == b"skip":
            return skip("turns", "no turns here")
        elif word == b"nan":
            emit("rapid", to={"x": float("nan")})
        elif word == b"kind":
            emit("alarm", b=1)
        elif word == b"exit":
            sys.exit(3)
        else:
            emit("rapid", b=1, to={"x": 1})
            raise ValueError("unheard of")
        return None


serve(Sample)
