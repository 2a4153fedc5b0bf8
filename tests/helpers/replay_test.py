#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""replay_test.py GONOGO CORPUS [NODE]: the small readers against the gauge, on what the built-in expanders do.

Sound, and with a planted fault of each dialect, on every fourth case: where a reader decides, it says what the gauge
says, and both readers print the same; it decides nearly all cases whose path is closed, and finds each fault."""
import json
import os
import subprocess
import sys
import tempfile

HELPERS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "helpers")
# For each subject: its dialect, a planted fault, and which part of the judged cases is closed.
SUBJECTS = {"gsk": ("gsk988ta", "taper-sign", 0.65), "hnc": ("hnc21t", "withdrawal-twice", 0.98),
            "ngc": ("rs274", "g3-clockwise", 0.98), "sinumerik": ("sinumerik840d", "centre-absolute", 0.9)}


def outcomes(command):
    """The words of a reader by case, and all that it printed."""
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit("%s ends with %d: %s" % (" ".join(command), done.returncode, done.stderr[-2000:]))
    lines = [line.split() for line in done.stdout.splitlines()[:-1]]
    return {words[1]: words[0] for words in lines}, done.stdout


def check(gonogo, corpus, node, spec, dialect):
    """Runs a subject on a fourth of the corpus and both readers; how many cases were decided, how many departures
    found."""
    with tempfile.TemporaryDirectory() as work:
        traces = os.path.join(work, "traces")
        subprocess.run([gonogo, "certify", "--subject", "builtin:" + spec, "--dialect", dialect, "--corpus", corpus,
                        "--causes", "0", "--fresh", "0", "--shard", "1/4", "--report", work, "--traces", traces],
                       capture_output=True)
        with open(os.path.join(work, "results.jsonl"), encoding="utf-8") as stream:
            verdicts = {line["id"]: line["verdict"] for line in map(json.loads, stream) if "id" in line}
        vectors = os.path.join(corpus, "vectors", dialect)
        words, python = outcomes([sys.executable, "-B", os.path.join(HELPERS, "gonogo_replay.py"), vectors,
                                  "--traces", traces])
        if node:
            _, script = outcomes([node, os.path.join(HELPERS, "gonogo_replay.mjs"), vectors, "--traces", traces])
            first = [pair for pair in zip(python.splitlines(), script.splitlines())
                     if pair[0].split()[:2] != pair[1].split()[:2]]
            assert not first, "%s: the readers differ: %s" % (spec, first[0])
    without_trace = {case for case in words if case not in verdicts}
    assert all(words.pop(case) == "SKIP" for case in without_trace), "%s: decided without a trace" % spec
    assert set(words) == set(verdicts), "%s: other cases" % spec
    for case, word in words.items():
        verdict = verdicts[case]
        # Readings that no other case admits are an answer of the whole run; a reader has one case.
        is_go, departs = verdict.startswith("pass") or verdict == "fail.reading", verdict.startswith("fail")
        assert word != "GO" or is_go, "%s: %s is %s; the reader says GO" % (spec, case, verdict)
        assert word != "NO-GO" or departs, "%s: %s is %s; the reader says NO-GO" % (spec, case, verdict)
        assert (word == "SKIP") == (verdict == "skip"), "%s: %s is %s; the reader says %s" % (spec, case, verdict, word)
    found = sum(word == "NO-GO" for word in words.values())
    return sum(word in ("GO", "NO-GO") for word in words.values()), len(verdicts) - list(words.values()).count("SKIP"), found


def main():
    gonogo, corpus = sys.argv[1:3]
    node = sys.argv[3] if len(sys.argv) > 3 else None
    for subject, (dialect, fault, closed) in SUBJECTS.items():
        decided, judged, found = check(gonogo, corpus, node, subject, dialect)
        print("%s: %d of %d decided" % (subject, decided, judged))
        assert found == 0, "%s: %d departures of a sound expander" % (subject, found)
        assert decided >= closed * judged, "%s: only %d of %d are decided" % (subject, decided, judged)
        _, _, found = check(gonogo, corpus, node, subject + "+" + fault, dialect)
        print("%s+%s: %d departures found" % (subject, fault, found))
        assert found > 0, "%s+%s is not found" % (subject, fault)


main()
