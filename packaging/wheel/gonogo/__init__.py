# SPDX-License-Identifier: GPL-3.0-or-later
"""GoNoGo, the master gauge for CNC canned cycles: the program, for those who come from Python."""
import os
import sys
from pathlib import Path


def program():
    """The path of the program that this package carries."""
    return str(Path(__file__).resolve().parent / "bin" / "gonogo")


def main():
    """The command `gonogo`: becomes the program."""
    os.execv(program(), ["gonogo", *sys.argv[1:]])
