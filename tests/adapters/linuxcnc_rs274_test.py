# SPDX-License-Identifier: GPL-3.0-or-later
"""LinuxCNC's stand-alone interpreter behind its adapter."""
import unittest
from fractions import Fraction

from adapter_testing import AdapterCase, python
from linuxcnc_cases import Linuxcnc, need_linuxcnc


class LinuxcncRs274(Linuxcnc, AdapterCase):
    command = python("linuxcnc_rs274.py")
    numbers_lines = False
    tolerance = Fraction(1, 20000)  # half of the last of four decimals

    def test_feed_missing(self):
        self.assertAlarm("G1 X1\n", "feed-missing", None, "Cannot do g1 with zero feed rate")
        self.assertAlarm("G2 X10 I5\n", "feed-missing", None, "Cannot make arc with zero feed rate")

    def test_programs_need_not_be_utf_8(self):
        self.assertIn("bytes", self.begun["features"])
        self.assertRecords(b"(\xd6\xd0)\nG0 X1\n", [{"k": "rapid", "to": {"x": 1}}])

    def test_a_resolution_finer_than_the_output_is_refused(self):
        self.addCleanup(self.talk.configure, "rs274", {})
        self.assertIs(self.talk.configure("rs274", {"resolution": "0.00001"})["ok"], False)
        self.assertIs(self.talk.configure("rs274", {"resolution": "0.001"})["ok"], True)

    def test_inches_are_printed_with_four_decimals(self):
        # 0.00004 in is printed as 0.0000.
        self.assertRecords("G20 G0 X0.00004\n", [{"k": "rapid", "to": {"x": 0}}])

    def assertFunctions(self, program, numbers):
        records = self.run_program(program, {"tools": {"1": {"radius": "3"}}})["records"]
        self.assertEqual([record["m"] for record in records if record["k"] == "m"], numbers)

    def test_functions(self):
        for m in (0, 1, 3, 4, 5, 6, 7, 8, 9, 48, 49, 50, 51, 60):
            with self.subTest(m=m):
                self.assertFunctions("S1 T1\nM%d\nG0 X1\n" % m, [m, 2])

    def test_the_end_of_the_program_is_one_function(self):
        for end in ("M2", "M30"):
            reply = AdapterCase.run_program(self, "S1 M3\nM8\nM49\n%s\n" % end)
            self.assertEqual([record["m"] for record in reply["records"]],
                             [3, 8, 49, int(end[1:])])

    def test_a_tap_turns_the_spindle_and_no_switch(self):
        self.assertRecords("S100 M3 F100\nG84 X1 Z-1 R0 P0.5\nX1\nM48\n", [
            {"k": "m", "m": 3}, *(2 * [
                {"k": "rapid", "to": {"x": 1}}, {"k": "feed", "to": {"z": -1}}, {"k": "m", "m": 5}, {"k": "m", "m": 4},
                {"k": "dwell", "s": "0.5"}, {"k": "feed", "to": {"z": 0}}, {"k": "m", "m": 5},
                {"k": "m", "m": 3}]), {"k": "m", "m": 48}, {"k": "m", "m": 2}])

    def test_a_thread_has_its_lead_along_the_longer_axis(self):
        # A path of 3 and 4 is 5 long: the lead along Z is 1.5 * 4 / 5.
        self.assertRecords("S100 M3\nG0 X3 Z4\nG33 X6 Z0 K1.5\n", [
            {"k": "rapid"}, {"k": "thread", "to": {"x": 6, "z": 0}, "lead": "1.2", "start": "0"}])

    def test_a_rigid_tap_goes_in_and_out(self):
        for sense in (3, 4):
            self.assertRecords("S100 M%d\nG0 X3 Z4\nG33.1 Z0 K1.5\nG0 X5\n" % sense, [
                {"k": "m", "m": sense}, {"k": "rapid"},
                {"k": "thread", "to": {"x": 3, "z": 0}, "lead": "1.5"}, {"k": "m", "m": 7 - sense},
                {"k": "thread", "to": {"x": 3, "z": 4}, "lead": "1.5"}, {"k": "m", "m": sense},
                {"k": "rapid", "to": {"x": 5, "z": 4}}, {"k": "m", "m": 2}])

    def test_a_threading_cycle(self):
        # Passes of depth 1 and 1.5; the last motion, to the drive line at the end, has no length.
        program = "G18 S100 M3\nG0 X20 Z2\nG76 P2 Z-20 I-1 J1 K1.5\n"
        self.assertRecords(program, [
            {"k": "rapid", "to": {"x": 20, "z": 2}}, *(
                {"k": kind, "to": {"x": x, "z": z}} for kind, x, z in (
                    ("rapid", "20.5", 2), ("rapid", 18, 2), ("thread", 18, -20),
                    ("rapid", "20.5", -20), ("rapid", 20, 2), ("rapid", "17.5", 2),
                    ("thread", "17.5", -20), ("rapid", 20, -20), ("rapid", 20, -20)))])


if __name__ == "__main__":
    need_linuxcnc()
    unittest.main()
