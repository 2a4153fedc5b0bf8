# SPDX-License-Identifier: GPL-3.0-or-later
"""npm's gcode-toolpath behind its adapter."""
import unittest

from adapter_testing import AdapterCase, Arcs, Distances, Lines, need_npm, node


class GcodeToolpath(Lines, Distances, Arcs, AdapterCase):
    command = node("gcode_toolpath.mjs")
    numbers_lines = False

    def test_initial_position_plane_and_units(self):
        # From (1, 0, 2), 1 in along X is X 26.4; G3 in G18 about Z2 X1+25.4.
        self.assertRecords("G3 X2 I1 F1\n", [
            {"k": "arc", "plane": "G18", "c": {"z": 2, "x": "26.4"}, "rot": 1,
             "to": {"x": "50.8", "z": 2}, "f": "25.4"}],
            {"units": "inch", "initial": {"x": "1", "z": "2", "plane": "G18"}})

    def test_feed_after_the_motion_in_its_line_counts(self):
        self.assertRecords("G1 X1 F5\nX2 F6\n", [{"k": "feed", "f": 5}, {"k": "feed", "f": 6}])

    def test_a_motion_that_is_lost_is_not_made_up(self):
        # A word X that follows an F is never looked at.
        self.assertRecords("G1 X1 F5\nF7 X3\nX4\n", [
            {"k": "feed", "f": 5, "to": {"x": 1}}, {"k": "feed", "f": 7, "to": {"x": 4}}])

    def test_a_dwell_is_not_made_up(self):
        self.assertRecords("G4 P1\n", [])

    def test_a_missing_alarm_is_not_made_up(self):
        self.assertRecords("X1\n", [{"k": "rapid", "to": {"x": 1}}])

    def test_a_centre_that_is_no_number_is_an_error(self):
        self.assertEqual(self.run_program("G2 X10 R4 F5\n")["outcome"], "error")


if __name__ == "__main__":
    need_npm("gcode-toolpath")
    unittest.main()
