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


if __name__ == "__main__":
    need_linuxcnc()
    unittest.main()
