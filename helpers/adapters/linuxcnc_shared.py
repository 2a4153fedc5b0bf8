# SPDX-License-Identifier: MIT-0
"""What both LinuxCNC adapters share: classes of messages, the end of a program, the version."""
import ctypes
import os
import re
import subprocess

FEATURES = ["basic", "arc", "arc-r", "helix", "planes", "arc-distance", "turns", "lines"]

# Only what is certain. A message that is not here goes out without a class, for the alarm map.
_CLASSES = [(re.compile(pattern), cls) for pattern, cls in [
    (r"Bad character '|bad number format|Unclosed comment|Nested comment|No characters found in "
     r"reading real|Unknown word where unary operation could be|Bad format unsigned integer", "syntax"),
    (r"Unknown [gm] code used|G-code out of range", "undefined-code"),
    (r"Multiple \S+ words on one line|Two [gm] codes used from same modal group", "duplicate-word"),
    (r"Mixed radius ijk format", "conflicting-words"),
    (r"Cannot use axis values without a g code|words? (all )?missing for arc|word missing in "
     r"absolute center arc|Dwell time missing with g4", "missing-word"),
    (r"[IJK] word given for arc in", "axis-not-in-plane"),
    (r"with zero feed rate", "feed-missing"),
    (r"Radius to end of arc differs|Current point same as end point of arc", "arc-end-point"),
    (r"Arc radius too small|Zero-radius arc", "arc-radius"),
    (r"P value not an integer|Non integer value for integer", "not-an-integer"),
    (r"^[A-Z] word with no ", "unused-word"),
    (r"File ended with no percent sign", "program-end"),
]]

#: The readings that LinuxCNC follows, as the profile names them.
READINGS = {
    "readings.ngc.arc-tolerance": lambda value: value in ("linuxcnc", "any"),
    "readings.ngc.full-circle-words": lambda value: value in ("free", "any"),
    "readings.ngc.whole": lambda value: value in ("linuxcnc", "any"),
    "readings.ngc.g80-beside": lambda value: value in ("ignored", "any"),
    "readings.ngc.unused-words": lambda value: value in ("alarm", "any"),
    "readings.ngc.line-number": lambda value: value in ("decimal", "any"),
    "readings.ngc.o-name": lambda value: value in ("passed-over", "any"),
    "readings.ngc.program-end": lambda value: value in ("needed", "any"),
    "readings.ngc.bare-motion": lambda value: value in ("nothing", "any"),
    "readings.ngc.arc-words-alone": lambda value: value in ("arc", "any"),
}


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
