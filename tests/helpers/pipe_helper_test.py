# SPDX-License-Identifier: GPL-3.0-or-later
"""Both protocol helpers, spoken to as the runner speaks: `pipe_helper_test.py python|node`."""
import json
import os
import sys
import unittest

from talk import Talk

HERE = os.path.dirname(os.path.abspath(__file__))
PYTHON = [sys.executable, "-B", os.path.join(HERE, "sample_subject.py")]
NODE = [os.environ.get("GONOGO_NODE") or "node", os.path.join(HERE, "sample_subject.mjs")]


class Protocol:
    """What holds for the helper in either language."""

    command = None

    def setUp(self):
        self.talk = Talk(self.command)
        self.addCleanup(self.talk.__exit__)

    def run_one(self, program):
        self.talk.start()
        return self.talk.run(program)[0]

    def test_start_says_who_the_subject_is(self):
        begun, configured = self.talk.start()
        self.assertEqual(begun, {
            "protocol": 1, "subject": {"name": "sample", "version": "1.2"},
            "dialects": {"rs274": ["basic"]}, "features": ["blocks", "bytes"],
            "readings": [], "numeric": {"kind": "binary64"}, "max_in_flight": 16})
        self.assertEqual(configured, {"ok": True})

    def test_a_protocol_that_is_not_offered_is_refused(self):
        for offered in ([2], None, "1"):
            self.assertIs(self.talk.ask({"cmd": "start", "protocol": offered})["ok"], False)

    def test_configure_gives_the_subjects_refusal(self):
        self.assertEqual(self.talk.configure("rs274", {"units": "inch"}),
                         {"ok": False, "message": "units"})

    def test_an_exception_in_configure_is_a_refusal(self):
        reply = self.talk.configure("rs274", {"break": True})
        self.assertIs(reply["ok"], False)
        self.assertIn("configure broke", reply["message"])
        self.assertEqual(self.talk.configure("rs274", {}), {"ok": True})

    def test_a_program_after_a_refused_configuration_is_an_error(self):
        self.talk.start()
        self.talk.configure("rs274", {"units": "inch"})
        self.assertEqual(self.talk.run("length x")[0]["outcome"], "error")

    def test_an_alarm_has_the_records_before_it(self):
        self.assertEqual(self.run_one("alarm"), {
            "seq": 1, "outcome": "alarm", "records": [{"k": "rapid", "b": 1, "to": {"x": "1"}}],
            "alarm": {"native": "E61", "class": "feed-missing", "b": 2, "word": "F"}})

    def test_a_skip_names_the_feature(self):
        self.assertEqual(self.run_one("skip"), {"seq": 1, "outcome": "skip", "records": [],
                                                "feature": "turns", "message": "no turns here"})

    def test_an_exception_is_an_error_and_the_process_lives_on(self):
        reply = self.run_one("boom")
        self.assertEqual((reply["outcome"], len(reply["records"])), ("error", 1))
        self.assertIn("unheard of", reply["message"])
        self.assertEqual(self.talk.run("exit")[0]["outcome"], "error")
        self.assertEqual(self.talk.run("length abc")[0]["records"], [{"k": "dwell", "s": "3"}])

    def test_what_is_no_number_is_an_error(self):
        self.assertEqual(self.run_one("nan")["outcome"], "error")

    def test_an_unknown_kind_of_record_is_an_error(self):
        self.assertEqual(self.run_one("kind")["outcome"], "error")

    def test_prints_go_to_standard_error(self):
        reply = self.run_one("print")
        self.assertEqual((reply["outcome"], len(reply["records"])), ("ok", 1))
        code, complaints = self.talk.stop()
        self.assertEqual(code, 0)
        self.assertIn("printed while it is made", complaints)
        self.assertEqual(complaints.count("noise on"), 2)

    def test_bad_json_is_answered_and_survived(self):
        for line in ("{\n", "[1\n", "7\n", "null\n", '"run"\n', "{}\n", '{"cmd":["run"]}\n',
                     '{"cmd":"dance"}\n', b'\xff\xfe{"cmd":\n'):
            self.talk.write(line)
            reply = json.loads(self.talk.line())
            self.assertIs(reply["ok"], False, line)
            self.assertTrue(reply["message"], line)
        self.assertEqual(self.run_one("length abc")["outcome"], "ok")

    def test_a_program_that_is_neither_text_nor_base64_is_an_error(self):
        self.talk.start()
        for program in (None, 7, ["G0"], {"base64": 7}, {"base64": "a"}, {"base64": "?!=="}, {}):
            self.talk.send({"cmd": "run", "seq": 5, "id": "x", "program": program})
            reply = json.loads(self.talk.line())
            self.assertEqual((reply["seq"], reply["outcome"]), (5, "error"), program)

    def test_base64_brings_every_byte(self):
        data = bytes(range(256))
        # 0 + 1 + ... + 255
        self.assertEqual(self.run_one(b"sum " + data)["records"], [{"k": "dwell", "s": "32640"}])

    def test_a_text_is_given_as_utf_8(self):
        # 2 bytes of UTF-8, 3 of them, and U+2028 (3 bytes), which JSON may carry as it is.
        self.assertEqual(self.run_one("length \u00e9\u5916\u2028")["records"],
                         [{"k": "dwell", "s": "8"}])

    def test_a_big_program_arrives_whole(self):
        size = 8 << 20
        self.assertEqual(self.run_one("length " + "x" * size)["records"],
                         [{"k": "dwell", "s": str(size)}])

    def test_many_records_come_in_parts(self):
        self.talk.start()
        reply, parts = self.talk.run("many 25000")
        self.assertEqual(parts, 25)
        self.assertEqual([record["to"]["x"] for record in reply["records"]],
                         [str(i) for i in range(25000)])

    def test_runs_sent_ahead_are_answered_in_order(self):
        self.talk.start()
        for seq in range(1, 17):
            self.talk.send({"cmd": "run", "seq": seq, "id": "x", "program": "many 3"})
        self.assertEqual([json.loads(self.talk.line())["seq"] for _ in range(16)],
                         list(range(1, 17)))

    def test_reset_reaches_the_subject(self):
        self.talk.start()
        kept = []
        for _ in range(2):
            kept.append(self.talk.run("keep")[0]["records"][0]["s"])
        self.assertEqual(self.talk.ask({"cmd": "reset"}), {"ok": True})
        kept.append(self.talk.run("keep")[0]["records"][0]["s"])
        self.assertEqual(kept, ["1", "2", "1"])

    def test_the_end_of_the_input_ends_the_process(self):
        self.talk.start()
        self.talk.process.stdin.close()
        self.assertEqual(self.talk.process.wait(timeout=20), 0)

    def test_a_runner_that_has_gone_ends_the_process(self):
        self.talk.start()
        self.talk.process.stdout.close()
        self.talk.send({"cmd": "run", "seq": 1, "id": "x", "program": "many 25000"})
        self.assertEqual(self.talk.process.wait(timeout=20), 0)

    def test_a_last_line_without_line_end_is_read(self):
        self.talk.write('{"cmd":"reset"}')
        self.talk.process.stdin.close()
        self.assertEqual(json.loads(self.talk.line()), {"ok": True})


class PythonHelper(Protocol, unittest.TestCase):
    command = PYTHON

    def test_numbers_are_exact(self):
        # 0.1 as a double is 0x1.999999999999ap-4; Decimal and Fraction keep what they hold.
        self.assertEqual(self.run_one("numbers")["records"], [{
            "k": "feed", "b": 1, "f": "11/3",
            "to": {"x": "0x1.999999999999ap-4", "y": "0.10", "z": {"root": ["0", "1", "2"]},
                   "a": "-0x0.0p+0", "c": "7"}}])


class JavaScriptHelper(Protocol, unittest.TestCase):
    command = NODE

    def test_numbers_are_the_shortest_that_come_back(self):
        self.assertEqual(self.run_one("numbers")["records"], [{
            "k": "feed", "b": 1, "f": "11/3",
            "to": {"x": "0.1", "y": "1e-7", "z": {"root": ["0", "1", "2"]}, "a": "0", "c": "7"}}])


if __name__ == "__main__":
    TESTS = {"python": "PythonHelper", "node": "JavaScriptHelper"}
    unittest.main(defaultTest=TESTS[sys.argv.pop(1)])
