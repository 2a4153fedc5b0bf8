# SPDX-License-Identifier: GPL-3.0-or-later
"""FreeCAD's Path workbench behind its adapter."""
import os
import unittest

from adapter_testing import AdapterCase, Lines, need, python


class FreecadPath(Lines, AdapterCase):
    command = python("freecad_path.py")
    numbers_lines = False

    def test_nothing_is_left_of_the_program_before(self):
        self.run_program("G20\nG1 X7 Y8 Z9 F30\n")
        self.assertRecords("G0 X1\n", [{"k": "rapid", "to": {"x": 1, "y": 0, "z": 0}}])

    def test_inches(self):
        self.assertRecords("G20\nG1 X1 Y-.5 F10\n", [
            {"k": "feed", "to": {"x": "25.4", "y": "-12.7", "z": 0}, "f": 254}])

    def test_arcs(self):
        self.assertRecords("G2 X10 Y0 I5 F200\nG3 X0 Y10 I-10 F100\n", [
            {"k": "arc", "plane": "G17", "c": {"x": 5, "y": 0}, "rot": -1, "f": 200,
             "to": {"x": 10, "y": 0, "z": 0}},
            {"k": "arc", "plane": "G17", "c": {"x": 0, "y": 0}, "rot": 1, "f": 100,
             "to": {"x": 0, "y": 10, "z": 0}}])

    def test_helix(self):
        records = self.run_program("G3 X0 Y10 Z3 J5 F60\n")["records"]
        self.assertChordsOfCircle(records, (0, 5), 5, 0.0011, {"x": 0, "y": 10, "z": 3},
                                  places=4)  # the helix is a spline

    def test_dwell(self):
        self.assertRecords("G4 P0.5\n", [{"k": "dwell", "s": "0.5"}])

    def test_a_full_circle_is_where_it_is_drawn(self):
        # About (0, 5), from its own start (5, 5), under G2 and G3 alike and from any programmed start.
        self.assertRecords("G2 X0 Y0 J5 F60\n", [
            {"k": "feed", "to": {"x": 5, "y": 5}},
            {"k": "arc", "c": {"x": 0, "y": 5}, "rot": 1, "to": {"x": 5, "y": 5}}])

    def test_what_it_cannot_read_is_an_alarm(self):
        self.assertAlarm("G0 X1\nG1 Q\n", None, None, "Badly formatted")

    def test_what_it_cannot_draw_is_an_alarm(self):
        self.assertAlarm("G0 X1\nG2 X5 R3 F5\n", None, None, "coincident", [{"k": "rapid"}])

    def test_initial_position(self):
        self.assertRecords("G1 Y2\n", [{"k": "feed", "to": {"x": 5, "y": 2, "z": -1}, "f": 3}],
                           {"initial": {"x": "5", "z": "-1", "f": "3"}})


if __name__ == "__main__":
    need(os.path.isdir("/usr/share/freecad/Mod/Path"), "freecad-python3")
    unittest.main()
