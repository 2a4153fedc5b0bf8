# SPDX-License-Identifier: MIT-0
"""Canonical machining functions as NIST's and LinuxCNC's stand-alone interpreters print them.

A line is a count, the program's own N word (not a line number), and the call. Lengths are of the
unit in force, with four decimals.
"""
import collections
import itertools
import math
import re
from decimal import Decimal

CALL = re.compile(r"^\s*\d+\s+N(?:\.*|\d*)\s*([A-Z]\w*)\((.*)\)\s*$")
PLANES = {"CANON_PLANE_XY": ("G17", "xyz"), "CANON_PLANE_XZ": ("G18", "zxy"),
          "CANON_PLANE_YZ": ("G19", "yzx")}
# Calls that one M function makes, and no other. M66 and M70 to M73 make none.
FUNCTIONS = {
    "MIST_ON": 7, "FLOOD_ON": 8, "ORIENT_SPINDLE": 19, "DISABLE_ADAPTIVE_FEED": 52,
    "ENABLE_ADAPTIVE_FEED": 52, "DISABLE_FEED_HOLD": 53, "ENABLE_FEED_HOLD": 53,
    "CHANGE_TOOL_NUMBER": 61, "SET_MOTION_OUTPUT_BIT": 62, "CLEAR_MOTION_OUTPUT_BIT": 63,
    "SET_AUX_OUTPUT_BIT": 64, "CLEAR_AUX_OUTPUT_BIT": 65, "SET_MOTION_OUTPUT_VALUE": 67,
    "SET_AUX_OUTPUT_VALUE": 68,
}
RESET = {"ENABLE_FEED_OVERRIDE", "STOP_SPINDLE_TURNING", "SET_SPINDLE_MODE", "MIST_OFF", "FLOOD_OFF",
         "PALLET_SHUTTLE"}
HALF_A_DIGIT = Decimal("0.00005")
UNITS = {"CANON_UNITS_MM": Decimal(1), "CANON_UNITS_INCHES": Decimal("25.4")}


class Unsupported(Exception):
    """A motion that no record can carry."""


class Calls:
    """Turns canonical calls into records. Each comes with the names of the next few: what a call is
    part of (M6, M30, a tap, the end of the program) shows by what follows."""

    AHEAD = 7

    def __init__(self, emit):
        self.emit = emit
        self.scale, self.feed, self.per_turn = Decimal(1), Decimal(0), False
        self.rotary_feed = Decimal(0)
        # Places are of the machine and in mm; calls give them less the sum of the offsets.
        self.at, self.slack = dict.fromkeys("xyzabc", Decimal(0)), Decimal(0)
        self.offsets = {}
        self.turn = None  # cosine and sine of the angle by which X and Y are turned
        self.plane = PLANES["CANON_PLANE_XY"]
        self.lead = None  # of the path, while the spindle leads
        self.turning, self.exact_path = 5, False
        self.ended = False  # by M2 or M30
        self.taps, self.thread_holds, self.of_both, self.shuttled = False, False, False, False

    def take(self, lines):
        calls = filter(None, map(CALL.match, lines))
        window = collections.deque(itertools.islice(calls, self.AHEAD + 1))
        while window:
            call = window.popleft()
            window.extend(itertools.islice(calls, 1))
            name = call.group(1)
            handler = getattr(self, name.lower(), None)
            if handler:
                self.next = [later.group(1) for later in window]
                handler(*[part.strip() for part in call.group(2).split(",") if part])
            elif name in FUNCTIONS:
                self.emit("m", m=FUNCTIONS[name])

    def use_length_units(self, units):
        # Where the tool stands is printed in the new units from here on; it was rounded in the old.
        if self.scale != UNITS[units]:
            self.slack = HALF_A_DIGIT * (self.scale + UNITS[units])
        self.scale = UNITS[units]

    def set_g5x_offset(self, _system, *words):
        self._offset("system", words)

    def set_g92_offset(self, *words):
        self._offset("g92", words)

    def set_xy_rotation(self, degrees):
        angle = math.radians(float(degrees))
        self.turn = (Decimal(math.cos(angle)), Decimal(math.sin(angle))) if angle else None

    def use_tool_length_offset(self, *words):
        self._offset("tool", " ".join(words).split())  # LinuxCNC's come in threes

    def _offset(self, which, words):
        self.offsets[which] = {axis: Decimal(word) * (self.scale if axis in "xyz" else 1)
                               for axis, word in zip("xyzabc", words)}
        # The offset before and this one are rounded, and so is the place on each side of the change.
        self.slack = max(self.slack, 4 * HALF_A_DIGIT * self.scale)

    def select_plane(self, plane):
        if plane not in PLANES:
            raise Unsupported("The plane %s has no place in a record." % plane)
        self.plane = PLANES[plane]

    def set_feed_rate(self, feed):
        # A feed of degrees has no unit of length.
        self.rotary_feed, self.feed = Decimal(feed), Decimal(feed) * self.scale

    def set_feed_mode(self, _spindle, mode):
        self.per_turn = mode == "1"

    def set_motion_control_mode(self, mode, *_tolerance):
        self.exact_path = mode == "CANON_EXACT_PATH"

    def dwell(self, seconds):
        self.emit("dwell", s=Decimal(seconds))

    def straight_traverse(self, *words):
        self.emit("rapid", to=self._go("xyz", words[:3], words[3:]))

    def straight_feed(self, *words):
        if self.lead is not None:
            self._thread(self._place("xyzabc", words))
            return
        at, slack = self.at, self.slack
        to = self._go("xyz", words[:3], words[3:])
        turns_only = all(abs(to[axis] - at[axis]) <= slack for axis in "xyz")
        self.emit("feed", to=to, **self._feeds(turns_only))

    def arc_feed(self, end1, end2, centre1, centre2, turn, axial, *rotary):
        plane, axes = self.plane
        centre = self._place(axes, (centre1, centre2))
        self.emit("arc", to=self._go(axes, (end1, end2, axial), rotary), plane=plane,
                  c=centre, rot=int(turn), **self._feeds())

    # Threads: the lead is one of the path.
    def start_speed_feed_sync(self, lead, _velocity):
        self.lead = Decimal(lead)

    def stop_speed_feed_synch(self):
        self.lead = None

    def rigid_tap(self, *words):
        back, sense = self.at, self.turning
        self._thread({**back, **self._place("xyz", words)})
        self._turn(7 - sense)
        self._thread(back)
        self._turn(sense)

    def _thread(self, place):
        ways = [abs(place[axis] - self.at[axis]) for axis in "xyz"]
        length = sum(way * way for way in ways).sqrt()
        lead = self.lead * max(ways) / length if length else self.lead
        self.at = place
        self.emit("thread", to=_told(place), lead=lead * self.scale, start=Decimal(0))

    # M functions.
    def start_spindle_clockwise(self, *_spindle):
        self._turn(3)

    def start_spindle_counterclockwise(self, *_spindle):
        self._turn(4)

    def stop_spindle_turning(self, *_spindle):
        if not self._ends() and self.next[:1] != ["CHANGE_TOOL"]:  # M6 stops it too
            self._turn(5)

    def _ends(self):
        """Whether the call is one of those by which M2 and M30 reset the machine."""
        later = list(itertools.dropwhile(RESET.__contains__, self.next))
        return later[:1] == ["PROGRAM_END"]

    def _turn(self, m):
        self.turning = m
        self.emit("m", m=m)

    def change_tool(self, *_pocket):
        self.turning = 5
        self.emit("m", m=6)

    def flood_off(self):
        if not self._ends():
            self.emit("m", m=9)  # with MIST_OFF before it

    def disable_feed_override(self):
        self.thread_holds = self.next[:1] == ["START_SPEED_FEED_SYNC"]  # G76
        self._override_of_feed("DISABLE_SPEED_OVERRIDE")

    def enable_feed_override(self):
        self._override_of_feed("ENABLE_SPEED_OVERRIDE")
        self.thread_holds = self.thread_holds and self.next[:1] == ["START_SPEED_FEED_SYNC"]

    def _override_of_feed(self, of_both):
        self.of_both = self.next[:1] == [of_both]
        if not self.of_both and not self.thread_holds and not self._ends():
            self.emit("m", m=50)

    def disable_speed_override(self, *_spindle):
        # A tap does it as M49 does.
        self.taps = self.exact_path and self.next[:2] == ["STRAIGHT_FEED", "STOP_SPINDLE_TURNING"]
        self._override_of_spindle(49)

    def enable_speed_override(self, *_spindle):
        self._override_of_spindle(48)
        self.taps = False

    def _override_of_spindle(self, of_both):
        if not self.taps:
            self.emit("m", m=of_both if self.of_both else 51)
        self.of_both = False

    def pallet_shuttle(self):
        self.emit("m", m=30 if self.next[:1] == ["PROGRAM_END"] else 60)
        self.shuttled = True

    def program_stop(self):
        self._stop(0)

    def optional_program_stop(self):
        self._stop(1)

    def program_end(self):
        self.ended = True
        self._stop(2)

    def _stop(self, m):
        if not self.shuttled:
            self.emit("m", m=m)
        self.shuttled = False

    def _feeds(self, turns_only=False):
        return {"f": self.rotary_feed if turns_only else self.feed,
                "fm": "rev" if self.per_turn else None}

    def _go(self, axes, words, rotary):
        """Moves to a point of the program; what a record says of it."""
        self.at, self.slack = self._place([*axes, *"abc"], [*words, *rotary[:3]]), Decimal(0)
        return _told(self.at)

    def _place(self, axes, words):
        place = {axis: Decimal(word) * (self.scale if axis in "xyz" else 1)
                 + self.offsets.get("g92", {}).get(axis, 0) for axis, word in zip(axes, words)}
        if self.turn:
            if not {"x", "y"} <= place.keys():
                raise Unsupported("A turned arc out of the plane XY has no place in a record.")
            (cosine, sine), x, y = self.turn, place["x"], place["y"]
            place["x"], place["y"] = x * cosine - y * sine, x * sine + y * cosine
        others = [offset for name, offset in self.offsets.items() if name != "g92"]
        return {axis: word + sum(offset.get(axis, 0) for offset in others)
                for axis, word in place.items()}


def _told(place):
    if place["b"]:
        raise Unsupported("The axis B has no place in a record.")
    return {axis: place[axis] for axis in "xyzac"}
