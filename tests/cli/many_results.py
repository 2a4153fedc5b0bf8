# SPDX-License-Identifier: GPL-3.0-or-later
"""many_results.py RESULTS OUT FILES CASES: results files OUT/1 to OUT/FILES of so many cases each, made of
the lines of another one under ids of their own; each file departs in other cases."""
import hashlib
import json
import os
import sys

source, out, files, cases = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
with open(source, encoding="utf-8") as text:
    header, *lines = text.read().splitlines()
lines = [json.loads(line) for line in lines[:-1]]
passes = [line for line in lines if line["verdict"].startswith("pass")]
failures = [line for line in lines if line["verdict"].startswith("fail")]


def text_of(line):
    return json.dumps(line, separators=(",", ":"), ensure_ascii=False)


for number in range(1, files + 1):
    folder = os.path.join(out, str(number))
    os.makedirs(folder)
    digest, totals = hashlib.sha256(), {}
    with open(os.path.join(folder, "results.jsonl"), "w", encoding="utf-8") as results:
        results.write(header + "\n")
        for i in range(cases):
            departs = i % 20 == 0 or i % (20 + number) == 0
            line = dict((failures if departs else passes)[i % len(failures if departs else passes)])
            line["id"] = "many.%06d" % i
            results.write(text_of(line) + "\n")
            totals[line["verdict"]] = totals.get(line["verdict"], 0) + 1
            for key in ("us", "attempts", "notes"):
                line.pop(key, None)
            digest.update((text_of(line) + "\n").encode())
        results.write(text_of({"decision": "NO-GO", "head": "NO-GO", "totals": totals, "cases": cases,
                               "judged": cases, "assignments": [], "sha256": digest.hexdigest()}) + "\n")
