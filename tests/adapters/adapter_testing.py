# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the adapters share: programs with records derived by hand, and a comparison.

Lengths are mm; a record that is expected names only what it is about. M functions are looked at where
some are expected.
"""
import importlib.util
import os
import shutil
import sys
import unittest
from fractions import Fraction

HERE = os.path.dirname(os.path.abspath(__file__))
ADAPTERS = os.path.join(HERE, "..", "..", "helpers", "adapters")
sys.path.insert(0, os.path.join(HERE, "..", "helpers"))
from talk import Talk  # noqa: E402


def python(name):
    return [sys.executable, "-B", os.path.join(ADAPTERS, name)]


def node(name):
    return [os.environ.get("GONOGO_NODE") or "node", os.path.join(ADAPTERS, name)]


def need(present, what):
    """Ends the test as skipped when what it judges is not installed."""
    if not present:
        print("SKIPPED: %s is not installed" % what)
        sys.exit(0)


def need_module(name, what):
    need(importlib.util.find_spec(name) is not None, what)


def need_npm(package):
    need(shutil.which("node") and os.path.isdir(os.path.join(ADAPTERS, "node_modules", package)),
         "npm's %s (npm ci in helpers/adapters)" % package)


def number(text):
    """The exact value of a number of the protocol."""
    return Fraction(float.fromhex(text)) if "0x" in text else Fraction(text)


class AdapterCase(unittest.TestCase):
    """One process of the adapter for all tests of a class."""

    command = None
    tolerance = Fraction(1, 10**9)
    numbers_lines = True  # the adapter declares the feature blocks

    @classmethod
    def setUpClass(cls):
        cls.talk = Talk(cls.command)
        cls.begun, cls.configured = cls.talk.start()

    @classmethod
    def tearDownClass(cls):
        cls.talk.__exit__()

    def run_program(self, program, profile=None):
        if profile is not None:
            self.assertEqual(self.talk.configure("rs274", profile), {"ok": True})
            self.addCleanup(self.talk.configure, "rs274", {})
        return self.talk.run(program)[0]

    def assertRecords(self, program, expected, profile=None):
        """The program runs to its end and gives these records."""
        reply = self.run_program(program, profile)
        self.assertEqual(reply["outcome"], "ok", reply)
        self.compare(reply["records"], expected)

    def assertAlarm(self, program, cls, b, native, records=()):
        """The program ends with this alarm; `native` is part of the interpreter's text."""
        reply = self.run_program(program)
        self.assertEqual(reply["outcome"], "alarm", reply)
        self.assertEqual(reply["alarm"].get("class"), cls)
        self.assertIn(native, reply["alarm"]["native"])
        self.assertEqual(reply["alarm"].get("b"), b if self.numbers_lines else None)
        self.compare(reply["records"], records)

    def compare(self, got, expected):
        if not any(wanted["k"] == "m" for wanted in expected):
            got = [record for record in got if record["k"] != "m"]
        self.assertEqual([record["k"] for record in got], [record["k"] for record in expected])
        for record, wanted in zip(got, expected):
            for key, value in wanted.items():
                if key == "b":
                    self.assertEqual(record.get("b"), value if self.numbers_lines else None)
                elif key in ("to", "c"):
                    for axis, place in value.items():
                        self.assertNear(record[key][axis], place, record)
                elif key in ("f", "s", "lead"):
                    self.assertNear(record[key], value, record)
                else:
                    self.assertEqual(record[key], value, record)

    def assertNear(self, text, value, record):
        self.assertLessEqual(abs(number(text) - Fraction(value)), self.tolerance, record)

    def assertChordsOfCircle(self, records, centre, radius, chord, end, places=9):
        """The feeds are chords, within `chord`, of a circle in the plane X, Y."""
        self.assertGreater(len(records), 2)
        at = None
        for record in records:
            point = [float(number(record["to"][axis])) - value for axis, value in zip("xy", centre)]
            self.assertAlmostEqual(sum(value * value for value in point) ** .5, radius, places)
            if at is not None:
                middle = [(one + other) / 2 for one, other in zip(at, point)]
                sagitta = radius - sum(value * value for value in middle) ** .5
                self.assertLessEqual(sagitta, chord)
            at = point
        self.compare(records[-1:], [{"k": "feed", "to": end}])


class Lines:
    """Straight motions, units, distances."""

    def test_the_default_profile_is_taken(self):
        self.assertEqual(self.configured, {"ok": True})
        self.assertEqual("blocks" in self.begun["features"], self.numbers_lines)

    def test_another_dialect_is_refused(self):
        self.addCleanup(self.talk.configure, "rs274", {})
        self.assertIs(self.talk.configure("gsk988ta", {})["ok"], False)

    def test_what_cannot_be_set_is_refused(self):
        self.addCleanup(self.talk.configure, "rs274", {})
        for profile in ({"offsets": {"G54": {"x": "1"}}}, {"x_diameter": True},
                        {"tools": {"1": {"radius": "5"}}}, {"parameters": {"5920": "1"}},
                        {"readings": {"ngc.arc-tolerance": "nist"}}, {"initial": {"a": "1e3"}}):
            reply = self.talk.configure("rs274", profile)
            self.assertIs(reply["ok"], False, profile)
            self.assertIn("cannot be set", reply["message"])

    def test_line(self):
        self.assertRecords("G0 X10 Y5\nG1 Z-2 F100\n", [
            {"k": "rapid", "b": 1, "to": {"x": 10, "y": 5, "z": 0}},
            {"k": "feed", "b": 2, "to": {"x": 10, "y": 5, "z": -2}, "f": 100}])

    def test_program_without_final_line_end(self):
        self.assertRecords("\n\nG0 X1", [{"k": "rapid", "b": 3, "to": {"x": 1}}])

    def test_nothing_is_left_of_the_program_before(self):
        self.run_program("G1 X7 Y8 Z9 F30\nG91 G0 X1\n")
        self.assertRecords("G0 X1\nX2\n", [
            {"k": "rapid", "b": 1, "to": {"x": 1, "y": 0, "z": 0}},
            {"k": "rapid", "b": 2, "to": {"x": 2, "y": 0, "z": 0}}])


class Distances:
    """G20 and G91, for interpreters that have both."""

    def test_inches(self):
        # 1 in = 25.4 mm: Y -0.5 in = -12.7 mm, F 10 in/min = 254 mm/min.
        self.assertRecords("G20\nG1 X1 Y-.5 F10\n", [
            {"k": "feed", "b": 2, "to": {"x": "25.4", "y": "-12.7", "z": 0}, "f": 254}])

    def test_incremental(self):
        self.assertRecords("G91\nG0 X1\nX1 Y2\nG90 G0 X0\n", [
            {"k": "rapid", "b": 2, "to": {"x": 1, "y": 0}},
            {"k": "rapid", "b": 3, "to": {"x": 2, "y": 2}},
            {"k": "rapid", "b": 4, "to": {"x": 0, "y": 2}}])


class Arcs:
    """Arcs of interpreters that give them as arcs, in all planes."""

    def test_arc_in_g17(self):
        self.assertRecords("G2 X10 Y0 I5 F200\n", [
            {"k": "arc", "b": 1, "plane": "G17", "c": {"x": 5, "y": 0}, "rot": -1, "f": 200,
             "to": {"x": 10, "y": 0, "z": 0}}])

    def test_arc_in_g18(self):
        # (Z, X) is the right-handed pair: G3 from Z0 X0 about Z3 X4 (radius 5) to Z6 X8.
        self.assertRecords("G18\nG3 X8 Z6 I4 K3 F200\n", [
            {"k": "arc", "b": 2, "plane": "G18", "c": {"z": 3, "x": 4}, "rot": 1, "f": 200,
             "to": {"x": 8, "y": 0, "z": 6}}])

    def test_arc_in_g19(self):
        self.assertRecords("G19\nG2 Y8 Z6 J4 K3 F200\n", [
            {"k": "arc", "b": 2, "plane": "G19", "c": {"y": 4, "z": 3}, "rot": -1, "f": 200,
             "to": {"x": 0, "y": 8, "z": 6}}])

    def test_helix(self):
        self.assertRecords("G3 X0 Y10 Z3 I0 J5 F60\n", [
            {"k": "arc", "b": 1, "plane": "G17", "c": {"x": 0, "y": 5}, "rot": 1, "f": 60,
             "to": {"x": 0, "y": 10, "z": 3}}])

    def test_full_circle(self):
        self.assertRecords("G2 X0 Y0 I5 F60\n", [
            {"k": "arc", "b": 1, "c": {"x": 5, "y": 0}, "rot": -1, "to": {"x": 0, "y": 0}}])

    def test_radius_form(self):
        # Chord 6, radius 5: the centre is 4 off the middle (3, 0). Clockwise along +X the short
        # arc has it on the right, at Y -4; the long one (R negative) on the left, at Y 4.
        for radius, y in (("5", -4), ("-5", 4)):
            self.assertRecords("G2 X6 Y0 R%s F60\n" % radius, [
                {"k": "arc", "b": 1, "c": {"x": 3, "y": y}, "rot": -1, "to": {"x": 6, "y": 0}}])

    def test_radius_form_in_g18(self):
        # In the pair (Z, X) the way to Z6 is along the first axis, as above: X is the second.
        self.assertRecords("G18\nG3 Z6 X0 R5 F60\n", [
            {"k": "arc", "b": 2, "plane": "G18", "c": {"z": 3, "x": 4}, "rot": 1,
             "to": {"z": 6, "x": 0}}])

    def test_many_blocks_come_whole(self):
        program = "".join("G0 X%d\n" % i for i in range(1, 2501))
        reply = self.run_program(program)
        self.compare(reply["records"], [{"k": "rapid", "b": i, "to": {"x": i}}
                                        for i in range(1, 2501)])
