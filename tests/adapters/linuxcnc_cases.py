# SPDX-License-Identifier: GPL-3.0-or-later
"""What both of LinuxCNC's interpreters do."""
import shutil

from adapter_testing import Arcs, Distances, Lines, need, need_module


def need_linuxcnc():
    need(shutil.which("rs274"), "linuxcnc-uspace")
    need_module("gcode", "linuxcnc-uspace")


def ended(program):
    """The program with an M2 behind its last line."""
    text = program if isinstance(program, bytes) else program.encode()
    return text + (b"" if text.endswith(b"\n") or not text else b"\n") + b"M2\n"


class Linuxcnc(Lines, Distances, Arcs):
    def run_program(self, program, profile=None):
        return super().run_program(ended(program), profile)

    PLACES = {"offsets": {"G54": {"x": "10", "z": "-2.5"}, "G59.3": {"y": "1", "a": "30"}},
              "reference_point": {"x": "-1", "z": "50"}, "parameters": {"5181": "7", "5183": "60"},
              "tools": {"2": {"length": "25.5", "radius": "3"}, "11": {"length": "-4"}}}

    def test_what_cannot_be_set_is_refused(self):
        self.addCleanup(self.talk.configure, "rs274", {})
        for profile in ({"offsets": {"G53": {"x": "1"}}}, {"offsets": {"G54": {"x": "1e3"}}},
                        {"x_diameter": True}, {"parameters": {"5920": "1"}},
                        {"readings": {"ngc.arc-tolerance": "nist"}}, {"initial": {"a": "1e3"}}):
            reply = self.talk.configure("rs274", profile)
            self.assertIs(reply["ok"], False, profile)
            self.assertIn("cannot be set", reply["message"])

    def test_places_are_of_the_machine(self):
        self.assertRecords("G0 X1 Z1\nG59.3 X1 Y1 Z1 A1\nG54 G2 X-7 I1 F60\n", [
            {"k": "rapid", "b": 1, "to": {"x": 11, "y": 0, "z": "-1.5", "a": 0}},
            {"k": "rapid", "b": 2, "to": {"x": 1, "y": 2, "z": 1, "a": 31}},
            {"k": "arc", "b": 3, "c": {"x": 2, "y": 2}, "to": {"x": 3, "y": 2, "z": 1, "a": 31}}],
            {**self.PLACES, "readings": {"ngc.arc-tolerance": "any"}})

    def test_places_that_a_program_sets(self):
        self.assertRecords("G10 L2 P2 X5\nG55 G0 X1\nG92 X2 Y3\nX3 Y3\nG92.1\nX3\n", [
            {"k": "rapid", "b": 2, "to": {"x": 6, "y": 0}},
            {"k": "rapid", "b": 4, "to": {"x": 7, "y": 0}},
            {"k": "rapid", "b": 6, "to": {"x": 8}}])

    def test_lengths_of_tools(self):
        self.assertRecords("G43 H11 G0 Z1\nT2 M6\nG43 Z1\nG49 Z1\nG43.1 X1 Z2\nX1 Z1\n", [
            {"k": "rapid", "b": 1, "to": {"x": 0, "z": "-5.5"}},
            {"k": "rapid", "b": 3, "to": {"z": 24}}, {"k": "rapid", "b": 4, "to": {"z": "-1.5"}},
            {"k": "rapid", "b": 6, "to": {"x": 12, "z": "0.5"}}], self.PLACES)

    def test_reference_points(self):
        self.assertRecords("G28 Z1\nG30\nG53 G0 X3\n", [
            {"k": "rapid", "b": 1, "to": {"z": "-1.5"}}, {"k": "rapid", "b": 1, "to": {"z": 50}},
            {"k": "rapid", "b": 2, "to": {"x": 0, "z": 50}},
            {"k": "rapid", "b": 2, "to": {"x": 7, "z": 60}},
            {"k": "rapid", "b": 3, "to": {"x": 3, "z": 60}}], self.PLACES)

    def test_nothing_is_left_of_places_that_a_program_set(self):
        self.run_program("G10 L2 P1 X5\nG28.1\nG92 Y1\n#5=7\n")
        self.assertRecords("G28\nG0 X1 Y1 Z#5\n", [{"k": "rapid"}, {"k": "rapid"}, {
            "k": "rapid", "to": {"x": 1, "y": 1, "z": 0}}])

    def test_an_offset_moves_no_linear_axis(self):
        # A feed of degrees, though 1/3 in is printed with four decimals on either side of G92.
        self.assertRecords("G20\nG1 X.333333 F10\nG92 X.1\nA90\n", [
            {"k": "feed", "b": 2, "f": 254}, {"k": "feed", "b": 4, "f": 10}])

    def test_parameters_and_o_words(self):
        self.assertRecords("o1 sub\nG0 X[#1*2]\no1 endsub\no2 repeat [2]\n#9=[#9+1]\n"
                           "o1 call [#9]\no2 endrepeat\n", [
                               {"k": "rapid", "b": 2, "to": {"x": x}} for x in (2, 4)])

    def test_alarms_of_offsets_and_values(self):
        for block, cls in {
                "G10 L2 P10 X1": "value-out-of-range", "G10 P1 X1": "missing-word",
                "G92": "missing-word", "G92 G1 X1": "conflicting-words", "G43 H-1": "no-tool",
                "G91 G53 G0 X1": "conflicting-words", "G0 X#<d>": "value-out-of-range",
                "G0 X[1/0]": "value-out-of-range", "G0 X[1": "syntax", "o1 endif": "syntax",
                "o1 if": "syntax"}.items():
            with self.subTest(block=block):
                self.assertAlarm(block + "\n", cls, 1, "")

    def test_a_program_without_an_end_alarms(self):
        reply = super().run_program("G0 X1\nX2\n")
        self.assertEqual(reply["alarm"]["class"], "program-end")
        self.assertEqual(reply["alarm"].get("b"), 2 if self.numbers_lines else None)
        self.compare(reply["records"], [{"k": "rapid", "to": {"x": 1}},
                                        {"k": "rapid", "to": {"x": 2}}])

    def test_blank_lines_are_no_program(self):
        reply = super().run_program("  ")
        self.assertEqual(reply["alarm"]["class"], "program-end")
        self.assertEqual(reply["alarm"].get("b"), 1 if self.numbers_lines else None)

    def test_a_word_that_nothing_uses_alarms(self):
        for word in ("I2", "J2", "K2", "R2", "P2", "Q2", "L2", "D2", "H2", "E2"):
            with self.subTest(word=word):
                self.assertAlarm("G0 X1 %s\n" % word, "unused-word", 1, "word with no")

    def test_absolute_centre(self):
        self.assertRecords("G0 X2\nG90.1 G3 X12 Y0 I7 J0 F10\n", [
            {"k": "rapid", "b": 1},
            {"k": "arc", "b": 2, "c": {"x": 7, "y": 0}, "rot": 1, "to": {"x": 12, "y": 0}}])

    def test_turns(self):
        self.assertRecords("G2 X10 I5 P3 Z4 F10\n", [
            {"k": "arc", "b": 1, "rot": -3, "to": {"x": 10, "y": 0, "z": 4}}])

    def test_dwell(self):
        self.assertRecords("G4 P0.5\n", [{"k": "dwell", "b": 1, "s": "0.5"}])

    def test_pair_of_percent_signs(self):
        self.assertRecords("%\nG0 X1\n%\nG0 X2\n", [{"k": "rapid", "b": 2, "to": {"x": 1}}])

    def test_numbers_of_blocks_are_not_line_numbers(self):
        self.assertRecords("N 1 2 G0 X1\nN99999999 G0 X2\n", [
            {"k": "rapid", "b": 1, "to": {"x": 1}}, {"k": "rapid", "b": 2, "to": {"x": 2}}])

    def test_tools(self):
        self.assertRecords("T1 M6\nG0 X1\n", [{"k": "rapid", "b": 2, "to": {"x": 1}}],
                           profile={"tools": {"1": {"radius": "3"}}})

    def test_nothing_runs_after_m2(self):
        self.assertRecords("G0 X1\nM2\nG0 X2\n", [{"k": "rapid", "b": 1, "to": {"x": 1}}])

    def test_feed_per_revolution(self):
        self.assertRecords("S100 M3\nG95 G1 X1 F0.2\nX2\nG94 X3 F5\n", [
            {"k": "feed", "b": 2, "to": {"x": 1}, "f": "0.2", "fm": "rev"},
            {"k": "feed", "b": 3, "to": {"x": 2}, "f": "0.2", "fm": "rev"},
            {"k": "feed", "b": 4, "to": {"x": 3}, "f": 5}])

    def test_the_feed_of_a_rotary_axis_alone_is_one_of_degrees_in_either_unit(self):
        self.assertRecords("G20\nG1 A90 F10\nX1\nA0\nG21 A90\nX0 A0\nF20 A90\n", [
            {"k": "feed", "b": 2, "to": {"x": 0, "a": 90}, "f": 10},
            {"k": "feed", "b": 3, "to": {"x": "25.4"}, "f": 254},
            {"k": "feed", "b": 4, "to": {"a": 0}, "f": 10},
            {"k": "feed", "b": 5, "to": {"a": 90}, "f": 10},
            {"k": "feed", "b": 6, "to": {"x": 0, "a": 0}, "f": 254},
            {"k": "feed", "b": 7, "to": {"a": 90}, "f": 20}])

    def test_a_change_of_units_moves_no_linear_axis(self):
        # 0.12345 in is printed with four decimals, and again, otherwise rounded, as millimetres.
        self.assertRecords("G20\nG1 X0.12345 F10\nG21 A90\nG20 A0\n", [
            {"k": "feed", "f": 254}, {"k": "feed", "f": 10}, {"k": "feed", "f": 10}])

    def test_block_delete(self):
        for skip, ends in ((False, [1, 2, 3]), (True, [1, 3])):
            self.assertRecords("G0 X1\n/G0 X2\nG0 X3\n",
                               [{"k": "rapid", "b": x, "to": {"x": x}} for x in ends],
                               {"block_skip": skip})

    def test_reading_of_the_arc_tolerance(self):
        self.assertRecords("G0 X1\n", [{"k": "rapid"}],
                           {"readings": {"ngc.arc-tolerance": "linuxcnc"}})

    def test_comments_in_chinese(self):
        self.assertRecords("(\u4e2d) ;\u4e2d\nG0 X1\n", [{"k": "rapid", "b": 2, "to": {"x": 1}}])

    def test_alarm_in_a_block_that_cannot_be_done(self):
        self.assertAlarm("G0 X1\n\nG2 Y1 F10\nG0 X5\n", "missing-word", 3,
                         "R i j k words all missing for arc",
                         [{"k": "rapid", "b": 1, "to": {"x": 1}}])

    def test_alarm_in_a_block_that_cannot_be_read(self):
        self.assertAlarm("G0 X1\nG0 Q\nG0 X5\n", "syntax", 2, "No characters found",
                         [{"k": "rapid", "b": 1}])

    def test_alarms_behind_lines_without_motion(self):
        for block, cls in (("G2 Y1 F1", "missing-word"), ("G0 Q", "syntax"),
                           ("G99.9", "undefined-code"), ("G0 G1 X1", "duplicate-word")):
            with self.subTest(block=block):
                self.assertAlarm("G0 X1\n(c)\n\nS100\nG21\n%s\nG0 X5\n" % block, cls, 6, "",
                                 [{"k": "rapid", "b": 1}])

    def test_alarm_in_the_first_line(self):
        self.assertAlarm("X1\n", "missing-word", 1, "Cannot use axis values")

    def test_alarm_in_the_last_line_without_line_end(self):
        self.assertAlarm("G0 X1\nG2 X5 I9 F1", "arc-end-point", 2, "Radius to end of arc differs",
                         [{"k": "rapid", "b": 1}])

    def test_classes(self):
        for block, cls in {
                "G2 X10 R4 F1": "arc-radius", "G2 X0 Y0 R4 F1": "arc-end-point",
                "G2 X10 I5 K1 F1": "axis-not-in-plane", "G2 X10 I5 R5 F1": "conflicting-words",
                "G2 X10 I5 P1.5 F1": "not-an-integer", "G0 X1 X2": "duplicate-word",
                "G0 G1 X1 F1": "duplicate-word", "G99.9": "undefined-code", "G4": "missing-word",
                "G0 X1.2.3": "syntax"}.items():
            with self.subTest(block=block):
                self.assertAlarm(block + "\n", cls, 1, "")

    def test_a_negative_feed_has_the_class_of_its_sign(self):
        self.assertAlarm("F-1\n", "value-sign", 1, "Negative f word used")

    def test_nothing_is_left_of_a_program_that_alarmed(self):
        self.run_program("G20 G91 G18 G90.1\nG0 Q\n")
        self.assertRecords("G2 X10 I5 F10\n", [
            {"k": "arc", "plane": "G17", "c": {"x": 5, "y": 0}, "to": {"x": 10}, "f": 10}])

    def test_nothing_is_left_of_a_tool_length_offset(self):
        self.run_program("G43.1 Z1\n")
        self.assertRecords("G49\nG0 X1\n", [{"k": "rapid", "to": {"x": 1, "z": 0}}])

    def test_an_axis_that_no_record_has_is_skipped(self):
        self.assertEqual(self.run_program("G0 B1\n")["outcome"], "skip")

    def test_pecks_of_a_deep_hole(self):
        # Q2.5 from R1: -1.5, -4 and the rest to -6; back in to 0.254 above the last.
        down = [(1, "rapid"), ("-1.5", "feed"), (1, "rapid"), ("-1.246", "rapid"), (-4, "feed"),
                (1, "rapid"), ("-3.746", "rapid"), (-6, "feed"), (5, "rapid")]
        self.assertRecords("G0 Z5 F100\nG98 G83 X10 Z-6 R1 Q2.5\n", [
            {"k": "rapid", "b": 1, "to": {"z": 5}}, {"k": "rapid", "b": 2, "to": {"x": 10, "z": 5}},
            *({"k": kind, "b": 2, "to": {"x": 10, "z": z}} for z, kind in down)])

    def test_a_dwell_of_a_cycle(self):
        self.assertRecords("G0 Z1 F100\nG99 G82 X1 Z-2 R1 P0.5\n", [
            {"k": "rapid"}, {"k": "rapid", "b": 2, "to": {"x": 1, "z": 1}},
            {"k": "feed", "b": 2, "to": {"z": -2}, "f": 100}, {"k": "dwell", "b": 2, "s": "0.5"},
            {"k": "rapid", "b": 2, "to": {"z": 1}}])

    def test_steps_and_words_that_stay(self):
        # R counts from the initial level, 3: 2, bottom 1; the next block the same.
        self.assertRecords("G0 Z3 F100\nG91 G98 G81 X1 Z-1 R-1 L2\nX1\n", [
            {"k": "rapid", "b": 1}, *(
                {"k": kind, "b": b, "to": {"x": x, "z": z}}
                for x, b in ((1, 2), (2, 2), (3, 3))
                for kind, z in (("rapid", 3), ("rapid", 2), ("feed", 1), ("rapid", 3)))])

    def test_alarms_of_cycles(self):
        for block, cls in {
                "G81 X1 Z-1": "missing-word", "G81 X1 R1": "missing-word",
                "G82 X1 Z-1 R0": "missing-word", "G83 X1 Z-1 R0": "missing-word",
                "G81 X1 Z2 R1": "reference-plane", "G81 X1 Z-1 R0 L0": "value-out-of-range",
                "G81 X1 Z-1 R0 L-1": "value-sign", "G83 X1 Z-1 R0 Q-2": "value-sign",
                "G81 X1 Z-1 R0 A1": "axis-not-in-plane", "G86 X1 Z-1 R0 P1": "spindle-stopped",
                "G84 X1 Z-1 R0": "spindle-stopped", "G33 X1": "lead-missing",
                "G33 X1 K1": "spindle-stopped", "G33 X1 K1 F5": "conflicting-words",
                "G18 G76 Z-9 I-1 J1 K2": "lead-missing",
                "G18 G76 Z-9 P1 I-1 K2": "missing-word"}.items():
            with self.subTest(block=block):
                reply = self.run_program("F100\n" + block + "\n")
                self.assertEqual(reply["alarm"].get("class"), cls, reply)

    def test_the_spindle_turns_in_every_program_that_says_so(self):
        for _ in range(3):
            self.assertRecords("S100 M3 F100\nG84 X1 Z-1 R0 P1\n", [
                {"k": "rapid", "to": {"x": 1}}, {"k": "feed", "to": {"z": -1}},
                {"k": "dwell", "s": 1}, {"k": "feed", "to": {"z": 0}}])
