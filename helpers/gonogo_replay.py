#!/usr/bin/env python3
# SPDX-License-Identifier: MIT-0
"""gonogo_replay.py VECTORS... --traces DIR [--tolerance MM]

Judges recorded outcomes against conformance vectors without the gauge (Python 3.8 or later, no packages).
VECTORS: vector files, or folders of them. DIR: what `gonogo certify --traces DIR` keeps, <id>.jsonl a case
and subject.json. A line a case: GO, NO-GO, OPEN (this reader does not decide it) or SKIP, the id, and why.
Exit code 1 when one is NO-GO, 2 for wrong use.

It follows closed paths, alarms and ends. It says OPEN of a departure where a manual leaves the path open, of
arcs in pieces or as chords, and of what no text states. M functions are not compared. docs/replay.md has the
rules and the traps; gonogo_replay.mjs says the same of every vector.
"""
import argparse
import base64
import json
import math
import os
import re
import sys
from fractions import Fraction

AXES = "xyzac"
PLANES = {"G17": "xy", "G18": "zx", "G19": "yz"}
RESOLUTION = {"gsk988ta": "0.001", "hnc21t": "0.001", "sinumerik802s": "0.001", "sinumerik840d": "0.001",
              "rs274": "0.0001"}
# Roots and enclosures are taken to 40 digits; nothing is decided closer to a limit than this.
NEAR = Fraction(1, 10**12)
RENAMES = re.compile(r"G0*(50|92)(?![0-9.])", re.IGNORECASE)


class Departs(Exception):
    """The subject does something else."""


class Open(Exception):
    """This reader cannot tell."""


def number(value):
    """The value of a number of a record, as a fraction."""
    if isinstance(value, dict) and "root" in value:
        a, b, c = (Fraction(text) for text in value["root"])
        scale = 10**40
        root = Fraction(math.isqrt(c.numerator * c.denominator * scale**2), scale * c.denominator)
        return a + b * root
    if isinstance(value, dict):
        low, high = (Fraction(text) for text in value["enclosure"])
        return (low + high) / 2
    return Fraction(float.fromhex(value)) if "0x" in value.lower() else Fraction(value)


def within(difference, limit):
    """Whether a distance is no more than the limit."""
    excess = abs(difference) - limit
    if 0 < excess <= NEAR:
        raise Open("a distance is too close to the tolerance for this reader")
    return excess <= 0


def agree(p, q, tau):
    return all(within(p[axis] - q[axis], tau) for axis in AXES)


class Motion:
    """A motion or a dwell, with both ends."""

    def __init__(self, record, start, is_open=False):
        self.record, self.kind, self.start = record, record["k"], start
        self.end = dict(start, **{axis: number(at) for axis, at in record.get("to", {}).items()})
        self.moved = set(record.get("to", {}))
        self.is_open = is_open  # one of many: the manual leaves it open
        if self.kind == "arc":
            self.first, self.second = PLANES[record["plane"]]
            self.centre = {axis: number(at) for axis, at in record["c"].items()}

    def way(self, axis):
        return self.end[axis] - self.start[axis]

    def turn(self):
        """Positive when the end lies up to half a turn from the start in the sense of the arc."""
        p, q = self.first, self.second
        cp, cq = self.centre[p], self.centre[q]
        cross = ((self.start[p] - cp) * (self.end[q] - cq) - (self.start[q] - cq) * (self.end[p] - cp))
        return cross * self.record["rot"]

    def is_closed(self):
        return self.way(self.first) == 0 and self.way(self.second) == 0

    def is_negligible(self, tau):
        if self.kind == "dwell":
            return number(self.record["s"]) == 0
        if not agree(self.start, self.end, tau):
            return False
        if self.kind != "arc":
            return True
        return abs(self.record["rot"]) == 1 and not self.is_closed() and self.turn() > 0

    def is_short(self, tau):
        """About as short as the tolerance: one side may drop it and the other not."""
        return self.kind != "dwell" and self.start != self.end and agree(self.start, self.end, 2 * tau)

    def continues(self, before):
        """Whether the motion before it and this one are one straight motion."""
        same = ("k", "b", "f", "fm", "lead", "start")
        if any(self.record.get(key) != before.record.get(key) for key in same) or self.is_open != before.is_open:
            return False
        mine = [axis for axis in AXES if self.way(axis) != 0]
        if self.kind == "rapid":
            theirs = [axis for axis in AXES if before.way(axis) != 0]
            return mine == theirs and len(mine) == 1 and self.way(mine[0]) * before.way(mine[0]) > 0
        if self.kind not in ("feed", "thread"):
            return False
        parallel = all(self.way(i) * before.way(j) == self.way(j) * before.way(i) for i in AXES for j in AXES)
        return parallel and sum(self.way(axis) * before.way(axis) for axis in AXES) > 0


def path(records, start, tau, open_parts=()):
    """Motions and dwells in order: negligible ones dropped, those that continue joined; where it ends; whether
    one is about as short as the tolerance."""
    motions, here, is_short = [], start, False
    for i, record in enumerate(records):
        if record["k"] in ("m", "end"):
            continue
        motion = Motion(record, here, any(part["from"] <= i < part["to"] for part in open_parts))
        here = motion.end
        is_short = is_short or motion.is_short(tau)
        if motion.is_negligible(tau):
            continue
        if motions and motion.continues(motions[-1]):
            motions[-1].end = motion.end
            motions[-1].moved |= motion.moved
        else:
            motions.append(motion)
    return motions, here, is_short


class Judge:
    """A subject's outcome against one expectation."""

    def __init__(self, case, subject, tolerance):
        self.case = case
        self.blocks = "blocks" in subject["features"]
        numeric = subject.get("numeric", {})
        self.resolution = Fraction(numeric["resolution"]) if "resolution" in numeric else None
        self.feed_resolution = Fraction(numeric["feed_resolution"]) if "feed_resolution" in numeric else None
        self.tau = tolerance or min(filter(None, [self.resolution, resolution_of(case)]))
        start = {axis: Fraction(0) for axis in AXES}
        initial = case["profile"].get("initial", {})
        self.start = dict(start, **{axis: Fraction(initial[axis]) for axis in AXES if axis in initial})

    def judge(self, expectation, trace):
        """Raises Departs or Open."""
        if expectation.get("not_covered"):
            raise Open("the corpus does not cover it")
        try:
            self.follow(expectation, trace)
        except Departs as departs:
            if expectation.get("others"):
                raise Open("an open reading gives other outcomes, too: %s" % departs)
            if expectation["basis"] == "silent":
                raise Open("no text states it: %s" % departs)
            raise

    def follow(self, expectation, trace):
        records = [record for record in trace if record["k"] != "alarm"]
        alarm = trace[-1] if trace and trace[-1]["k"] == "alarm" else None
        admitted = expectation.get("alarm", {}).get("any_of", [])
        if alarm and admitted and self.admits(admitted, alarm) and not path(records, self.start, self.tau)[0] \
                and self.case["profile"].get("alarm_timing") == "program":
            return
        want, end, short_due = path(expectation["records"], self.start, self.tau, expectation.get("open", ()))
        got, _, short_came = path(records, self.start, self.tau)
        last = trace[-1] if trace and trace[-1]["k"] == "end" else {}
        told = {axis: number(at) for axis, at in last.get("to", {}).items()}
        try:
            self.follow_path(want, got, end, told)
        except Departs as departs:
            if short_due or short_came:
                raise Open("a motion is about as short as the tolerance: %s" % departs)
            raise
        if not admitted:
            if alarm:
                raise Departs("it alarms (%s); no alarm is due" % alarm["class"])
        elif not alarm:
            raise Departs("no alarm came; %s is due" % admitted[0]["class"])
        elif not self.admits(admitted, alarm):
            raise Departs("the alarm is %s in line %s; %s in line %s is due"
                          % (alarm["class"], alarm.get("b"), admitted[0]["class"], admitted[0]["b"]))

    def admits(self, admitted, alarm):
        return any(one["class"] in alarm["class"].split() and (not self.blocks or one["b"] == alarm.get("b"))
                   for one in admitted)

    def follow_path(self, want, got, end, told):
        at, progress, seen_open = 0, 0, False
        try:
            for motion in got:
                if at == len(want):
                    raise Departs("a %s too many, in line %s" % (motion.kind, motion.record.get("b")))
                due = want[at]
                seen_open = seen_open or due.is_open
                progress = self.follow_motion(due, motion, progress)
                if progress is None:
                    at, progress = at + 1, 0
            if at < len(want):
                seen_open = seen_open or want[at].is_open
                raise Departs("a %s of line %s is missing" % (want[at].kind, want[at].record.get("b")))
            if not agree(dict(end, **told), end, self.tau):
                raise Departs("it ends elsewhere")
        except Departs as departs:
            # The end of an open part may be elsewhere, too.
            if seen_open or any(motion.is_open for motion in want[:at + 1]):
                raise Open("the manual leaves the path open: %s" % departs)
            if RENAMES.search(self.case["text"]):
                raise Open("the program renames the position: %s" % departs)
            raise

    def follow_motion(self, due, motion, progress):
        """How far along `due` the subject is behind `motion`; None: at its end."""
        where = "line %s" % due.record.get("b")
        if due.kind != motion.kind:
            if {due.kind, motion.kind} <= {"arc", "arc3", "feed"}:
                raise self.other_kind(due, motion, where)
            raise Departs("%s: a %s is due, a %s came" % (where, due.kind, motion.kind))
        self.compare_labels(due, motion, where)
        if due.kind == "dwell":
            return None
        if due.kind == "rapid":
            return self.follow_rapid(due, motion, where)
        if due.kind in ("arc", "arc3"):
            return self.follow_arc(due, motion, where)
        return self.follow_line(due, motion, progress, where)

    def other_kind(self, due, motion, where):
        if agree(due.end, motion.end, self.tau):
            return Open("%s: a %s for a %s; this reader knows no chords" % (where, motion.kind, due.kind))
        if due.kind == "feed":
            return Departs("%s: a feed is due, an %s came" % (where, motion.kind))
        return Open("%s: a %s for a %s" % (where, motion.kind, due.kind))

    def compare_labels(self, due, motion, where):
        if self.blocks and due.record.get("b") != motion.record.get("b"):
            raise Departs("%s is due, line %s came" % (where, motion.record.get("b")))
        if due.record.get("fm", "min") != motion.record.get("fm", "min"):
            raise Departs("%s: the feed is of another mode" % where)
        for key, resolution in (("f", self.feed_resolution), ("lead", self.resolution), ("start", self.resolution),
                                ("s", self.resolution)):
            if key not in due.record:
                continue
            wanted, given = number(due.record[key]), number(motion.record[key])
            difference = abs(wanted - given)
            if key == "start":
                difference = min(difference % 360, -difference % 360)
            if difference > max(abs(wanted) / 2**51, (resolution or 0) / 2):
                if key != "f" and difference <= self.tau:
                    raise Open("%s: %s differs by no more than the tolerance" % (where, key))
                raise Departs("%s: %s is %s, %s came" % (where, key, float(wanted), float(given)))

    def follow_rapid(self, due, motion, where):
        for axis in AXES:
            before, after = due.end[axis] - motion.start[axis], due.end[axis] - motion.end[axis]
            if abs(motion.way(axis)) > self.tau and axis not in due.moved:
                raise Departs("%s: %s moves in a traverse that leaves it" % (where, axis.upper()))
            # Beyond the end, or back.
            if not within(after, self.tau) and (after * before < 0 or abs(after) - abs(before) > self.tau):
                raise Departs("%s: the traverse passes its end in %s" % (where, axis.upper()))
        return None if agree(due.end, motion.end, self.tau) else 0

    def follow_line(self, due, motion, progress, where):
        # The stretch of the line, from 0 to 1, of which every point is within the tolerance of the end.
        low, high = Fraction(0), Fraction(1)
        for axis in AXES:
            off, way = motion.end[axis] - due.start[axis], due.way(axis)
            if way == 0:
                if not within(off, self.tau):
                    raise Departs("%s: the %s leaves its line in %s" % (where, due.kind, axis.upper()))
                continue
            bounds = sorted([(off - self.tau) / way, (off + self.tau) / way])
            low, high = max(low, bounds[0]), min(high, bounds[1])
        if low > high:
            if (low - high) * max(abs(due.way(axis)) for axis in AXES) <= NEAR:
                raise Open("a distance is too close to the tolerance for this reader")
            raise Departs("%s: the %s ends elsewhere" % (where, due.kind))
        if high < progress:
            raise Departs("%s: the %s goes back" % (where, due.kind))
        return None if agree(due.end, motion.end, self.tau) else max(progress, low)

    def follow_arc(self, due, motion, where):
        if due.kind == "arc3":
            via = [{axis: number(at) for axis, at in side.record["via"].items()} for side in (due, motion)]
            same = agree(dict(due.start, **via[0]), dict(due.start, **via[1]), self.tau)
            if same and agree(due.end, motion.end, self.tau):
                return None
            raise Open("%s: circles in space are compared by their points alone" % where)
        if due.record["plane"] != motion.record["plane"] or due.record["rot"] * motion.record["rot"] < 0:
            raise Departs("%s: the arc lies in another plane or turns the other way" % where)
        if any(not within(due.centre[axis] - motion.centre[axis], self.tau) for axis in due.centre):
            raise Departs("%s: the centre is elsewhere" % where)
        if not agree(due.end, motion.end, self.tau) or due.record["rot"] != motion.record["rot"]:
            raise Open("%s: the arc comes in other pieces, or ends elsewhere" % where)
        return None


def resolution_of(case):
    profile = case["profile"]
    fine = "0.0001" if profile.get("increment") == "ISC" else RESOLUTION[case["dialect"]]
    return Fraction(profile.get("resolution", fine))


def verdict(case, subject, trace, tolerance=None):
    """GO, NO-GO or OPEN, and why. An expectation that fits is enough: the subject may follow its readings."""
    judge = Judge(case, subject, tolerance)
    reasons = []
    for expectation in case["expect"]:
        try:
            judge.judge(expectation, trace)
            return "GO", ""
        except (Departs, Open) as other:
            reasons.append(other)
    undecided = [str(reason) for reason in reasons if isinstance(reason, Open)]
    return ("OPEN", undecided[0]) if undecided else ("NO-GO", str(reasons[0]))


def cases(names):
    """The cases of vector files and folders, each with its dialect, features, profile and text."""
    files = [os.path.join(folder, file) for name in names for folder, _, found in os.walk(name) for file in found
             if file.endswith(".json")] + [name for name in names if os.path.isfile(name)]
    for file in sorted(files):
        with open(file, encoding="utf-8") as stream:
            vectors = json.load(stream)
        if vectors.get("format") != 2:
            sys.exit("%s: not a vector file of format 2." % file)
        for group in vectors["groups"]:
            for case in group["cases"]:
                text = case["program"]
                text = text if isinstance(text, str) else base64.b64decode(text["base64"]).decode("latin-1")
                yield dict(case, dialect=vectors["dialect"], profile=group["profile"], features=group["features"],
                           text=text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vectors", nargs="+")
    parser.add_argument("--traces", required=True)
    parser.add_argument("--tolerance", type=Fraction)
    options = parser.parse_args()
    try:
        with open(os.path.join(options.traces, "subject.json"), encoding="utf-8") as stream:
            subject = json.load(stream)
    except OSError as error:
        sys.exit("%s: name the folder that `gonogo certify --traces` wrote." % error)
    count = {"GO": 0, "NO-GO": 0, "OPEN": 0, "SKIP": 0}
    for case in cases(options.vectors):
        declared = subject["dialects"].get(case["dialect"])
        if declared is None or not set(case["features"]) <= set(declared) | set(subject["features"]):
            word, why = "SKIP", "the subject does not declare what it needs"
        else:
            try:
                with open(os.path.join(options.traces, case["id"] + ".jsonl"), encoding="utf-8") as stream:
                    trace = [json.loads(line) for line in stream if line.strip()]
                word, why = verdict(case, subject, trace, options.tolerance)
            except FileNotFoundError:
                word, why = "SKIP", "there is no trace of it"
        count[word] += 1
        print("%-5s %s  %s" % (word, case["id"], why) if why else "%-5s %s" % (word, case["id"]))
    print(", ".join("%d %s" % (number_of, word) for word, number_of in count.items()))
    sys.exit(1 if count["NO-GO"] else 0)


if __name__ == "__main__":
    main()
