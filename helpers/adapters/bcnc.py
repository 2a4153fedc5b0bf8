# SPDX-License-Identifier: MIT-0
"""bCNC's interpreter (class CNC), as its canvas uses it: one line in, a polyline out.

Arcs are chords within CNC.accuracy. It knows no errors, and draws no dwell. Canned cycles are what
it sends to the machine in their place: lines of G0, G1, G4, M3 and M5, under the modes in force.
"""
import copy
import os
import re
import sys
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
import linuxcnc_shared  # noqa: E402
from gonogo_pipe import Subject, serve  # noqa: E402
from rs274_profile import LOOKED_AT, anything, one_of, refusal  # noqa: E402

HOME = "/usr/share/bcnc/bCNC"
CYCLES = (81, 82, 83, 85, 86, 89)  # as in its own compile()
PLANES = {"G17": 0, "G18": 1, "G19": 2}


def _number(value):
    return float(Fraction(str(value)))


class Bcnc(Subject):
    name = "bcnc"
    version = linuxcnc_shared.version("bcnc")
    dialects = {"rs274": ["basic", "arc", "arc-r", "helix", "planes", "arc-distance", "g81", "g83",
                          "g85", "g86", "cycle-modal", "cycle-steps"]}
    features = ["blocks"]  # it is given one line at a time
    readings = LOOKED_AT + ["ngc.cycle.initial", "ngc.cycle.retract-start", "ngc.g83.return"]
    numeric = {"kind": "binary64", "chord": "0.01"}

    def __init__(self):
        sys.path[:0] = [HOME, os.path.join(HOME, "lib"), os.path.dirname(HOME)]
        import CNC
        self.module = CNC
        self.evaluate = CNC.GCode().evaluate

    def configure(self, dialect, profile):
        initial = profile.get("initial", {})
        self.at = [_number(initial.get(axis, 0)) for axis in "xyz"]
        self.feed = _number(initial.get("f", 0))
        self.plane = PLANES.get(initial.get("plane", "G17"))
        self.inch = profile.get("units") == "inch"
        return refusal(dialect, profile, {
            "initial.x": anything, "initial.y": anything, "initial.z": anything,
            "initial.f": anything, "initial.plane": one_of(*PLANES), "units": one_of("mm", "inch"),
            "readings.ngc.cycle.initial": one_of("block", "any"),
            "readings.ngc.cycle.retract-start": one_of("initial", "any"),
            "readings.ngc.g83.return": one_of("feed", "any"),
        })

    def run(self, program, emit):
        machine = self.module.CNC()
        machine.initPath(*self.at, 0, 0, 0)
        machine.feed, machine.plane = self.feed, self.plane
        machine.unit = 25.4 if self.inch else 1.0
        self.module.CNC.vars["feedmode"] = 94
        lines = re.split("\r\n|\r|\n", program.decode("utf-8", "replace"))
        for b, line in enumerate(lines, 1):
            words = self.module.CNC.breakLine(self.evaluate(self.module.CNC.compileLine(line)))
            if not words:
                continue
            machine.motionStart(words)
            if machine.gcode in CYCLES:
                self._cycle(machine, b, emit)
            else:
                self._draw(machine, b, emit)
            machine.motionEnd()

    def _cycle(self, machine, b, emit):
        sent = machine.macroGroupG8X()
        follower = copy.copy(machine)
        follower.xval, follower.yval, follower.zval = follower.x, follower.y, follower.z
        for line in sent:
            words = self.module.CNC.breakLine(line)
            follower.motionStart(words)
            if words[0].upper() == "G4":
                emit("dwell", b=b, s=float(follower.pval))
            elif words[0][0].upper() == "G":
                self._draw(follower, b, emit)
                follower.motionEnd()

    def _draw(self, machine, b, emit):
        for x, y, z in machine.motionPath()[1:]:
            to = {"x": float(x), "y": float(y), "z": float(z)}
            if machine.gcode == 0:
                emit("rapid", b=b, to=to)
            else:
                fm = "rev" if self.module.CNC.vars["feedmode"] == 95 else None
                emit("feed", b=b, to=to, f=float(machine.feed), fm=fm)


if __name__ == "__main__":
    serve(Bcnc)
