#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""peers_table.py SITE.JSON: holds the first table of docs/peers.md against a site of peers (peers-site), for
those interpreters that the site has. Exits with 1 and says what the row has to be where it differs."""
import json
import sys
from pathlib import Path

DOCUMENT = Path(__file__).resolve().parents[2] / "docs/peers.md"
# How the document calls what names itself so.
NAMES = {"linuxcnc-rs274": "LinuxCNC `rs274 -g`", "linuxcnc-gcode": "LinuxCNC module `gcode`", "bcnc": "bCNC",
         "gcode-toolpath": "gcode-toolpath", "freecad-path": "FreeCAD Path", "gcode-preview": "gcode-preview"}


def rows_of(text):
    """The rows of the first table, by their first cell: the numbers behind the version."""
    table = text[text.index("| subject | version"):].split("\n\n", 1)[0].split("\n")[2:]
    cells = [[cell.strip() for cell in row.strip("|").split("|")] for row in table]
    return {row[0]: row[2:] for row in cells}


def numbers_of(run):
    counts = run["counts"]
    return ["{:,}".format(number) for number in (
        sum(counts.values()), counts["go"], counts["skip"], counts["undecided"], counts["known"],
        len(run["causes"]))]


def main(path):
    site = json.loads(Path(path).read_text(encoding="utf-8"))
    told = rows_of(DOCUMENT.read_text(encoding="utf-8"))
    wrong = 0
    for run in site["runs"]:
        name = NAMES.get(run["name"])
        if name is None:
            print("peers.md has no row for %s" % run["name"])
            wrong += 1
        elif told.get(name) != numbers_of(run):
            print("peers.md says of %s: %s, but it is %s" % (name, told.get(name), numbers_of(run)))
            wrong += 1
        # An advice is a departure from what no text states: docs/peers.md speaks of it.
        if run["counts"]["no-go"]:
            print("%s departs where nothing is known" % run["name"])
            wrong += 1
    print("%d rows, %d wrong" % (len(site["runs"]), wrong))
    return 1 if wrong or not site["runs"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
