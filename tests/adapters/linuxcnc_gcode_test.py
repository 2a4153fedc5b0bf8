# SPDX-License-Identifier: GPL-3.0-or-later
"""LinuxCNC's Python module behind its adapter."""
import unittest
from fractions import Fraction

from adapter_testing import AdapterCase, number, python
from linuxcnc_cases import Linuxcnc, need_linuxcnc


class LinuxcncGcode(Linuxcnc, AdapterCase):
    command = python("linuxcnc_gcode.py")

    def test_the_adapter_rounds_nothing(self):
        # LinuxCNC keeps 1 mm as the double nearest to 1/25.4 in; 25.4 times that double, exactly,
        # is not 1, and no rounding may bring the 1 back.
        (record,) = self.run_program("G0 X1\n")["records"]
        self.assertEqual(number(record["to"]["x"]), Fraction(1 / 25.4) * Fraction(127, 5))
        self.assertNotEqual(number(record["to"]["x"]), 1)

    def test_initial_position_plane_and_units(self):
        self.assertRecords("G91 G0 X1\n", [
            {"k": "rapid", "b": 1, "to": {"x": "30.4", "y": 0, "z": "-2.5"}}],
            {"units": "inch", "initial": {"x": "5", "z": "-2.5", "plane": "G18"}})

    def test_initial_plane(self):
        self.assertRecords("G2 X8 Z6 I4 K3 F200\n", [{"k": "arc", "plane": "G18"}],
                           {"initial": {"plane": "G18"}})

    def test_no_motion_is_on_at_the_initial_position(self):
        reply = self.run_program("X1\n", {"initial": {"x": "5"}})
        self.assertEqual(reply["alarm"]["class"], "missing-word")

    def test_initial_feed(self):
        self.assertAlarm("G1 X1\n", "feed-missing", 1, "Cannot do g1 with zero feed rate")
        self.assertRecords("G1 X1\nA90\nG20 X1\nA0\n", 4 * [{"k": "feed", "f": 50}],
                           {"initial": {"f": "50"}})

    def test_a_thread_whose_lead_is_not_told_is_skipped(self):
        self.assertEqual(self.run_program("S1 M3\nG33.1 Z-1 K1\n")["outcome"], "skip")


if __name__ == "__main__":
    need_linuxcnc()
    unittest.main()
