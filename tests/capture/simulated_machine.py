#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""simulated_machine.py GONOGO EXPORTED OUT [--fault FAULT] [--interval S] [--jitter PART]

A machine that runs the programs of an export and logs its axes: each motion with a trapezoid of
speed, sampled evenly, as CSV. Faults: deep (all cuts 0.01 too far in z), short (the last cut is
left out), fast and slow (feeds wrong by a fifth), holes (two stretches of the log are lost). Jitter: each
sample comes off its time by up to that part of the interval.
"""
import argparse
import json
import math
import pathlib
import random
import subprocess
import tempfile
from fractions import Fraction

AXES = "xyzac"
PLANES = {"G17": "xy", "G18": "zx", "G19": "yz"}
RAPID = 10_000 / 60  # mm/s
ACCELERATION = 2_000.0  # mm/s^2
SPINDLE = 500 / 60  # turns a second


def number(value):
    if isinstance(value, str):
        return float(Fraction(value)) if "/" in value else float(value)
    if "root" in value:
        a, b, c = (number(part) for part in value["root"])
        return a + b * math.sqrt(c)
    return number(value["enclosure"][0])


def way_at(time, length, speed):
    """How far a move of this length and top speed has come."""
    peak = min(speed, math.sqrt(length * ACCELERATION))
    ramp = peak / ACCELERATION
    whole = length / peak + ramp
    if time < ramp:
        return ACCELERATION * time * time / 2
    if time < whole - ramp:
        return peak * (time - ramp / 2)
    return length - ACCELERATION * (whole - time) ** 2 / 2


def duration(length, speed):
    peak = min(speed, math.sqrt(length * ACCELERATION))
    return length / peak + peak / ACCELERATION


class Machine:
    def __init__(self, interval, fault, jitter=0.0):
        self.interval = interval
        self.jitter = random.Random(39), jitter
        self.fault = fault
        self.at = dict.fromkeys(AXES, 0.0)
        self.now = 0.0
        self.rows = []

    def run(self, seconds, place):
        first = math.ceil(self.now / self.interval - 1e-9)
        last = self.now + seconds
        while first * self.interval < last - 1e-9:
            source, part = self.jitter
            off = source.uniform(-part, part) * self.interval if part else 0.0
            time = min(max(first * self.interval + off, self.now), last - 1e-9)
            self.log(time / self.interval, place(time - self.now))
            first += 1
        self.now = last

    def log(self, tick, at):
        self.rows.append([f"{tick * self.interval:.4f}"] + [f"{at[axis]:.6f}" for axis in AXES])

    def move(self, place, length, speed):
        if length > 0:
            self.run(duration(length, speed), lambda time: place(way_at(time, length, speed) / length))
        self.at = place(1.0)

    def line(self, to, speed):
        start = dict(self.at)
        ends = [to[axis] - start[axis] for axis in "xyz"]
        length = math.hypot(*ends) or max(abs(to[axis] - start[axis]) for axis in "ac")
        self.move(lambda part: {a: start[a] + part * (to[a] - start[a]) for a in AXES}, length, speed)
        self.at = to

    def arc(self, record, to, speed):
        p, q = PLANES[record["plane"]]
        centre = {axis: number(value) for axis, value in record["c"].items()}
        start = dict(self.at)
        rp, rq = start[p] - centre[p], start[q] - centre[q]
        radius = math.hypot(rp, rq)
        sense = 1 if record["rot"] > 0 else -1
        first = math.atan2(rq, rp)
        sweep = (math.atan2(to[q] - centre[q], to[p] - centre[p]) - first) * sense % (2 * math.pi)
        if sweep < 1e-9:
            sweep = 2 * math.pi
        sweep += 2 * math.pi * (abs(record["rot"]) - 1)
        others = [axis for axis in AXES if axis not in (p, q)]
        height = math.hypot(*(to[axis] - start[axis] for axis in others if axis in "xyz"))

        def place(part):
            angle = first + sense * sweep * part
            at = {axis: start[axis] + part * (to[axis] - start[axis]) for axis in others}
            at[p] = centre[p] + radius * math.cos(angle)
            at[q] = centre[q] + radius * math.sin(angle)
            return at

        self.move(place, math.hypot(radius * sweep, height), speed)
        self.at = to

    def speed_of(self, record):
        factor = {"fast": 1.2, "slow": 0.8}.get(self.fault, 1.0)
        if record["k"] == "rapid":
            return RAPID
        if record["k"] == "thread":
            return number(record["lead"]) * SPINDLE
        feed = number(record["f"]) * factor
        return feed * SPINDLE if record.get("fm") == "rev" else feed / 60

    def take(self, record):
        kind = record["k"]
        if kind == "dwell":
            seconds = number(record["s"])
            self.run(seconds, lambda _: self.at)
        if kind not in ("rapid", "feed", "arc", "thread"):
            return
        to = dict(self.at, **{axis: number(value) for axis, value in record["to"].items()})
        if self.fault == "deep" and kind == "feed" and "z" in record["to"]:
            to["z"] -= 0.01
        if kind == "arc":
            self.arc(record, to, self.speed_of(record))
        else:
            self.line(to, self.speed_of(record))


def without_last_cut(records):
    cuts = [i for i, record in enumerate(records) if record["k"] in ("feed", "arc")]
    return [record for i, record in enumerate(records) if not cuts or i != cuts[-1]]


def without_holes(rows):
    """Without two stretches of a twentieth."""
    count = len(rows)
    return [row for i, row in enumerate(rows) if i * 20 // count not in (6, 14)]


def run_program(gonogo, entry, folder, interval, fault, jitter):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as profile:
        profile.write(json.dumps(dict(entry["profile"], dialect=entry["dialect"])))
        profile.flush()
        command = [gonogo, "expand", str(folder / entry["file"]), "--profile", profile.name]
        text = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    records = [json.loads(line) for line in text.stdout.decode().splitlines()]
    if fault == "short":
        records = without_last_cut(records)
    machine = Machine(interval, fault, jitter)
    for record in records:
        machine.take(record)
    machine.log(math.ceil(machine.now / interval - 1e-9), machine.at)
    rows = [row for before, row in zip([[""]] + machine.rows, machine.rows) if row[0] != before[0]]
    lines = ["t,x,y,z,a,c"] + [",".join(row) for row in (without_holes(rows) if fault == "holes" else rows)]
    lines += [f"alarm,{r['class']},{r['b']}" for r in records if r["k"] == "alarm"]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("gonogo")
    parser.add_argument("exported", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--fault", choices=["deep", "short", "fast", "slow", "holes"])
    parser.add_argument("--interval", type=float, default=0.004)
    parser.add_argument("--jitter", type=float, default=0.0)
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True)
    manifest = (arguments.exported / "manifest.json").read_text()
    (arguments.out / "manifest.json").write_text(manifest)
    for entry in json.loads(manifest)["programs"]:
        csv = run_program(arguments.gonogo, entry, arguments.exported, arguments.interval, arguments.fault,
                          arguments.jitter)
        (arguments.out / (entry["id"] + ".csv")).write_text(csv)


if __name__ == "__main__":
    main()
