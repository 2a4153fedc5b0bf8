# SPDX-License-Identifier: MIT-0
"""What both LinuxCNC adapters share: classes of messages, the end of a program, the version."""
import ctypes
import os
import re
import subprocess
from fractions import Fraction

from rs274_profile import flat

FEATURES = ["basic", "arc", "arc-r", "helix", "planes", "arc-distance", "turns", "lines", "g81", "g73",
            "g83", "g84", "g74", "g85", "g86", "cycle-modal", "cycle-steps", "cycle-planes", "offsets",
            "parameters", "o-words", "rotary", "feed-modes", "local-offsets", "subprograms",
            "linuxcnc", "polar-words"]
THREADS = ["g33", "g33.1", "g76"]

# Only what is certain. A message that is not here goes out without a class, for the alarm map.
_CLASSES = [(re.compile(pattern), cls) for pattern, cls in [
    (r"Bad character|[Bb]ad number format|Unclosed comment|Nested comment|No characters found in "
     r"reading real|No digits found where|Unknown word where unary operation could be|"
     r"Bad format unsigned integer|undefined O-word label|duplicate O-word label|redefining sub|"
     r"[Nn]ested subroutine definition|not in a subroutine definition|no matching .*label|"
     r"after O-word|Left bracket missing|Too many subroutine parameters|Unclosed expression|"
     r"Slash missing after first atan", "syntax"),
    (r"Unknown [gm] code used|Negative g code used|G.code out of range|M.code greater than \d+", "undefined-code"),
    (r"sub: o.* found in illegal location|^EOF in file.* seeking o-word", "syntax"),
    (r"Line number greater than|Command too long", "syntax"),
    (r"Multiple \S+ words on one line|Two [gm] codes used from same modal group|"
     r"Too many m codes on line", "duplicate-word"),
    (r"Mixed radius ijk format", "conflicting-words"),
    (r"Cannot use axis values with(out a g code| g80)|words? (all )?missing for arc|word missing in "
     r"absolute center arc|Dwell time missing with g4|All axes missing with motion code|"
     r"R clearance plane unspecified|value unspecified in .. plane canned cycle|"
     r"Q word missing with g|Dwell time p word missing with g8|I J or K words missing with G76|"
     r"All axes missing with g52 or g92|G10 does not have L|polar coordinates is indeterminate|"
     r"Must specify angle in polar", "missing-word"),
    (r"K word missing with g33|P word missing with G76", "lead-missing"),
    (r"R less than . in cycle", "reference-plane"),
    (r"Cannot do zero repeats|In G76, I must not be 0|In G76, K must be greater",
     "value-out-of-range"),
    (r"P value out of range|Parameter number out of range|Named parameter .* not defined|"
     r"divide by zero|Negative argument to sqrt|Argument to a(sin|cos) out of range|"
     r"Calculation resulted in", "value-out-of-range"),
    (r"Requested tool .* not found", "no-tool"),
    (r"Negative (or zero q value|[a-z] word|spindle speed) used|Negative tool id|In G76, J must be greater", "value-sign"),
    (r"Cannot put an? [abc] in canned cycle|Cannot move rotary axes with G76",
     "axis-not-in-plane"),
    (r"[Ss]pindle (\(\d+\) )?not turning in", "spindle-stopped"),
    (r"Spindle turning (counter)?clockwise in G", "direction-conflict"),
    # Either one: the text is the same.
    (r"[Ss]pindle (\(\d+\) )?not turning (counter)?clockwise in",
     "spindle-stopped direction-conflict"),
    (r"F word used with a g33|canned cycles with cutter compensation|inverse time feed with canned|"
     r"threading cycle with cutter radius compensation|two g codes that both use axis values|"
     r"Cannot use g53 incremental|Must use g0 or g1 with g53|both polar coordinate and", "conflicting-words"),
    (r"[IJK] word given for arc in", "axis-not-in-plane"),
    (r"with zero feed rate", "feed-missing"),
    (r"Radius to end of arc differs|Current point same as end point of arc", "arc-end-point"),
    (r"[Rr]adius too small|Zero.radius arc", "arc-radius"),
    (r"P value not an integer|Non integer value for integer", "not-an-integer"),
    (r"^[A-Z] word with no |R not allowed in G10", "unused-word"),
    (r"File ended with no percent sign", "program-end"),
    (r"^\s*no part$", "program-end"),  # what the corpus has behind (abort,
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
                "cycle.feed": "needed", "cycle.alarm-at": "late",
                "cycle.alarm-at-q": "hole", "g83.retract": "r-plane",
                "g83.return": "rapid", "peck.clearance": "ten-thou", "peck.d": "barred",
                "peck.dwell": "none", "g73.end": "clear", "g85.out": "r-plane", "tap.p": "last",
                "g74.l": "barred", "g33.k": "free", "g76.checks": "linuxcnc",
                "g92-other-axes": "kept", "g28-axes": "named", "g10-p0": "in-force",
                "g43-without-h": "loaded", "logic-order": "last", "equal": "ten-thousandth",
                "call-parameters": "zero",
                "missing-tool": "alarm", "g94-feed": "none", "feed-units": "before",
                "lone-cr": "blank", "alarm-dwell": "dwells", "sign-of-value": "taken", "g76.slide": "start", "g76.entry": "thread"}.items()}

#: Their names, for what the subject says of itself.
NAMES = [key[len("readings."):] for key in READINGS]

MM = Fraction(127, 5)  # both interpreters are of a machine of inches
SYSTEMS = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"]
_LETTERS = "xyzabc"
_PLACES = re.compile(r"(offsets\.(%s)|reference_point)\.[xyzac]|parameters\.518[12346]|"
                     r"tools\.\d{1,5}\.(length|radius)" % "|".join(map(re.escape, SYSTEMS)))


def settable(profile):
    """What refusal() has to accept of a profile beside the readings: places, tools and G30."""
    return {key: _is_decimal for key, _ in flat(profile) if _PLACES.fullmatch(key)}


def parameters(profile):
    """The parameter file of a profile: reference points, systems, and G54 in force."""
    values = {5220: Fraction(1)}

    def put(first, place):
        for axis, value in place.items():
            at = _LETTERS.index(axis)
            values[first + at] = _inches(value) if at < 3 else Fraction(value)

    put(5161, profile.get("reference_point", {}))
    put(5181, {_LETTERS[int(number) - 5181]: value
               for number, value in profile.get("parameters", {}).items()})
    for system, place in profile.get("offsets", {}).items():
        put(5221 + 20 * SYSTEMS.index(system), place)
    return "".join("%d\t%r\n" % (number, float(value)) for number, value in sorted(values.items()))


def tools(profile):
    """The tools of a profile by pocket, as the module gcode asks for them: number, offsets of nine
    axes, diameter, angles, orientation."""
    return {pocket: (int(number), 0.0, 0.0, float(_inches(tool.get("length", 0))), *6 * (0.0,),
                     float(2 * _inches(tool.get("radius", 0))), 0.0, 0.0, 0)
            for pocket, (number, tool) in enumerate(profile.get("tools", {}).items(), 1)}


def tool_table(profile):
    """The tool table of a profile as a file."""
    return "".join("T%d P%d Z%r D%r\n" % (tool[0], pocket, tool[3], tool[10])
                   for pocket, tool in tools(profile).items())


def _inches(value):
    return Fraction(value) / MM


def _is_decimal(value):
    return re.fullmatch(r"-?\d+(\.\d+)?", str(value)) is not None


def class_of(message):
    """The class of an error message, or None."""
    for pattern, cls in _CLASSES:
        if pattern.search(message):
            return cls
    return None


def version(package="linuxcnc-uspace"):
    """The version of the installed package."""
    try:
        done = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True)
        return done.stdout.decode() or "unknown"
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def home(folder):
    """An environment whose HOME is `folder`: LinuxCNC keeps its tool data there, in .tool.mmap, and
    two interpreters with one home spoil each other's."""
    return {**os.environ, "HOME": folder}


def load_tools(folder, profile):
    """Fills LinuxCNC's tool data in `folder` with the tools of the profile, if it has some."""
    for name, text in (("empty.ngc", "M2\n"), ("tool.tbl", tool_table(profile))):
        with open(os.path.join(folder, name), "w", encoding="ascii") as file:
            file.write(text)
    subprocess.run(["rs274", *TOOL_OPTIONS, "-g", "empty.ngc"], cwd=folder,
                   env=home(folder), check=True, stdin=subprocess.DEVNULL,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


# Also of a profile without tools: without a table LinuxCNC has three of its own making.
TOOL_OPTIONS = ["-t", "tool.tbl"]


def open_tools(folder):
    """Gives this process LinuxCNC's tool data. Without it the module gcode crashes at a T word."""
    load_tools(folder, {})
    os.environ["HOME"] = folder
    # C++'s name of tool_mmap_user(): LinuxCNC has no other door to it that needs no machine.
    ctypes.CDLL("libtooldata.so.0")._Z14tool_mmap_userv()
