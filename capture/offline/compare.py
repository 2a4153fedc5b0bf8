#!/usr/bin/env python3
# SPDX-License-Identifier: MIT-0
"""GO or NO-GO of recorded axis positions on the spot, without the gauge.

  python3 compare.py BACK [--tolerance MM] [--feed-tolerance PERCENT] [--alarms FILE] [--only GLOB]

Reads expected.jsonl beside it and BACK/<id>.csv or BACK/<number>.csv. It says what
`gonogo certify --subject capture:BACK` says, as far as it goes: corners that a machine may cut,
columns under other names, recorded records and circles in space are for the gauge.
Exit code: 0 GO, 1 a NO-GO, 2 wrong use, 3 nothing but GO and undecided.
"""
import argparse
import csv
import fnmatch
import json
import math
import os
import re
import sys
from fractions import Fraction

AXES = "xyzac"
UNSURE = 1e-6   # mm; of places along arcs
CLOSE = 1e-9    # nearer to a limit than this is decided exactly
FASTEST = 1000  # mm/s; of what has no feed of its own
NOISE = 1e-9    # s
INFINITY = float("inf")
LIMIT = 1000000  # intervals that tell the rhythm
LONGEST_RAMP = 5    # s; a motion that lasts no longer may be all speeding up and slowing down
LONGEST_STAND = 10  # s; beyond its dwells that a machine may stand at their place


class Undecided(Exception):
    """Neither GO nor NO-GO; the text says why."""


def longest_interval(times, clock):
    """What is longer is a hole; and what passes between two samples as a rule, s."""
    intervals = sorted(b - a for a, b in zip(times[:LIMIT], times[1:LIMIT + 1]))
    if not intervals:
        return INFINITY, 0.0
    quarter, half = (intervals[(len(intervals) - 1) // parts] for parts in (4, 2))
    return min(1.5 * quarter + 4 * (half - quarter), 4 * quarter) + 2 * clock + NOISE, quarter


class Holes:
    """Holes in the samples, and the longest time between two of them."""

    def __init__(self, times, clock):
        self.limit, self.usual = longest_interval(times, clock)
        self.before, self.longest, self.found = None, 0.0, []

    def take(self, point, counts):
        before, self.before = self.before, point.time
        if not counts:
            return
        interval = point.time - before if before is not None else 0.0
        self.longest = max(self.longest, interval)
        if interval > self.limit or point.after_hole:
            self.found.append((str(before), str(point.time)))

    def text(self):
        named = ", ".join("%s s to %s s" % hole for hole in self.found[:10])
        if len(self.found) > 10:
            named += " and %d more" % (len(self.found) - 10)
        return ("the samples have holes, in which the machine may have been anywhere: %s; as a rule "
                "%.6g s pass between two" % (named, self.usual))

    def rate(self):
        return ("up to %.6g s pass between two samples: %.4g mm away from the path and back would "
                "not be seen" % (self.longest, FASTEST * self.longest / 2))


def exact(value):
    """A number of expected.jsonl; of roots and enclosures a neighbour within 1e-15."""
    if isinstance(value, str):
        return Fraction(value)
    if "root" in value:
        a, b, c = (Fraction(part) for part in value["root"])
        scale = 10 ** 40
        return a + b * Fraction(math.isqrt(int(c * scale * scale)), scale)
    low, high = (Fraction(part) for part in value["enclosure"])
    return (low + high) / 2


class Tube:
    def __init__(self, tolerance, strict):
        self.exact = tolerance
        self.half = float(tolerance)
        self.strict = strict
        self.sure = self.half - UNSURE if strict else self.half + UNSURE


def agree(point, other, tube, axes=range(5)):
    """Whether no axis differs by more than the tolerance."""
    for i in axes:
        away = abs(point.near[i] - float(other[i]))
        if away > tube.half + CLOSE:
            return False
        if away > tube.half - CLOSE and abs(point.at(i) - other[i]) > tube.exact:
            return False
    return True


class Point:
    """A sample: decimals as they were written, and as floats."""

    def __init__(self, texts, time, line, number):
        self.texts = texts
        self.near = [float(text) for text in texts]
        self.time = time
        self.line = line
        self.number = number
        self.after_hole = False  # lines without a time stand before it

    def at(self, i):
        return Fraction(self.texts[i])


class Piece:
    """A motion, a dwell, the end of the path, or what is left open."""

    def __init__(self, data):
        self.kind = data["k"]
        self.block = data.get("b", 0)
        self.why = data.get("why", "Circles in space are judged by the gauge alone.")
        if self.kind in ("open", "circle"):
            self.kind = "open"
            return
        self.start = [exact(value) for value in data["from"]]
        self.end = [exact(value) for value in data["to"]]
        self.travel = [b - a for a, b in zip(self.start, self.end)]
        self.start_near = [float(value) for value in self.start]
        self.travel_near = [float(value) for value in self.travel]
        self.seconds = float(exact(data["s"])) if "s" in data else 0.0
        linear = math.sqrt(sum(way * way for way in self.travel_near[:3]))
        self.length = linear or max(abs(way) for way in self.travel_near[3:])
        self.longest = max(range(5), key=lambda i: abs(self.travel_near[i]))
        whole = abs(self.travel_near[self.longest])
        self.scale = self.length / whole if whole else 1.0
        self.has_feed = "f" in data
        self.speed = float(exact(data["f"])) / 60 if self.has_feed else FASTEST
        self.low = [min(float(a), float(b)) for a, b in zip(self.start, self.end)]
        self.high = [max(float(a), float(b)) for a, b in zip(self.start, self.end)]
        if self.kind == "arc":
            self._measure_arc(data)

    def _measure_arc(self, data):
        self.axes = data["axes"]
        self.centre = [exact(value) for value in data["c"]]
        self.middle = [float(value) for value in self.centre]
        p, q = self.axes
        start = (float(self.start[p] - self.centre[0]), float(self.start[q] - self.centre[1]))
        end = (float(self.end[p] - self.centre[0]), float(self.end[q] - self.centre[1]))
        self.from_centre = start
        self.radii = (math.hypot(*start), math.hypot(*end))
        self.sense = -1 if data["rot"] < 0 else 1
        turns = turns_between(start, end) * self.sense
        full = self.start[p] == self.end[p] and self.start[q] == self.end[q]
        if full:
            turns = 1.0
        elif turns <= 0:
            turns += 1
        self.turns = turns + abs(data["rot"]) - 1
        along = (2 * math.pi * self.radii[0] * self.turns) ** 2
        along += sum(self.travel_near[i] ** 2 for i in range(3) if i not in self.axes)
        self.length = math.sqrt(along)
        for i in range(3):
            self.low[i] -= self.length
            self.high[i] += self.length

    def moves(self):
        return self.kind in ("line", "traverse", "arc")

    def time(self):
        if self.kind == "dwell":
            return self.seconds
        return self.length / self.speed if self.speed > 0 else 0.0

    # Stretches are pairs (low, high) of coordinates along the piece; of a traverse one an axis.

    def stretches(self, point, tube):
        if self.kind == "open":
            return [((0.0,) * 5, (0.0,) * 5)]
        if self.kind in ("dwell", "stand"):
            return [((0.0,) * 5, (0.0,) * 5)] if agree(point, self.start, tube) else []
        reach = tube.half + UNSURE
        for value, low, high in zip(point.near, self.low, self.high):
            if value < low - reach or value > high + reach:
                return []
        if self.kind == "arc":
            return self._arc_stretches(point, tube)
        found = self._traverse(point, tube) if self.kind == "traverse" else self._line(point, tube)
        return [found] if found else []

    def _line(self, point, tube):
        low, high = 0.0, abs(self.travel_near[self.longest])
        whole = high
        for i in range(5):
            offset = point.near[i] - self.start_near[i]
            way = self.travel_near[i]
            if self.travel[i] == 0:
                if not agree(point, self.start, tube, (i,)):
                    return None
                continue
            one, other = sorted(((offset - tube.half) / way, (offset + tube.half) / way))
            low, high = max(low, one * whole), min(high, other * whole)
        if low > high + CLOSE:
            return None
        if low > high - CLOSE and not self._line_exactly(point, tube):
            return None
        return ((low,) + (0.0,) * 4, (max(low, high),) + (0.0,) * 4)

    def _line_exactly(self, point, tube):
        low, high = Fraction(0), Fraction(1)
        for i in range(5):
            if self.travel[i] == 0:
                continue
            offset = point.at(i) - self.start[i]
            one, other = sorted(((offset - tube.exact) / self.travel[i],
                                 (offset + tube.exact) / self.travel[i]))
            low, high = max(low, one), min(high, other)
        return low <= high

    def _traverse(self, point, tube):
        low, high = [0.0] * 5, [0.0] * 5
        for i in range(5):
            if self.travel[i] == 0:
                if not agree(point, self.start, tube, (i,)):
                    return None
                continue
            sense = 1 if self.travel[i] > 0 else -1
            way = (point.near[i] - self.start_near[i]) * sense
            whole = abs(self.travel_near[i])
            low[i], high[i] = max(0.0, way - tube.half), min(whole, way + tube.half)
            if high[i] < low[i] - CLOSE:
                return None
            if high[i] < low[i] + CLOSE:
                place = (point.at(i) - self.start[i]) * sense
                if place + tube.exact < 0 or place - tube.exact > abs(self.travel[i]):
                    return None
                high[i] = max(low[i], high[i])
        return tuple(low), tuple(high)

    def _angles(self, at, half):
        """Turns about the direction of the sample of what its box and the circle share."""
        found = []

        def take(p, q):
            found.append(turns_between(at, (p, q)) * self.sense)

        least, most = min(self.radii), max(self.radii)
        for side in (-half, half):
            for radius in self.radii:
                for i in (0, 1):
                    edge = at[i] + side
                    rest = radius * radius - edge * edge
                    if rest < 0:
                        continue
                    for other in (-math.sqrt(rest), math.sqrt(rest)):
                        if abs(other - at[1 - i]) <= half:
                            take(*((edge, other) if i == 0 else (other, edge)))
            for other in (-half, half):
                if least <= math.hypot(at[0] + side, at[1] + other) <= most:
                    take(at[0] + side, at[1] + other)
        if not found:
            return None
        if abs(at[0]) <= half and abs(at[1]) <= half:
            return -0.5, 0.5
        return min(found), max(found)

    def _arc_stretches(self, point, tube):
        low, high = 0.0, self.turns
        for i in range(5):
            if i in self.axes:
                continue
            if self.travel[i] == 0:
                if not agree(point, self.start, tube, (i,)):
                    return []
                continue
            at = point.near[i] - self.start_near[i]
            one, other = sorted(((at - tube.sure) / self.travel_near[i] * self.turns,
                                 (at + tube.sure) / self.travel_near[i] * self.turns))
            low, high = max(low, one), min(high, other)
        if low > high:
            return []
        at = (point.near[self.axes[0]] - self.middle[0], point.near[self.axes[1]] - self.middle[1])
        outer = self._angles(at, tube.half + UNSURE)
        if outer is None:
            return []
        about = outer
        if tube.strict:
            about = self._angles(at, tube.half - UNSURE)
            if about is None:
                about = ((outer[0] + outer[1]) / 2,) * 2
                if not self._touches(at, tube.half):
                    return []
        place = turns_between(self.from_centre, at) * self.sense
        if place < 0:
            place += 1
        found = []
        unit = self.length / self.turns if self.turns > 0 else 0.0
        for turn in range(-1, math.ceil(self.turns) + 1):
            one, other = max(low, place + about[0] + turn), min(high, place + about[1] + turn)
            if one <= other + 1e-12:
                found.append(((min(one, other) * unit,) + (0.0,) * 4, (other * unit,) + (0.0,) * 4))
        return found

    def _touches(self, at, half):
        """Whether the box and the ring of the circle have a point in common, to rounding."""
        near = math.hypot(max(0.0, abs(at[0]) - half), max(0.0, abs(at[1]) - half))
        far = math.hypot(abs(at[0]) + half, abs(at[1]) + half)
        return near <= max(self.radii) + 1e-12 and far >= min(self.radii) - 1e-12

    def along(self, coordinate):
        return coordinate * self.scale if self.kind == "line" else coordinate

    def before(self, stretch):
        return max(stretch[0]) if self.kind == "traverse" else self.along(stretch[0][0])

    def after(self, stretch):
        if self.kind == "traverse":
            return max(abs(way) - high for way, high in zip(self.travel_near, stretch[1]))
        return max(0.0, self.length - self.along(stretch[1][0]))


def turns_between(a, b):
    return math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]) / (2 * math.pi)


def is_ramp(speeds, part):
    """Whether they rise and then fall, but for changes within that part of them."""
    falls = False
    for before, speed in zip(speeds, speeds[1:]):
        if falls and before < speed * part:
            return False
        falls = falls or speed < before * part
    return True


class FeedWatch:
    """Bounds of the feed of one motion."""

    def __init__(self, piece, granted, clock):
        self.piece, self.granted, self.clock = piece, granted, clock
        self.places = []

    def between(self, a, b):
        least, most = b[0] - a[0] - 2 * self.clock, b[0] - a[0] + 2 * self.clock
        low = max(0.0, b[1] - a[2]) / most
        return low, ((b[2] - a[1]) / least if least > 0 else INFINITY)

    def too_fast(self, bounds):
        return bounds[0] > self.piece.speed * (1 + self.granted)

    def add(self, time, low, high):
        self.places.append((time, low, high))
        return len(self.places) > 1 and self.too_fast(self.between(*self.places[-2:]))

    def fault(self):
        places = self.places
        if len(places) < 2:
            return False
        if self.too_fast(self.between(places[0], places[-1])):
            return True
        first, last = len(places) // 4, len(places) - 1 - len(places) // 4
        if last < first + 8:
            return False
        means, most = [], 0.0
        for i in range(4):
            a = places[first + (last - first) * i // 4]
            b = places[first + (last - first) * (i + 1) // 4]
            bounds = self.between(a, b)
            if self.too_fast(bounds):
                return True
            means.append(((b[1] + b[2]) - (a[1] + a[2])) / 2 / (b[0] - a[0]))
            most = max(most, bounds[1])
        part = 1 - self.granted
        if min(means) >= max(means) * part:
            most = self.between(places[first], places[last])[1]
        elif places[-1][0] - places[0][0] <= LONGEST_RAMP and is_ramp(means, part):
            return False
        return most < self.piece.speed * part


class State:
    __slots__ = ("place", "since", "open_since", "start", "inside", "end", "unseen")

    def __init__(self, place, since, open_since=False, seen=(False, False, False), unseen=()):
        self.place, self.since, self.open_since = place, since, open_since
        self.start, self.inside, self.end = seen
        self.unseen = set(unseen)

    def at(self, place):
        return State(place, self.since, self.open_since, (self.start, self.inside, self.end),
                     self.unseen)

    def shows(self):
        return self.inside or (self.start and self.end)


def further(stretch, reached):
    """The part of a stretch that does not lie before a place; None when all of it does."""
    if any(high < low for high, low in zip(stretch[1], reached)):
        return None
    return tuple(max(a, b) for a, b in zip(stretch[0], reached)), stretch[1]


class Run:
    """The samples of a program along one way that it may take."""

    def __init__(self, way, start, tube, seen, header_lines, granted, clock, holes):
        self.holes = holes
        self.pieces = [Piece(data) for data in way["pieces"]]
        self._leave_out_small(start, tube)
        self.start, self.tube, self.seen, self.header_lines = start, tube, seen, header_lines
        self.granted, self.clock = granted, clock
        self.states, self.last_time = {}, 0.0
        self.begun = self.header_seen = False
        self.departure = self.feed_fault = self.open = None
        self.watches, self.cache, self.unseen, self.progress = {}, {}, set(), 0
        self.moved = self.left_end = self.at_end = False
        # Where the machine stands, since when, the dwells there; whether it may have stood before.
        self.place, self.since, self.until, self.dwells, self.is_first = None, 0.0, 0.0, set(), True
        self.long_stands = []
        for piece in self.pieces:
            blind = [i for i in range(5) if piece.moves() and piece.travel[i] != 0 and i not in seen]
            if blind:
                piece.kind = "open"
                piece.why = "The program moves %s, of which there is no column." % AXES[blind[0]]

    def _leave_out_small(self, start, tube):
        """Motions too small to see at this tolerance."""
        kept, stood = [], start
        for piece in self.pieces:
            small = piece.moves() and piece.kind != "arc" and all(
                abs(a - b) <= tube.exact for a, b in zip(stood, piece.end))
            if not small:
                kept.append(piece)
                stood = piece.end if piece.moves() else stood
        self.pieces = kept

    def places(self, i, point):
        if i not in self.cache:
            self.cache[i] = self.pieces[i].stretches(point, self.tube)
        return self.cache[i]

    @staticmethod
    def merge(states, i, state):
        known = states.get(i)
        if known is None:
            states[i] = state
            return
        if all(a <= b for a, b in zip(state.place[0], known.place[0])):
            known.place = state.place
        known.since = min(known.since, state.since)
        known.open_since = known.open_since or state.open_since
        known.start = known.start and state.start
        known.inside = known.inside and state.inside
        known.end = known.end and state.end
        known.unseen |= state.unseen

    def least_time_to(self, piece, place):
        return piece.before(place) / (piece.speed * (1 + self.granted)) if piece.moves() else 0.0

    def least_time(self, piece):
        return piece.time() / (1 + self.granted) if piece.moves() else piece.time()

    def enter(self, origin, before, i, place, states):
        left, piece = self.pieces[origin], self.pieces[i]
        state = State(place, self.last_time, unseen=before.unseen)
        at_start = not piece.moves() or piece.before(place) <= 0
        from_end = not left.moves() or left.after(before.place) <= UNSURE
        if left.moves():
            end = before.end or (i == origin + 1 and at_start)
            if not (before.inside or (before.start and end)):
                state.unseen.add(origin)
        if not (i == origin + 2 and from_end and at_start):
            state.unseen |= {j for j in range(origin + 1, i) if self.pieces[j].moves()}
        state.start = i == origin + 1 and from_end
        self.merge(states, i, state)

    def go_on(self, origin, state, point, states):
        here = self.pieces[origin]
        if here.kind in ("stand", "open"):
            return
        noise = -NOISE if self.tube.strict else NOISE
        spent = 0.0
        if here.kind == "dwell":
            if point.time - state.since + 2 * self.clock + noise < here.time():
                if not state.open_since or self.places(origin, point):
                    return
                state.unseen.add(origin)
        else:
            spent = here.after(state.place) / (here.speed * (1 + self.granted))
        budget = point.time - self.last_time + 2 * self.clock + noise
        i = origin + 1
        while spent <= budget and i < len(self.pieces):
            piece = self.pieces[i]
            for place in self.places(i, point):
                if spent + self.least_time_to(piece, place) <= budget:
                    self.enter(origin, state, i, place, states)
                    break
            if piece.kind in ("stand", "open"):
                return
            spent += self.least_time(piece)
            i += 1

    def begin(self, point):
        spent, passed, i = 0.0, [], 0
        budget = point.time - self.last_time + NOISE
        while spent <= budget and i < len(self.pieces):
            piece = self.pieces[i]
            for place in self.places(i, point):
                if spent + self.least_time_to(piece, place) <= budget:
                    self.merge(self.states, i, State(place, point.time, True, unseen=passed))
                    break
            if piece.kind in ("stand", "open"):
                break
            spent += self.least_time(piece)
            passed.append(i)
            i += 1
        return bool(self.states)

    def take(self, point):
        """The next sample; False when nothing changes the answer any more."""
        in_header = 0 < point.line <= self.header_lines
        self.cache = {}
        if not self.begun:
            approach = (self.header_lines > 0 and not self.header_seen and
                        not agree(point, self.start, self.tube))
            if in_header or approach:
                self.last_time, self.header_seen = point.time, in_header
                self.holes.take(point, False)
                return True
            if not self.header_seen:
                self.last_time = point.time
            self.begun = self.begin(point)
            if not self.begun:
                self.departure = "the samples do not begin at the start position"
        else:
            states = {}
            for i, state in self.states.items():
                for place in self.places(i, point):
                    farther = further(place, state.place[0])
                    if farther:
                        self.merge(states, i, state.at(farther))
                        break
                self.go_on(i, state, point, states)
            if states:
                self.states = dict(sorted(states.items()))
            else:
                self._depart(point)
        if self.departure:
            return False
        self.last_time = point.time
        self.moved = self.moved or not agree(point, self.start, self.tube)
        self.holes.take(point, True)
        self._note_stand(point)
        self._note(point)
        return self.open is None

    def _note_stand(self, point):
        twice = Tube(2 * self.tube.exact, self.tube.strict)
        if self.place is None or not agree(point, self.place, twice):
            beyond = self.until - self.since - sum(self.pieces[i].time() for i in self.dwells)
            if self.dwells and not self.is_first and beyond > LONGEST_STAND:
                self.long_stands.append(self.pieces[max(self.dwells)].block)
            self.is_first = self.place is None
            self.place, self.since, self.dwells = point.near, point.time, set()
        self.until = point.time
        self.dwells |= {i for i in self.states if self.pieces[i].kind == "dwell"}

    def _depart(self, point):
        piece = self.pieces[max(self.states)]
        self.left_end = piece.kind == "stand"
        self.departure = ("it moves after the end" if self.left_end else
                          "line %d: no place of the path fits sample %d (t %g)"
                          % (piece.block, point.number, point.time))

    def _note(self, point):
        for i, state in self.states.items():
            piece = self.pieces[i]
            if piece.moves():
                start, end = piece.before(state.place) <= 0, piece.after(state.place) <= UNSURE
                state.start, state.end = state.start or start, state.end or end
                state.inside = state.inside or not (start or end)
        if len(self.states) == 1:
            (i, state), = self.states.items()
            piece = self.pieces[i]
            if piece.moves() and piece.has_feed:
                watch = self.watches.setdefault(i, FeedWatch(piece, self.granted, self.clock))
                if watch.add(point.time, piece.along(state.place[0][0]),
                             piece.along(state.place[1][0])):
                    self._feed(piece)
        self._close(min(self.states))
        least = self.pieces[min(self.states)]
        if least.kind == "open":
            self.open = least.why

    def _feed(self, piece):
        self.feed_fault = self.feed_fault or "line %d: the feed is not the programmed one" % piece.block

    def _close(self, before):
        for i in set.intersection(*(state.unseen for state in self.states.values())):
            if i < before:
                self.unseen.add(i)
        while self.progress < before:
            watch = self.watches.pop(self.progress, None)
            if watch and watch.fault():
                self._feed(watch.piece)
            self.progress += 1

    def finish(self):
        if self.departure or self.open is not None:
            return
        if not self.begun:
            self.departure = "no sample lies at the start position"
            return
        farthest = max(self.states)
        state, piece = self.states[farthest], self.pieces[farthest]
        self.at_end = piece.kind == "stand"
        if piece.kind == "open":
            self.open = piece.why
        if piece.kind == "dwell":
            self.open = "the samples end before the dwell of line %d does" % piece.block
        complete = piece.moves() and piece.after(state.place) <= UNSURE
        if complete and not state.shows():
            state.unseen.add(farthest)
        self.states = {farthest: state}
        self._close(farthest + 1 if complete else farthest)


def read_samples(path, start):
    """Points, the axes seen, the resolution of the clock, and the alarm (name, line) or None."""
    points, alarm, decimals, in_hole = [], None, 0, False
    with open(path, encoding="utf-8-sig", newline="") as file:
        rows = [row for row in csv.reader(file) if any(cell.strip() for cell in row)]
    names = [name.strip().lower() for name in rows[0]]
    columns = {name: i for i, name in enumerate(names)}
    time = columns.get("t", columns.get("time"))
    if time is None:
        raise Undecided("there is no column of the time: the gauge reads others (--columns)")
    line = columns.get("line", columns.get("block"))
    seen = [i for i, axis in enumerate(AXES) if axis in columns]
    for row in rows[1:]:
        row = [cell.strip() for cell in row]
        if row[0] == "alarm":
            alarm = (row[1], int(row[2]) if len(row) > 2 and row[2] else 0)
            break
        if not row[time]:
            in_hole = True
            continue
        texts = [row[columns[axis]] if axis in columns else str(start[i])
                 for i, axis in enumerate(AXES)]
        at = int(row[line]) if line is not None and row[line] else 0
        decimals = max(decimals, len(row[time].partition(".")[2]))
        points.append(Point(texts, float(row[time]), at, len(points)))
        points[-1].after_hole, in_hole = in_hole, False
        if len(points) > 1 and points[-1].time <= points[-2].time:
            raise ValueError("the time %s does not grow" % row[time])
        if "alarm" in columns and row[columns["alarm"]]:
            alarm = (row[columns["alarm"]], at)
    return points, seen, 0.5 * 10.0 ** -decimals, alarm, in_hole


def end_of(run, end, alarm, classes, header_lines):
    """What is said of how the program ends, when the motion up to there is right."""
    due = "classes" in end
    if alarm is None:
        if due:
            kind = "ADVICE" if end["silent"] else "NO-GO"
            return (kind, "the alarm of line %d is missing" % end["b"]) if run.at_end or run.left_end \
                else ("NO-GO", "the samples end before the path does")
        if run.left_end:
            return "NO-GO", run.departure
        return ("GO", "") if run.at_end else ("NO-GO", "the samples end before the path does")
    name, line = alarm
    if not due or not run.at_end:
        return "NO-GO", "an alarm that is not due: %s" % name
    if line and line - header_lines != end["b"]:
        return "NO-GO", "the alarm is of line %d, due in line %d" % (line - header_lines, end["b"])
    own = classes.get(name, name)
    if own not in end["classes"]:
        return "NO-GO", "the alarm %s is not %s" % (name, " or ".join(end["classes"]))
    return "GO", ""


def shown(run):
    """The answer where all that the samples show is right."""
    if run.holes.found:
        return "UNDECIDED", run.holes.text()
    if run.long_stands:
        return "UNDECIDED", "it stands too long at the dwell of line %d" % run.long_stands[0]
    if run.unseen:
        lines = sorted({run.pieces[i].block for i in run.unseen if i < len(run.pieces)})
        return "UNDECIDED", "no sample shows lines %s" % ", ".join(map(str, lines))
    return "GO", run.holes.rate()


def judge_way(way, start, points, seen, clock, alarm, in_hole, options):
    """(answer, sentence, progress) along one way."""
    runs = []
    for strict in (True, False):
        run = Run(way, start, Tube(options.tolerance, strict), seen, options.header_lines,
                  options.granted, clock, Holes([point.time for point in points], clock))
        for point in points:
            if not run.take(point):
                break
        run.finish()
        if in_hole:
            run.holes.found.append((str(points[-1].time), "the end"))
        runs.append(run)
        if strict and not run.departure:
            break
    run = runs[-1]
    if len(runs) == 2 and not run.departure:
        answer = ("NO-GO", run.feed_fault) if run.feed_fault else (
            "UNDECIDED", "a sample lies too close to the tolerance of an arc to say")
    elif run.feed_fault:
        answer = "NO-GO", run.feed_fault
    elif run.departure and not run.left_end:
        answer = "NO-GO", run.departure
    elif run.open is not None:
        answer = "UNDECIDED", run.open
    else:
        answer = end_of(run, way["end"], alarm, options.classes, options.header_lines)
        if run.left_end and answer[0] == "GO":
            answer = "NO-GO", run.departure
        if answer[0] == "GO":
            answer = shown(run)
    return answer + (run.progress,)


RANK = {"GO": 3, "UNDECIDED": 2, "ADVICE": 1, "NO-GO": 0}


def judge(entry, path, options):
    options.header_lines = entry["header_lines"]
    expected = entry["expected"]
    options.tolerance = exact(expected["tolerance"]) + options.more
    start = [exact(value) for value in expected["start"]]
    try:
        if not expected["ways"]:
            raise Undecided("too many readings are open")
        try:
            points, seen, clock, alarm, in_hole = read_samples(path, start)
        except (ValueError, IndexError) as why:
            return "NO-GO", "the log cannot be read: %s" % why
        if not points:
            return "NO-GO", "there is no sample"
        found = [judge_way(way, start, points, seen, clock, alarm, in_hole, options)
                 for way in expected["ways"]]
    except Undecided as why:
        return "UNDECIDED", str(why)
    best = max(found, key=lambda each: (RANK[each[0]], each[2]))
    return best[:2]


def read_classes(path):
    """native -> class, of a TOML file of the gauge's alarm maps."""
    with open(path, encoding="utf-8") as file:
        return dict(re.findall(r'^\s*"((?:[^"\\]|\\.)*)"\s*=\s*"([^"]*)"', file.read(), re.MULTILINE))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("back", help="folder of what the machine recorded")
    parser.add_argument("--tolerance", default="0", help="granted beside the resolution, mm an axis")
    parser.add_argument("--feed-tolerance", default="5", help="percent (5)")
    parser.add_argument("--alarms", help="TOML file of what the machine's own alarms mean")
    parser.add_argument("--only", action="append", default=[], help="only ids that match the glob")
    options = parser.parse_args()
    options.more = Fraction(options.tolerance)
    options.granted = float(Fraction(options.feed_tolerance)) / 100
    options.classes = read_classes(options.alarms) if options.alarms else {}
    counts, missing = {}, 0
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "expected.jsonl"), encoding="utf-8") as file:
        for line in file:
            entry = json.loads(line)
            if options.only and not any(fnmatch.fnmatchcase(entry["id"], glob)
                                        for glob in options.only):
                continue
            stems = (entry["id"], os.path.splitext(entry["file"])[0])
            paths = [os.path.join(options.back, stem + ".csv") for stem in stems]
            path = next((each for each in paths if os.path.exists(each)), None)
            if path is None:
                missing += 1
                continue
            answer, sentence = judge(entry, path, options)
            counts[answer] = counts.get(answer, 0) + 1
            print("%-9s %s%s" % (answer, entry["id"], ": " + sentence if sentence else ""))
    print("%s; %d programs have no file"
          % (", ".join("%d %s" % (n, answer) for answer, n in sorted(counts.items())) or "none", missing))
    if "NO-GO" in counts:
        return 1
    return 0 if counts.get("GO") and "UNDECIDED" not in counts else 3


if __name__ == "__main__":
    sys.exit(main())
