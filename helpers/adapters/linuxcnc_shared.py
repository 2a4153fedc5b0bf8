# SPDX-License-Identifier: MIT-0
"""What both LinuxCNC adapters share: classes of messages, the end of a program, the version."""
import ctypes
import os
import re
import subprocess

FEATURES = ["basic", "arc", "arc-r", "helix", "planes", "arc-distance", "turns", "lines", "g81", "g73",
            "g83", "g84", "g74", "g85", "g86", "cycle-modal", "cycle-steps", "cycle-planes"]
THREADS = ["g33", "g33.1", "g76"]

# Only what is certain. A message that is not here goes out without a class, for the alarm map.
_CLASSES = [(re.compile(pattern), cls) for pattern, cls in [
    (r"Bad character|[Bb]ad number format|Unclosed comment|Nested comment|No characters found in "
     r"reading real|No digits found where|Unknown word where unary operation could be|"
     r"Bad format unsigned integer", "syntax"),
    (r"Unknown [gm] code used|G.code out of range|M code greater than 99", "undefined-code"),
    (r"Multiple \S+ words on one line|Two [gm] codes used from same modal group|"
     r"Too many m codes on line", "duplicate-word"),
    (r"Mixed radius ijk format", "conflicting-words"),
    (r"Cannot use axis values without a g code|words? (all )?missing for arc|word missing in "
     r"absolute center arc|Dwell time missing with g4|All axes missing with motion code|"
     r"R clearance plane unspecified|value unspecified in .. plane canned cycle|"
     r"Q word missing with g|Dwell time p word missing with g8|I J or K words missing with G76",
     "missing-word"),
    (r"K word missing with g33|P word missing with G76", "lead-missing"),
    (r"R less than . in cycle", "reference-plane"),
    (r"Cannot do zero repeats|In G76, I must not be 0|In G76, K must be greater",
     "value-out-of-range"),
    (r"Negative (or zero q value|[hlp] word) used|In G76, J must be greater", "value-sign"),
    (r"Cannot put an? [abc] in canned cycle|Cannot move rotary axes with G76",
     "axis-not-in-plane"),
    (r"[Ss]pindle (\(\d+\) )?not turning in", "spindle-stopped"),
    (r"Spindle turning (counter)?clockwise in G", "direction-conflict"),
    (r"F word used with a g33|canned cycles with cutter compensation|inverse time feed with canned|"
     r"threading cycle with cutter radius compensation", "conflicting-words"),
    (r"[IJK] word given for arc in", "axis-not-in-plane"),
    (r"with zero feed rate", "feed-missing"),
    (r"Radius to end of arc differs|Current point same as end point of arc", "arc-end-point"),
    (r"[Rr]adius too small|Zero.radius arc", "arc-radius"),
    (r"P value not an integer|Non integer value for integer", "not-an-integer"),
    (r"^[A-Z] word with no ", "unused-word"),
    (r"File ended with no percent sign", "program-end"),
]]

#: The readings that LinuxCNC follows, as the profile names them.
READINGS = {"readings.ngc." + name: lambda value, own=own: value in (own, "any")
            for name, own in {
                "arc-tolerance": "linuxcnc", "full-circle-words": "free", "whole": "linuxcnc",
                "g80-beside": "ignored", "unused-words": "alarm", "line-number": "decimal",
                "o-name": "passed-over", "program-end": "needed", "bare-motion": "nothing",
                "arc-words-alone": "arc", "cycle.initial": "series", "cycle.g91-r": "initial",
                "cycle.sticky": "number", "cycle.approach": "initial-level",
                "cycle.initial-kept": "number", "cycle.retract-start": "r-plane",
                "cycle.feed": "needed", "cycle.alarm-at": "late", "g83.retract": "r-plane",
                "g83.return": "rapid", "peck.clearance": "ten-thou", "peck.d": "barred",
                "peck.dwell": "none", "g73.end": "clear", "g85.out": "r-plane", "tap.p": "last",
                "g74.l": "barred", "g33.k": "free", "g76.checks": "linuxcnc",
                "g76.slide": "start", "g76.entry": "thread"}.items()}


def class_of(message):
    """The class of an error message, or None."""
    for pattern, cls in _CLASSES:
        if pattern.search(message):
            return cls
    return None


def version():
    """The version of the installed package."""
    try:
        done = subprocess.run(["dpkg-query", "-W", "-f=${Version}", "linuxcnc-uspace"],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True)
        return done.stdout.decode() or "unknown"
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def home(folder):
    """An environment whose HOME is `folder`: LinuxCNC keeps its tool data there, in .tool.mmap, and
    two interpreters with one home spoil each other's."""
    return {**os.environ, "HOME": folder}


def open_tools(folder):
    """Gives this process LinuxCNC's tool data. Without it the module gcode crashes at a T word."""
    empty = os.path.join(folder, "empty.ngc")
    with open(empty, "wb") as file:
        file.write(b"M2\n")
    subprocess.run(["rs274", "-g", empty], cwd=folder, env=home(folder), check=True,
                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.environ["HOME"] = folder
    # C++'s name of tool_mmap_user(): LinuxCNC has no other door to it that needs no machine.
    ctypes.CDLL("libtooldata.so.0")._Z14tool_mmap_userv()
