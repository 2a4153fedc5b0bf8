# SPDX-License-Identifier: GPL-3.0-or-later
"""bCNC behind its adapter."""
import os
import unittest

from adapter_testing import AdapterCase, Distances, Lines, need, number, python


class Bcnc(Lines, Distances, AdapterCase):
    command = python("bcnc.py")

    def test_arc(self):
        records = self.run_program("G2 X10 Y0 I5 F200\n")["records"]
        self.assertChordsOfCircle(records, (5, 0), 5, 0.0101, {"x": 10, "y": 0, "z": 0})
        self.assertTrue(all(number(record["to"]["y"]) >= 0 for record in records))
        self.assertEqual({(record["b"], number(record["f"])) for record in records}, {(1, 200)})

    def test_radius_form(self):
        records = self.run_program("G3 X6 Y0 R5 F60\n")["records"]
        self.assertChordsOfCircle(records, (3, 4), 5, 0.0101, {"x": 6, "y": 0})

    def test_arc_in_g18(self):
        # G2 seen from +Y, in the pair (Z, X): from X0 about X5 to X10 it goes over Z -5.
        records = self.run_program("G18 G2 X10 Z0 I5 F200\n")["records"]
        self.assertLess(min(number(record["to"]["z"]) for record in records), -4.9)

    def test_helix(self):
        records = self.run_program("G3 X0 Y10 Z3 J5 F60\n")["records"]
        self.assertChordsOfCircle(records, (0, 5), 5, 0.0101, {"x": 0, "y": 10, "z": 3})
        # Half way along, at X 5, Z is 1.5. A chord that is 0.01 off turns by 2 acos(1 - 0.01/5),
        # 0.1265, and rises by 3 * 0.1265 / pi = 0.121: the nearest corner is within half of that.
        middle = max(records, key=lambda record: number(record["to"]["x"]))
        self.assertAlmostEqual(float(number(middle["to"]["z"])), 1.5, delta=0.061)

    def test_absolute_centre(self):
        records = self.run_program("G0 X2\nG90.1 G3 X12 Y0 I7 J0 F10\n")["records"]
        self.assertChordsOfCircle(records[1:], (7, 0), 5, 0.0101, {"x": 12, "y": 0})

    def test_a_deep_hole_is_what_it_sends(self):
        # It pecks from R each time: no traverse back into the hole.
        self.assertRecords("G0 Z5 F100\nG98 G83 X10 Z-6 R1 Q2.5\nG80\n", [
            {"k": "rapid", "b": 1, "to": {"z": 5}}, {"k": "rapid", "b": 2, "to": {"x": 10, "z": 5}},
            *({"k": kind, "b": 2, "to": {"x": 10, "z": z}} for kind, z in (
                ("rapid", 1), ("feed", "-1.5"), ("rapid", 1), ("feed", -4), ("rapid", 1),
                ("feed", -6), ("rapid", 5)))])

    def test_a_dwell_of_a_cycle_is_sent(self):
        self.assertRecords("G0 Z1 F50\nG99 G82 X1 Z-2 R1 P0.5\nG80\n", [
            {"k": "rapid"}, {"k": "rapid", "to": {"x": 1}}, {"k": "feed", "to": {"z": -2}, "f": 50},
            {"k": "dwell", "b": 2, "s": "0.5"}, {"k": "rapid", "to": {"z": 1}}])

    def test_a_line_without_a_motion_sends_the_cycle_again(self):
        records = self.run_program("G0 Z1 F50\nG99 G81 X1 Z-2 R1\nM5\n")["records"]
        self.assertEqual([record["b"] for record in records if record["k"] == "feed"], [2, 3])

    def test_initial_position_plane_and_units(self):
        self.assertRecords("G91 G0 X1\n", [{"k": "rapid", "to": {"x": "30.4", "z": "-2.5"}}],
                           {"units": "inch", "initial": {"x": "5", "z": "-2.5"}})

    def test_a_missing_alarm_is_not_made_up(self):
        self.assertRecords("X1\n", [])


if __name__ == "__main__":
    need(os.path.exists("/usr/share/bcnc/bCNC/CNC.py"), "bcnc")
    unittest.main()
