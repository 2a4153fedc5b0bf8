# SPDX-License-Identifier: MIT-0
"""LinuxCNC's stand-alone interpreter `rs274 -g`: canonical calls as text, with four decimals.

The units of its lengths follow the program's G20 and G21. It gives no line numbers.
"""
import os
import re
import subprocess
import sys
import tempfile
from decimal import Decimal

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import linuxcnc_shared as linuxcnc  # noqa: E402
from gonogo_pipe import Subject, alarm, error, serve, skip  # noqa: E402
from rs274_profile import one_of, refusal  # noqa: E402

# A count, the program's own N word (not a line number), the call.
CALL = re.compile(r"^\s*\d+\s+N(?:\.*|\d*)\s*([A-Z]\w*)\((.*)\)\s*$")
PLANES = {"CANON_PLANE_XY": ("G17", "xyz"), "CANON_PLANE_XZ": ("G18", "zxy"),
          "CANON_PLANE_YZ": ("G19", "yzx")}
HALF_A_DIGIT = Decimal("0.00005")
UNITS = {"CANON_UNITS_MM": Decimal(1), "CANON_UNITS_INCHES": Decimal("25.4")}


class Unsupported(Exception):
    """A motion that no record can carry."""


class Calls:
    """Turns canonical calls into records."""

    def __init__(self, emit):
        self.emit = emit
        self.scale, self.feed, self.per_turn = Decimal(1), Decimal(0), False
        self.rotary_feed = Decimal(0)
        self.at, self.slack = [Decimal(0)] * 3, Decimal(0)
        self.plane = PLANES["CANON_PLANE_XY"]

    def take(self, line):
        call = CALL.match(line)
        handler = getattr(self, call.group(1).lower(), None) if call else None
        if handler:
            handler(*[part.strip() for part in call.group(2).split(",")])

    def use_length_units(self, units):
        # Where the tool stands is printed in the new units from here on; it was rounded in the old.
        factor, self.scale = self.scale / UNITS[units], UNITS[units]
        self.at = [word * factor for word in self.at]
        self.slack = HALF_A_DIGIT * (factor + 1) if factor != 1 else self.slack

    def select_plane(self, plane):
        if plane not in PLANES:
            raise Unsupported("The plane %s has no place in a record." % plane)
        self.plane = PLANES[plane]

    def set_feed_rate(self, feed):
        # A feed of degrees has no unit of length.
        self.rotary_feed, self.feed = Decimal(feed), Decimal(feed) * self.scale

    def set_feed_mode(self, _spindle, mode):
        self.per_turn = mode == "1"

    def dwell(self, seconds):
        self.emit("dwell", s=Decimal(seconds))

    def straight_traverse(self, *words):
        self.emit("rapid", to=self._position("xyz", words[:3], words[3:]))

    def straight_feed(self, *words):
        turns_only = all(abs(Decimal(word) - at) <= self.slack
                         for word, at in zip(words, self.at))
        self.emit("feed", to=self._position("xyz", words[:3], words[3:]),
                  **self._feeds(turns_only))

    def arc_feed(self, end1, end2, centre1, centre2, turn, axial, *rotary):
        plane, axes = self.plane
        centre = {axis: Decimal(word) * self.scale
                  for axis, word in zip(axes, (centre1, centre2))}
        self.emit("arc", to=self._position(axes, (end1, end2, axial), rotary), plane=plane,
                  c=centre, rot=int(turn), **self._feeds())

    def _feeds(self, turns_only=False):
        return {"f": self.rotary_feed if turns_only else self.feed,
                "fm": "rev" if self.per_turn else None}

    def _position(self, axes, words, rotary):
        a, b, c = (Decimal(word) for word in rotary[:3])
        if b:
            raise Unsupported("The axis B has no place in a record.")
        place = {axis: Decimal(word) for axis, word in zip(axes, words)}
        self.at, self.slack = [place[axis] for axis in "xyz"], Decimal(0)
        to = {axis: word * self.scale for axis, word in place.items()}
        return {**to, "a": a, "c": c}


class LinuxcncRs274(Subject):
    name = "linuxcnc-rs274"
    version = linuxcnc.version()
    dialects = {"rs274": linuxcnc.FEATURES}
    features = ["bytes"]
    numeric = {"kind": "fixed", "resolution": "0.0001", "feed_resolution": "0.0001"}

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory(prefix="gonogo-rs274-")

    def configure(self, dialect, profile):
        self.flags = ["-b"] if profile.get("block_skip") else []
        return refusal(dialect, profile, {
            **linuxcnc.READINGS, "block_skip": one_of(False, True),
            "resolution": lambda value: Decimal(str(value)) >= Decimal("0.0001"),
        })

    def run(self, program, emit):
        with open(os.path.join(self.folder.name, "program.ngc"), "wb") as file:
            file.write(program)
        calls = Calls(emit)
        with tempfile.TemporaryFile() as complaints:
            with subprocess.Popen(["rs274", *self.flags, "-g", "program.ngc"],
                                  cwd=self.folder.name, env=linuxcnc.home(self.folder.name),
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                  stderr=complaints) as process:
                try:
                    for line in process.stdout:
                        calls.take(line.decode("utf-8", "replace"))
                except Unsupported as reason:
                    process.kill()
                    return skip("axes", str(reason))
            complaints.seek(0)
            said = complaints.read().decode("utf-8", "replace").splitlines()
        return _outcome(process.returncode, [line for line in said if line != "executing"])


def _outcome(code, said):
    if code == 0:
        return None
    if code != 1 or not said:
        return error("rs274 ended with %d: %s" % (code, " | ".join(said)))
    # The message, and then the block that it is about.
    return alarm(said[0], linuxcnc.class_of(said[0]))


if __name__ == "__main__":
    serve(LinuxcncRs274)
