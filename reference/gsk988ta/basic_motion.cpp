// SPDX-License-Identifier: GPL-3.0-or-later
//
// GSK-COM-05 without arcs: G00, G01, G04, G28, G50.
#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/gsk988ta/machine.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::gsk988ta {

void BlockContext::need_feed() {
  BlockBase::need_feed(machine.has_feed ? "GSK-COM-08"_clause : "GSK-COM-04"_clause);
}

AxisSet commanded_end_point(const BlockContext& block, Position& to) {
  AxisSet axes;
  to = block.machine.position;
  for (const AxisAddresses& addresses : kAxisAddresses) {
    std::optional<AxisWord> word = block.words.axis_word(addresses.axis);
    if (!word) continue;
    axes.add(addresses.axis);
    to[addresses.axis] = word->incremental ? to[addresses.axis] + word->value : word->value;
  }
  return axes;
}

namespace {

// F of a rotary axis that moves alone: written under G20 it is scaled like a length, or in degrees.
Number rotary_feed(const BlockContext& block) {
  const Machine& machine = block.machine;
  if (!machine.feed_in_inch || block.readings.is("gsk.rotary-feed-inch=scaled"_reading)) {
    return machine.feed;
  }
  return machine.feed / Number::millionths(25'400'000);
}

// One motion to the end point of the block, of whichever axes it names.
void move_to_end_point(BlockContext& block, RecordKind kind) {
  Position to;
  AxisSet axes = commanded_end_point(block, to);
  if (axes.empty()) return;
  if (kind == RecordKind::feed) block.need_feed();
  const bool rotary = kind == RecordKind::feed && block.turns_alone(to);
  Record record = block.motion_to(kind, "GSK-COM-05"_clause, axes, to);
  if (rotary) record.feed = rotary_feed(block);
  block.put(std::move(record));
}

}  // namespace

void run_positioning(BlockContext& block) {
  move_to_end_point(block, RecordKind::rapid);
}

void run_straight_feed(BlockContext& block) {
  move_to_end_point(block, RecordKind::feed);
}

// G04: P in milliseconds, X or U in seconds.
void run_dwell(BlockContext& block) {
  const BlockWords& words = block.words;
  const char address = words.has('P') ? 'P' : words.has('X') ? 'X' : 'U';
  if (!words.has(address)) {
    if (block.readings.is("gsk.dwell-without-word=alarm"_reading)) {
      block.missing("GSK-COM-12"_clause, 'P');
    }
    return;
  }
  Record record;
  record.kind = RecordKind::dwell;
  record.block = block.line;
  record.clause = "GSK-COM-05"_clause;
  record.seconds = words.written(address);
  if (address == 'P') record.seconds = record.seconds / 1000;
  if (decided("GSK-COM-12"_clause, "P", record.seconds) < 0) {
    block.alarm(AlarmClass::value_sign, "GSK-COM-12"_clause, address,
                with_values("A dwell of {} s is negative.", {record.seconds}));
  }
  block.put(std::move(record));
}

// G28 (GSK-MOD-08): traverse to the point of the words, then those axes to the reference point.
void run_reference_point(BlockContext& block) {
  move_to_end_point(block, RecordKind::rapid);
  Position to;
  AxisSet axes = commanded_end_point(block, to);
  if (axes.empty()) return;
  to = block.machine.position;
  for (Axis axis : kAllAxes) {
    if (axes.has(axis)) to[axis] = block.profile.reference_point[axis];
  }
  block.put(block.motion_to(RecordKind::rapid, "GSK-MOD-08"_clause, axes, to));
}

// G50 (GSK-MOD-08): the position gets a new name; nothing moves.
void run_rename_position(BlockContext& block) {
  Machine& machine = block.machine;
  Position to;
  commanded_end_point(block, to);
  const Axis d = axes_of(machine.plane).d;
  // GSK-MOD-05: the initial plane of a milling cycle keeps its place, under its new name.
  const Number shift = to[d] - machine.position[d];
  if (machine.milling.code != 0 && shift.sign() != 0 &&
      block.readings.is("gsk.g50.initial-plane=shifted"_reading)) {
    machine.milling.initial_plane += shift;
  }
  block.rename(to);
}

}  // namespace gonogo::reference::gsk988ta
