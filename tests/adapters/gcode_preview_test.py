# SPDX-License-Identifier: GPL-3.0-or-later
"""npm's gcode-preview behind its adapter."""
import unittest

from adapter_testing import AdapterCase, Lines, need_npm, node


class GcodePreview(Lines, AdapterCase):
    command = node("gcode_preview.mjs")
    numbers_lines = False

    def test_nothing_is_left_of_the_program_before(self):
        self.run_program("G1 X7 Y8 Z9 F30\nG20\n")
        self.assertRecords("G0 X1\n", [{"k": "rapid", "to": {"x": 1, "y": 0, "z": 0}}])

    def test_arc(self):
        # Pieces of 1.8 mm along the arc: on radius 5 a chord is 5 (1 - cos 0.18) = 0.081 off.
        records = self.run_program("G2 X10 Y0 I5 F200\n")["records"]
        self.assertEqual({record["f"] for record in records}, {"200"})
        self.assertChordsOfCircle(records, (5, 0), 5, 0.0811, {"x": 10, "y": 0, "z": 0})
        self.assertTrue(all(not record["to"]["y"].startswith("-") for record in records))

    def test_radius_form(self):
        records = self.run_program("G3 X6 Y0 R5 F60\n")["records"]
        self.assertChordsOfCircle(records, (3, 4), 5, 0.0811, {"x": 6, "y": 0})

    def test_a_feed_on_a_line_of_its_own(self):
        self.assertRecords("F30\nG1 X1\nF(c)\nG1 X2 F40\n", [
            {"k": "feed", "to": {"x": 1}, "f": 30}, {"k": "feed", "to": {"x": 2}, "f": 40}])

    def test_initial_position(self):
        self.assertRecords("G1 Y2\n", [{"k": "feed", "to": {"x": 5, "y": 2, "z": -1}, "f": 3}],
                           {"initial": {"x": "5", "z": "-1", "f": "3"}})

    def test_a_full_circle_that_is_not_drawn_is_not_made_up(self):
        self.assertRecords("G2 X0 Y0 I5 F60\n", [])

    def test_a_helix_goes_the_way_that_it_is_drawn(self):
        # Half a turn of radius 5 is 15.708 mm: 8.727 pieces, each 5 / 8.727 = 0.573 of Z. They are
        # drawn downwards, although the end is above.
        records = self.run_program("G2 X10 Y0 Z5 I5 F60\n")["records"]
        self.assertAlmostEqual(float(records[0]["to"]["z"]), -0.573, 3)
        self.assertEqual(records[-1]["to"]["z"], "5")


if __name__ == "__main__":
    need_npm("gcode-preview")
    unittest.main()
