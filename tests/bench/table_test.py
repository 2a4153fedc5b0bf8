# SPDX-License-Identifier: GPL-3.0-or-later
"""table_test.py BUILD GONOGO: every row of the table is there and has its figures, or says which
peer is missing. No figure is looked at."""
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROWS = ("parse gsk988ta", "parse hnc21t", "parse sinumerik840d", "parse rs274", "expand rs274",
        "judge a path, rs274", "judge regions (G110)", "judge threads (G114)", "certify", "hunt",
        "expand rs274 cycles", "judge rs274 cycles", "LinuxCNC rs274 -g", "LinuxCNC rs274 -g, cycles",
        "gcode-toolpath")


def main():
    build, gonogo = sys.argv[1:3]
    done = subprocess.run([sys.executable, "-B", os.path.join(HERE, "table"), "--build", build,
                           "--gonogo", gonogo, "--blocks", "1000", "--quick"],
                          stdout=subprocess.PIPE, text=True, check=True)
    table = done.stdout
    figures = (r"(1,000 blocks|100 programs) \| [\d.]+ \| [\d,]+ [A-Za-z/]+ \| - \| "
               r"[\d.]+ \| [\d.]+ \|")
    missing = r"not measured: .* is not installed.*"
    for row in ROWS:
        if not re.search(r"^\| %s \| (%s|%s)$" % (re.escape(row), figures, missing), table, re.M):
            sys.exit("table_test: no row %r in\n%s" % (row, table))
    if not re.search(r"^\| expand rs274 \| gcode-toolpath \| ([\d.]+|not measured) \|", table, re.M):
        sys.exit("table_test: no ratios in\n%s" % table)


if __name__ == "__main__":
    main()
