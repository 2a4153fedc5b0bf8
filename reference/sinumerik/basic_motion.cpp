// SPDX-License-Identifier: GPL-3.0-or-later
//
// G0, G1 and G4, and how motions are put out.
#include <fmt/format.h>

#include <utility>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {
namespace {

// Whether only rotary axes have a way to go.
bool turns_alone(const EndPoint& end) {
  if (!end.named.has(Axis::a) && !end.named.has(Axis::c)) return false;
  return !any_nonzero({end.by[Axis::x], end.by[Axis::y], end.by[Axis::z]});
}

// Degrees where rotary axes turn alone.
Number feed_of(const BlockContext& block, const EndPoint& end, RecordKind kind) {
  const bool turns = kind == RecordKind::feed && turns_alone(end);
  return turns ? block.machine.feed : linear_feed(block);
}

// What was known of a place in a plane, as long as no axis of the plane moves.
void keep_mark(Machine& machine, const EndPoint& end) {
  if (end.mark) {
    machine.mark = end.mark;
    return;
  }
  if (!machine.mark) return;
  const PlaneAxes axes = axes_of(machine.mark->plane);
  for (const Axis axis : {axes.p, axes.q}) {
    const Number& by = end.by[axis];
    if (!by.is_rational() || by.sign() != 0) machine.mark.reset();
    if (!machine.mark) return;
  }
}

// SIE-CT-02: of a straight motion the way that it goes; one without a length is none.
void remember_line(Machine& machine, const EndPoint& end) {
  LastMotion last;
  for (const Axis axis : kLinearAxes) last.direction[axis] = end.by[axis];
  try {
    if (!any_nonzero({end.by[Axis::x], end.by[Axis::y], end.by[Axis::z]})) return;
  } catch (const exact::Undecided&) {
    last.undecided = true;
  }
  machine.last = std::move(last);
}

// SIE-CT-02: of an arc the radius at its end, turned by 90 degrees in its sense.
void remember_arc(Machine& machine, const ArcPath& arc, const EndPoint& end) {
  const PlaneAxes axes = axes_of(arc.plane);
  const Vector_2 radius = from_centre_to_end(axes, arc.centre, arc.offset, end);
  const auto sense = arc.rot > 0 ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE;
  LastMotion last;
  geometry::put_in(last.direction, axes, radius.perpendicular(sense));
  last.arc = LastArc{-arc.offset, radius, end.closed.value_or(false), arc.rot, {}};
  if (end.named.has(axes.d)) last.arc->climb = LastArc::Climb{axes.d, end.by[axes.d]};
  machine.last = std::move(last);
}

// Whether F of before and R123 are one speed, so that a cut does not show which is in force.
bool are_one_feed(const Machine& machine) {
  if (machine.modes.inch || machine.feed_is_of_before) return false;
  const std::optional<FeedOfCycle>& of_cycle = machine.feed_of_cycle;
  return of_cycle && !of_cycle->replaces_one_of_before &&
         (of_cycle->feed - machine.feed).try_sign() == 0;
}

// SIE-LC75-14
void settle_feed_of_cycle(BlockContext& block) {
  Machine& machine = block.machine;
  if (are_one_feed(machine)) return;
  const auto of_cycle = std::exchange(machine.feed_of_cycle, std::nullopt);
  if (!of_cycle) return;
  if (block.readings.is("sie.lc75.feed-after=of-cycle"_reading)) {
    machine.feed = of_cycle->feed;
    machine.feed_is_of_cycle = true;
    machine.feed_is_zero = false;
  } else if (of_cycle->replaces_one_of_before) {
    machine.feed_is_of_before = true;
  }
}

}  // namespace

// SIE-MOD-04
Number linear_feed(const BlockContext& block) {
  const Number& written = block.machine.feed;
  if (!block.machine.modes.inch || block.machine.feed_is_of_cycle) return written;
  return block.readings.is("sie.g70.f=inch"_reading) ? inches(written) : written;
}

void refuse_words(BlockContext& block, std::initializer_list<Address> addresses) {
  for (const Address address : addresses) {
    if (!block.words.has(address)) continue;
    const ClauseId clause = address == Address::turn ? "SIE-ARC-13"_clause : "SIE-COM-02"_clause;
    block.alarm(AlarmClass::conflicting_words, clause, name_of(address),
                fmt::format("{} has no meaning for the motion in force.", name_of(address).text()));
  }
}

// SIE-ARC-13
void refuse_turns(BlockContext& block) {
  if (!block.words.has(Address::turn)) return;
  if (block.words.written(Address::turn).sign() != 0) refuse_words(block, {Address::turn});
}

// SIE-MOD-08
void drop_feed_of_before(BlockContext& block) {
  settle_feed_of_cycle(block);
  Machine& machine = block.machine;
  if (!machine.feed_is_of_before || machine.feed.sign() <= 0) return;
  if (block.readings.is("sie.feed-change=deleted"_reading)) machine.feed = 0;
}

// SIE-COM-01; SIE-COM-06 of an F that was 0.
void need_cutting(BlockContext& block) {
  drop_feed_of_before(block);
  if (block.machine.feed_is_zero) block.out.accept("SIE-COM-06"_clause);
  block.need_feed("SIE-COM-01"_clause);
  need_spindle(block);
}

// SIE-MOD-09: a spindle that was brought to a place, or that a tool was changed in.
bool spindle_turns(BlockContext& block) {
  const Machine& machine = block.machine;
  const bool turns = machine.spindle != 5 && (machine.speed_given || machine.speed.sign() > 0);
  if (turns && machine.spindle_is_placed) block.out.accept("SIE-MOD-09"_clause);
  return turns;
}

// SIE-G1-02; SIE-G1-04 where the reading lets the block run on.
void need_spindle(BlockContext& block) {
  if (spindle_turns(block)) return;
  if (!block.readings.is("sie.spindle=alarm"_reading)) {
    block.out.accept("SIE-G1-04"_clause);
    return;
  }
  block.alarm(AlarmClass::spindle_stopped, "SIE-G1-02"_clause, 'S',
              "The block cuts, but the spindle does not turn.");
}

namespace {

// The axes of the rotated plane along which nothing moves: their base coordinates stay the numbers
// that they are, so that a full circle is seen to end where it began.
AxisSet standing_axes(const Machine& machine, const EndPoint& end) {
  if (!machine.frame.is_rotated()) return {};
  const PlaneAxes axes = axes_of(machine.frame.plane());
  for (const Axis axis : {axes.p, axes.q}) {
    if (!end.by[axis].is_rational() || end.by[axis].sign() != 0) return {};
  }
  return {axes.p, axes.q};
}

}  // namespace

void put_motion(BlockContext& block, const EndPoint& end, Record record) {
  if (record.kind != RecordKind::rapid) record.feed = feed_of(block, end, record.kind);
  keep_mark(block.machine, end);
  put_in_base(block, std::move(record), end.to, standing_axes(block.machine, end));
}

void put_in_base(BlockContext& block, Record record, const Position& end, AxisSet standing) {
  Machine& machine = block.machine;
  const bool in_space = record.kind == RecordKind::arc3;
  travel(machine, in_space ? AxisSet{Axis::x, Axis::y, Axis::z} : record.axes);
  Record in_base = machine.frame.to_base(std::move(record), end);
  for (const Axis axis : kAllAxes) {
    if (in_base.axes.has(axis) && !standing.has(axis)) machine.base[axis] = in_base.to[axis];
  }
  in_base.to = machine.base;
  block.put(std::move(in_base));
}

void put_line(BlockContext& block, RecordKind kind, ClauseId clause, const EndPoint& end) {
  Record record = block.motion_to(kind, clause, end.named, end.to);
  remember_line(block.machine, end);
  put_motion(block, end, std::move(record));
}

void put_arc(BlockContext& block, const ArcPath& arc, const EndPoint& end) {
  const PlaneAxes axes = axes_of(arc.plane);
  Record record =
      block.motion_to(RecordKind::arc, arc.clause, end.named | AxisSet{axes.p, axes.q}, end.to);
  record.plane = arc.plane;
  record.centre = geometry::pair(arc.centre);
  if (arc.clause == "SIE-ARC-08"_clause) record.centre_clause = "SIE-ARC-15"_clause;
  record.rot = arc.rot;
  remember_arc(block.machine, arc, end);
  put_motion(block, end, std::move(record));
}

// SIE-G1-01
void run_line(BlockContext& block, RecordKind kind) {
  refuse_words(block, {Address::i, Address::j, Address::k, Address::i1, Address::j1, Address::k1,
                       Address::cr, Address::ar, Address::turn});
  const std::optional<EndPoint> end = end_point(block);
  if (!end || end->named.empty()) return;
  if (kind == RecordKind::feed) need_cutting(block);
  put_line(block, kind, "SIE-G1-01"_clause, *end);
}

// SIE-MOD-03, SIE-MOD-06, SIE-MOD-07, SIE-MOD-09
void run_dwell(BlockContext& block) {
  constexpr ClauseId kUnsaidDwell = "SIE-MOD-06"_clause;
  const ClauseId clause = "SIE-MOD-03"_clause;
  const BlockWords& words = block.words;
  const bool has_both = words.has(Address::f) && words.has(Address::s);
  if (has_both) {
    block.alarm(AlarmClass::conflicting_words, clause, 'S', "A dwell is of F or of S.");
  }
  if (!words.has(Address::f) && !words.has(Address::s)) {
    block.missing(kUnsaidDwell, 'F');
    return;
  }
  for (const Address address : {Address::f, Address::s}) {
    if (words.has(address) &&
        decided(kUnsaidDwell, address == Address::f ? "F" : "S", words.written(address)) < 0) {
      block.alarm(AlarmClass::value_sign, kUnsaidDwell, name_of(address),
                  with_values("The dwell {} is negative.", {words.written(address)}));
    }
  }
  if (has_both) return;
  const Address address = words.has(Address::s) ? Address::s : Address::f;
  const Number& amount = words.written(address);
  Record record;
  record.kind = RecordKind::dwell;
  record.block = block.line;
  record.clause = clause;
  if (address == Address::f) {
    record.seconds = amount;
  } else if (block.machine.turns_unknown && block.out.alarms.empty()) {
    block.out.not_covered = NotCovered{
        block.line, "G4",
        "How fast the spindle turns under a constant cutting speed is not known, nor how "
        "long revolutions of it take.",
        words.place_of('S').value_or(words.behind())};
    return;
  } else if (decided(kUnsaidDwell, "speed", block.machine.speed) > 0) {
    if (!spindle_turns(block)) block.out.accept("SIE-MOD-09"_clause);
    record.seconds = amount * 60 / block.machine.speed;
  } else {
    block.alarm(AlarmClass::spindle_stopped, kUnsaidDwell, 'S',
                "A dwell of revolutions needs a spindle that turns.");
  }
  block.put(std::move(record));
}

}  // namespace gonogo::reference::sinumerik
