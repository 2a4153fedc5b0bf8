// SPDX-License-Identifier: GPL-3.0-or-later
//
// NGC-OFS-16: coordinates of a turned program, and the position after offsets have changed.
#include "reference/rs274/tool_lengths.hpp"

namespace gonogo::reference::rs274 {
namespace {

void turn_xy(Position& way, const Number& cosine, const Number& sine) {
  const Number x = way[Axis::x];
  const Number y = way[Axis::y];
  way[Axis::x] = x * cosine - y * sine;
  way[Axis::y] = x * sine + y * cosine;
}

}  // namespace

Position sum(Position a, const Position& b) {
  for (const Axis axis : kAllAxes) a[axis] += b[axis];
  return a;
}

Position difference(Position a, const Position& b) {
  for (const Axis axis : kAllAxes) a[axis] -= b[axis];
  return a;
}

Frame::Frame(const Number& angle) : is_turned(angle.sign() != 0) {
  if (!is_turned) return;
  const auto [cosine_of_angle, sine_of_angle] = exact::cos_sin_degrees(angle);
  cosine = cosine_of_angle;
  sine = sine_of_angle;
}

Position Frame::turned(Position way) const {
  if (is_turned) turn_xy(way, cosine, sine);
  return way;
}

Position Frame::turned_back(Position way) const {
  if (is_turned) turn_xy(way, cosine, -sine);
  return way;
}

Position Frame::to_machine(const Position& place) const {
  return sum(turned(place), origin);
}

Position Frame::to_program(const Position& place) const {
  return turned_back(difference(place, origin));
}

// A turned motion along X or Y moves both axes.
void Frame::move(Record& record, Position& at) const {
  if (!is_turned) {
    for (const Axis axis : kAllAxes) {
      if (record.axes.has(axis)) record.to[axis] += origin[axis];
    }
  } else if (is_motion(record.kind)) {
    for (const Axis axis : kAllAxes) {
      if (record.axes.has(axis)) at[axis] = record.to[axis];
    }
    record.to = to_machine(at);
    if (record.axes.has(Axis::x) || record.axes.has(Axis::y)) {
      record.axes = record.axes | AxisSet{Axis::x, Axis::y};
    }
  }
  if (record.kind != RecordKind::arc) return;
  const PlaneAxes axes = axes_of(record.plane);
  Position centre;
  centre[axes.p] = record.centre[0];
  centre[axes.q] = record.centre[1];
  centre = to_machine(centre);
  record.centre = {centre[axes.p], centre[axes.q]};
}

namespace {

// The same motions in coordinates of the machine; they begin `at`.
Generator<Item> moved(Generator<Item> items, Frame frame, Position at) {
  while (const Item* item = items.next()) {
    Item other = *item;
    if (auto* const record = std::get_if<Record>(&other)) frame.move(*record, at);
    co_yield other;
  }
}

}  // namespace

void move_out(const Frame& frame, const Position& at, BlockOutput& out) {
  if (!frame.is_moved) return;
  const auto move = [&](std::vector<Item>& items) {
    Position end = at;
    for (Item& item : items) {
      if (auto* const record = std::get_if<Record>(&item)) frame.move(*record, end);
    }
    return end;
  };
  move(out.before_alarm);
  out.cycle = moved(std::move(out.cycle), frame, move(out.items));
  for (NamedPlace& place : out.cycle_places.places) place.at = frame.to_machine(place.at);
}

Position at_machine_places(const Frame& frame, const Position& from, AxisSet& axes,
                           const Position& places) {
  Position to = frame.to_machine(from);
  for (const Axis axis : kAllAxes) {
    if (axes.has(axis)) to[axis] = places[axis];
  }
  const bool is_mixed = frame.is_turned && (axes.has(Axis::x) || axes.has(Axis::y));
  if (is_mixed) axes = axes | AxisSet{Axis::x, Axis::y};
  return frame.to_program(to);
}

Position origin_by_words(const BlockContext& block, const Position& origin, const Number& angle,
                         const Position& shift) {
  const Machine& machine = block.machine;
  const Frame frame(angle);
  const Position here = machine.offsets.frame.to_machine(machine.position);
  Position coordinates = difference(frame.turned_back(difference(here, origin)), shift);
  each_axis_word(block, [&](Axis axis, const Number& value) { coordinates[axis] = value; });
  return difference(here, frame.turned(sum(coordinates, shift)));
}

void settle_change(Machine& machine, const Offsets& before) {
  Offsets& after = machine.offsets;
  after.settle();
  const Position from = machine.position;
  if (before.angles[before.system] == after.angles[after.system]) {
    // Along axes that keep their directions nothing has to be turned to and fro.
    const Position base_before = sum(before.systems[before.system], before.tool);
    const Position base_after = sum(after.systems[after.system], after.tool);
    machine.position = sum(sum(from, difference(before.shift, after.shift)),
                           after.frame.turned_back(difference(base_before, base_after)));
  } else {
    machine.position = after.frame.to_program(before.frame.to_machine(from));
  }
  // NGC-CYC-09: the initial level of a series is a place.
  const Axis depth = axes_of(machine.plane).d;
  std::optional<Series>& series = machine.cycle.series;
  if (series && series->place) *series->place += machine.position[depth] - from[depth];
}

}  // namespace gonogo::reference::rs274
