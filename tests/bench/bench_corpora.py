# SPDX-License-Identifier: GPL-3.0-or-later
"""Corpora for the benchmarks, of any number of cases."""
import json
import os

CASES_OF_A_FILE = 1000


def line_groups():
    """Cases of three blocks: a rapid, a feed, the end."""
    cases = [{"id": "", "comment": "", "provenance": "bench",
              "program": "G0 X%d Y1\nG1 X%d Y2 F100\nM2\n" % (i, i),
              "expect": [{"records": [{"k": "end", "to": {axis: "0" for axis in "xyzac"}}]}],
              "tags": {"tway": [], "sign": []}} for i in range(1, 501)]
    yield "lines", {"gid": "lines", "features": ["basic"], "clauses": [], "profile": {},
                    "cases": cases}


def write_corpus(folder, dialect, groups, count):
    """`count` cases in files of CASES_OF_A_FILE, the groups one after the other again and again."""
    groups = list(groups)
    files, held, number = [], [], 0

    def flush():
        if not held:
            return
        name = "vectors/%s/bench-%06d.json" % (dialect, len(files))
        files.append(name)
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            json.dump({"format": 1, "corpus": "bench", "dialect": dialect, "cycle": "bench",
                       "groups": held}, file)
        held.clear()

    size = 0
    while number < count:
        for _, group in groups:
            cases = []
            for case in group["cases"]:
                if number < count:
                    cases.append({**case, "id": "bench.%08d" % number})
                    number += 1
            if cases:
                held.append({**group, "gid": "bench.%d" % len(held), "cases": cases})
                size += len(cases)
            if size >= CASES_OF_A_FILE:
                flush()
                size = 0
    flush()
    with open(os.path.join(folder, "manifest.json"), "w") as file:
        json.dump({"format": 1, "version": "bench", "license": "CC0-1.0", "files": files,
                   "retired": []}, file)
