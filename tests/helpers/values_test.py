# SPDX-License-Identifier: GPL-3.0-or-later
"""How the Python helper writes values."""
import os
import sys
import unittest
from decimal import Decimal
from fractions import Fraction

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "helpers"))
from gonogo_pipe import alarm, error, number_text, record  # noqa: E402


class Values(unittest.TestCase):
    def test_a_float_reads_back_as_the_same(self):
        for value in (0.0, 1.0, -1.5, 0.1, 1 / 3, 5e-324, sys.float_info.max, 1e21):
            self.assertEqual(float.fromhex(number_text(value)), value)

    def test_exact_types_keep_every_digit(self):
        self.assertEqual(number_text(Fraction(11, 3)), "11/3")
        self.assertEqual(number_text(Fraction(4, 2)), "2")
        self.assertEqual(number_text(Decimal("1.2300")), "1.2300")
        self.assertEqual(number_text(9007199254740993), "9007199254740993")

    def test_a_text_is_passed_on(self):
        self.assertEqual(number_text("0.1"), "0.1")

    def test_what_is_no_number_is_refused(self):
        for value in (float("nan"), float("-inf"), Decimal("NaN"), True, None, [], b"1"):
            with self.assertRaises((TypeError, ValueError)):
                number_text(value)

    def test_a_record_has_its_numbers_as_text_and_its_integers_bare(self):
        self.assertEqual(
            record("arc", {"b": 3, "plane": "G17", "rot": -1, "c": {"x": 5, "y": 0},
                           "to": {"x": 10}, "f": 200, "fm": None}),
            {"k": "arc", "b": 3, "plane": "G17", "rot": -1, "c": {"x": "5", "y": "0"},
             "to": {"x": "10"}, "f": "200"})

    def test_an_enclosure_is_a_number(self):
        self.assertEqual(record("rapid", {"to": {"x": {"enclosure": [0, Fraction(1, 2)]}}}),
                         {"k": "rapid", "to": {"x": {"enclosure": ["0", "1/2"]}}})

    def test_a_root_is_a_number_wherever_one_stands(self):
        half_root = {"root": [0, Fraction(1, 2), 2]}
        self.assertEqual(record("thread", {"to": {"z": half_root}, "lead": half_root, "start": 0}),
                         {"k": "thread", "to": {"z": {"root": ["0", "1/2", "2"]}},
                          "lead": {"root": ["0", "1/2", "2"]}, "start": "0"})

    def test_a_long_text_of_the_subject_is_cut_where_the_protocol_ends(self):
        self.assertEqual(len(alarm("x" * 5000)["alarm"]["native"]), 1000)
        self.assertEqual(len(error("x" * 5000)["message"]), 1000)


if __name__ == "__main__":
    unittest.main()
