# SPDX-License-Identifier: MIT-0
"""NIST's stand-alone RS274/NGC interpreter, version 3: `nist_rs274ngc.py PROGRAM`, which you build.

    gonogo certify --subject "pipe:python3 nist_rs274ngc.py /path/to/rs274abc" --dialect rs274

PROGRAM asks on stderr what to do (1 starts), reads `rs274ngc.var` and `rs274ngc.tool_default` where
it runs, and prints canonical calls; an error ends it with exit code 1, a message and the block, M2 and M30
with 1 and no message. M
functions are not claimed: how M2 resets the machine looks the same as M5 and M9.
"""
import os
import re
import subprocess
import sys
import tempfile
from decimal import Decimal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import linuxcnc_shared as messages  # noqa: E402  (its interpreter has the texts of NIST's)
from canonical_calls import Calls, Unsupported  # noqa: E402
from gonogo_pipe import Subject, alarm, error, serve, skip  # noqa: E402
from rs274_profile import one_of, refusal  # noqa: E402

START, BLOCK_DELETE = b"1\n", b"4\n"
# What a parameter file has to hold: two homes, the offset of G92, the system in force and nine of them.
PARAMETERS = sorted([5220] + [first + axis for axis in range(6) for first in
                              (5161, 5181, 5211, *range(5221, 5400, 20))])


class NistCalls(Calls):
    def set_origin_offsets(self, *words):
        self._offset("system", words)

    def use_tool_length_offset(self, length):
        self._offset("tool", ["0", "0", length])

    def _go(self, axes, words, rotary):
        if len(rotary) == 2:
            raise Unsupported("It does not say which two rotary axes it has.")
        return super()._go(axes, words, [*rotary, "0", "0", "0"][:3])


class NistRs274ngc(Subject):
    name = "nist-rs274ngc"
    version = "3"
    dialects = {"rs274": ["basic", "arc", "arc-r", "helix", "planes", "lines", "g81", "g83", "g84",
                          "g85", "g86", "cycle-modal", "cycle-steps", "cycle-planes", "rotary"]}
    features = ["bytes"]
    numeric = {"kind": "fixed", "resolution": "0.0001", "feed_resolution": "0.0001"}
    followed = {
        "arc-tolerance": "nist", "full-circle-words": "free", "whole": "nist",
        "g80-beside": "alarm", "unused-words": "alarm", "line-number": "whole",
        "o-name": "syntax", "program-end": "needed", "bare-motion": "missing-word",
        "arc-words-alone": "alarm", "cycle.initial": "block", "cycle.g91-r": "current",
        "cycle.sticky": "number", "cycle.approach": "current-level",
        "cycle.retract-start": "r-plane", "cycle.feed": "free", "cycle.alarm-at": "late",
        "cycle.alarm-at-q": "block",
        "g83.retract": "clear", "g83.return": "rapid", "peck.clearance": "ten-thou",
        "peck.d": "barred", "peck.dwell": "none", "g85.out": "clear", "tap.p": "barred",
    }
    readings = ["ngc." + name for name in followed]

    def __init__(self):
        if len(sys.argv) != 2:
            sys.exit("usage: nist_rs274ngc.py PROGRAM")
        self.program = os.path.abspath(sys.argv[1])
        self.folder = tempfile.TemporaryDirectory(prefix="gonogo-nist-")

    def configure(self, dialect, profile):
        self.answers = (BLOCK_DELETE if profile.get("block_skip") else b"") + START
        return refusal(dialect, profile, {
            **{"readings.ngc." + name: one_of(value, "any")
               for name, value in self.followed.items()},
            "block_skip": one_of(False, True),
            "resolution": lambda value: Decimal(str(value)) >= Decimal("0.0001"),
        })

    def run(self, program, emit):
        self._write("program.ngc", program)
        # What a program leaves in the parameters would be the next one's start.
        self._write("rs274ngc.var", "".join("%d\t%d.0\n" % (number, number == 5220)
                                            for number in PARAMETERS).encode())
        self._write("rs274ngc.tool_default", b"slot id length diameter\n\n1 1 0.0 0.0\n")
        calls = NistCalls(lambda kind, **fields: kind != "m" and emit(kind, **fields))
        done = subprocess.run([self.program, "program.ngc"], cwd=self.folder.name, check=False,
                              input=self.answers, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        try:
            calls.take(done.stdout.decode("utf-8", "replace").splitlines())
        except Unsupported as reason:
            return skip("records", str(reason))
        # Before this word stands what it asked.
        said = done.stderr.decode("utf-8", "replace").partition("executing\n")[2].splitlines()
        if done.returncode == 1 and said:
            return alarm(said[0], self._class_of(said[0], calls.turning))
        if done.returncode != 0 and not (done.returncode == 1 and calls.ended):
            return error("%s ended with %d: %s" % (self.program, done.returncode, " | ".join(said)))
        return None

    @staticmethod
    def _class_of(message, turning):
        # It says the same of a spindle that stands and of one that turns the other way.
        if re.search("not turning (counter)?clockwise in", message):
            return "spindle-stopped" if turning == 5 else "direction-conflict"
        return messages.class_of(message)

    def _write(self, name, content):
        with open(os.path.join(self.folder.name, name), "wb") as file:
            file.write(content)


if __name__ == "__main__":
    serve(NistRs274ngc)
