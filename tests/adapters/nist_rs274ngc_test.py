# SPDX-License-Identifier: GPL-3.0-or-later
"""The adapter of NIST's interpreter, with a stand-in that prints what the interpreter would.

The transcripts are written by hand in the form that its driver has. Nothing is known here of what the
interpreter itself would do.
"""
import os
import sys
import tempfile
import textwrap
import unittest
from fractions import Fraction

from adapter_testing import AdapterCase, python

STAND_IN = """\
#!%s
import os, sys
for line in ("enter a number:", "1 = start interpreting", "2 = choose parameter file ...",
             "3 = read tool file ...", "4 = turn block delete switch ON",
             "5 = adjust error handling..."):
    print(line, file=sys.stderr)
answers = sys.stdin.read().split()
if answers[-1:] != ["1"]:
    sys.exit("it was not started")
numbers = [int(line.split()[0]) for line in open("rs274ngc.var")]
if numbers != sorted(numbers) or 5220 not in numbers or 5386 not in numbers:
    sys.exit("Parameter file out of order")
if "\\n\\n" not in open("rs274ngc.tool_default").read():
    sys.exit("Bad tool file format")
print("enter choice => executing", file=sys.stderr)
# The program tells what to print: comments, one a call, and one of what is said at an error.
count = 0
for line in open(sys.argv[1]):
    mark, _, text = line.strip()[1:-1].partition(" ")
    if mark == "call":
        count += 1
        print("%%5d N..... %%s" %% (count, text))
    elif mark == "named":
        count += 1
        print("%%5d N0010  %%s" %% (count, text))
    elif mark == "answers":
        print("%%5d N..... DWELL(%%d.0000)" %% (count, len(answers)))
    elif mark == "status":
        sys.exit(int(text))
    elif mark == "error":
        print(text, file=sys.stderr)
        print("the block", file=sys.stderr)
        sys.exit(1)
"""


def transcript(text):
    return "".join("(%s)\n" % line for line in textwrap.dedent(text).strip().splitlines())


class NistRs274ngc(AdapterCase):
    numbers_lines = False
    tolerance = Fraction(1, 20000)

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        program = os.path.join(cls.folder.name, "rs274abc")
        with open(program, "w", encoding="utf-8") as file:
            file.write(STAND_IN % sys.executable)
        os.chmod(program, 0o755)
        cls.command = python("nist_rs274ngc.py") + [program]
        super().setUpClass()

    @classmethod
    def tearDownClass(cls):
        super().tearDownClass()
        cls.folder.cleanup()

    def test_a_deep_hole(self):
        # G98 G83 X1 Z-4 R2 Q3 from Z10: out to the clear level, 10, between the pecks.
        self.assertRecords(transcript("""
            call USE_LENGTH_UNITS(CANON_UNITS_MM)
            call SET_FEED_RATE(100.0000)
            call STRAIGHT_TRAVERSE(0.0000, 0.0000, 10.0000, 0.0000, 0.0000, 0.0000)
            call SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)
            call STRAIGHT_TRAVERSE(1.0000, 0.0000, 10.0000, 0.0000, 0.0000, 0.0000)
            call STRAIGHT_TRAVERSE(1.0000, 0.0000, 2.0000, 0.0000, 0.0000, 0.0000)
            call STRAIGHT_FEED(1.0000, 0.0000, -1.0000, 0.0000, 0.0000, 0.0000)
            call STRAIGHT_TRAVERSE(1.0000, 0.0000, 10.0000, 0.0000, 0.0000, 0.0000)
            call STRAIGHT_TRAVERSE(1.0000, 0.0000, -0.7460, 0.0000, 0.0000, 0.0000)
            named STRAIGHT_FEED(1.0000, 0.0000, -4.0000, 0.0000, 0.0000, 0.0000)
            call STRAIGHT_TRAVERSE(1.0000, 0.0000, 10.0000, 0.0000, 0.0000, 0.0000)
            call SET_MOTION_CONTROL_MODE(CANON_CONTINUOUS)
            call STOP_SPINDLE_TURNING()
            call PROGRAM_END()"""), [
                {"k": "rapid", "to": {"x": 0, "z": 10}}, {"k": "rapid", "to": {"x": 1, "z": 10}},
                {"k": "rapid", "to": {"z": 2}}, {"k": "feed", "to": {"z": -1}, "f": 100},
                {"k": "rapid", "to": {"z": 10}}, {"k": "rapid", "to": {"z": "-0.746"}},
                {"k": "feed", "to": {"z": -4}, "f": 100}, {"k": "rapid", "to": {"z": 10}}])

    def test_a_tap_is_at_the_feed(self):
        self.assertRecords(transcript("""
            call SET_FEED_RATE(50.0000)
            call START_SPINDLE_CLOCKWISE()
            call START_SPEED_FEED_SYNCH()
            call STRAIGHT_FEED(1.0000, 0.0000, -1.0000)
            call STOP_SPINDLE_TURNING()
            call START_SPINDLE_COUNTERCLOCKWISE()
            call STRAIGHT_FEED(1.0000, 0.0000, 2.0000)
            call STOP_SPEED_FEED_SYNCH()"""), [
                {"k": "feed", "to": {"x": 1, "z": -1, "a": 0}, "f": 50},
                {"k": "feed", "to": {"z": 2}, "f": 50}])

    def test_arcs_planes_and_units(self):
        # In the plane of Z and X its two numbers are Z and X, and Y is the axial one.
        self.assertRecords(transcript("""
            call USE_LENGTH_UNITS(CANON_UNITS_INCHES)
            call SELECT_PLANE(CANON_PLANE_XZ)
            call SET_FEED_RATE(10.0000)
            call ARC_FEED(2.0000, 1.0000, 1.0000, 0.5000, -1, 0.0000, 0.0000, 0.0000, 90.0000)
            call DWELL(0.5000)"""), [
                {"k": "arc", "plane": "G18", "c": {"z": "25.4", "x": "12.7"}, "rot": -1, "f": 254,
                 "to": {"z": "50.8", "x": "25.4", "y": 0, "c": 90}}, {"k": "dwell", "s": "0.5"}])

    def test_errors(self):
        for text, cls in {
                "R less than z in cycle in xy plane": "reference-plane",
                "Spindle not turning in g86": "spindle-stopped",
                "Negative p word used": "value-sign", "Q word missing with g83": "missing-word",
                "P word with no g4 g10 g82 g86 g88 g89": "unused-word",
                "Two g codes used from same modal group": "duplicate-word",
                "G code out of range": "undefined-code", "Bad number format": "syntax",
                "Zero radius arc": "arc-radius",
                "Negative f word used": "value-sign", "Negative g code used": "undefined-code",
                "Line number greater than 99999": "syntax",
                "Cannot use axis values with g80": "missing-word",
                "Spindle not turning clockwise in g84": "spindle-stopped",
                "File ended with no percent sign or program end": "program-end"}.items():
            with self.subTest(text=text):
                self.assertAlarm("(call DWELL(1.0000))\n(error %s)\n" % text, cls, None, text,
                                 [{"k": "dwell"}])

    def test_a_spindle_that_turns_the_other_way(self):
        self.assertAlarm("(call START_SPINDLE_COUNTERCLOCKWISE())\n(error Spindle not turning clockwise in g84)\n",
                         "direction-conflict", None, "Spindle not turning clockwise in g84", [])

    def test_its_driver_ends_with_1_behind_the_end_of_a_program(self):
        # An end without the call of M2 is a crash of it.
        self.assertRecords("(call DWELL(1.0000))\n(call PROGRAM_END())\n(status 1)\n", [{"k": "dwell", "s": 1}])
        self.assertEqual(self.run_program("(call DWELL(1.0000))\n(status 1)\n")["outcome"], "error")
        self.assertEqual(self.run_program("(call PROGRAM_END())\n(status 2)\n")["outcome"], "error")

    def test_what_is_said_without_an_error_is_no_alarm(self):
        self.assertEqual(self.run_program("(call COMMENT(\"x\"))\n")["outcome"], "ok")

    def test_block_delete_is_switched_before_the_start(self):
        for skip, answers in ((False, 1), (True, 2)):
            self.assertRecords("(answers)\n", [{"k": "dwell", "s": answers}], {"block_skip": skip})

    def test_its_readings(self):
        self.addCleanup(self.talk.configure, "rs274", {})
        for value, taken in (("clear", True), ("any", True), ("r-plane", False)):
            reply = self.talk.configure("rs274", {"readings": {"ngc.g83.retract": value}})
            self.assertIs(reply["ok"], taken)

    def test_two_rotary_axes_are_not_guessed(self):
        reply = self.run_program("(call STRAIGHT_TRAVERSE(1.0, 2.0, 3.0, 4.0, 5.0))\n")
        self.assertEqual(reply["outcome"], "skip")


if __name__ == "__main__":
    unittest.main()
