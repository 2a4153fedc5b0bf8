#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""compare_verdicts.py RESULTS COMPARED: whether the comparer says of each case what the gauge says."""
import json
import sys

NAMES = {"pass-tolerance": "GO", "oracle-gap": "UNDECIDED", "advice": "ADVICE"}


def main():
    gauge = {}
    with open(sys.argv[1], encoding="utf-8") as file:
        for line in file:
            case = json.loads(line)
            if case.get("verdict", "skip") != "skip":
                gauge[case["id"]] = NAMES.get(case["verdict"], "NO-GO")
    said = {}
    with open(sys.argv[2], encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if len(words) > 1 and words[0].isupper():
                said[words[1].rstrip(":")] = words[0]
    wrong = {case for case in gauge.keys() | said.keys() if gauge.get(case) != said.get(case)}
    for case in sorted(wrong):
        print("FAILED: %s is %s by the gauge, %s by the comparer"
              % (case, gauge.get(case), said.get(case)))
    print("%d cases compared, %d differ" % (len(gauge), len(wrong)))
    return 1 if wrong or not gauge else 0


if __name__ == "__main__":
    sys.exit(main())
