# SPDX-License-Identifier: MIT-0
"""What the adapters for the dialect rs274 say to a profile."""


def refusal(dialect, profile, accepted):
    """None when the dialect is rs274 and every key of `profile` can be set, else a sentence.

    `accepted` maps a key ("initial.x", "readings.ngc.arc-tolerance", "units") to a function of its
    value. A key that it does not have is refused, save a value that says what holds anyway.
    """
    if dialect != "rs274":
        return "The dialect %s is not interpreted here." % dialect
    for key, value in flat(profile):
        test = accepted.get(key) or _HARMLESS.get(key) or _harmless(key)
        if test is None or not test(value):
            return "The profile's %s = %s cannot be set in this interpreter." % (key, value)
    return None


def one_of(*values):
    return lambda value: value in values


def _zero(value):
    try:
        return float(value) == 0
    except (TypeError, ValueError):
        return False


def anything(_value):
    return True


#: Readings whose value in _HARMLESS may be reported.
LOOKED_AT = ["ngc.unused-words", "ngc.program-end"]

_HARMLESS = {
    "units": one_of("mm"), "x_diameter": one_of(False), "alarm_timing": one_of("block"),
    "block_skip": one_of(False), "initial.plane": one_of("G17"),
    "initial.spindle": one_of("M5", "M05"),
    "initial.x": _zero, "initial.y": _zero, "initial.z": _zero, "initial.a": _zero,
    "initial.c": _zero, "initial.f": _zero, "resolution": anything,
    # For a program that is only looked at.
    "readings.ngc.unused-words": one_of("ignored", "any"),
    "readings.ngc.program-end": one_of("free", "any"),
}


def _harmless(key):
    if key.startswith("readings."):
        return one_of("any")  # anything it does is right
    return _zero if key.startswith("offsets.") else None


def flat(profile):
    """The keys of a profile and their values: ("initial.x", "5")."""
    for key, value in profile.items():
        if not isinstance(value, dict):
            yield key, value
        elif key == "readings":
            for name, choice in value.items():
                yield "readings." + name, choice
        else:
            for name, inner in flat(value):
                yield key + "." + name, inner
