// SPDX-License-Identifier: GPL-3.0-or-later
//
// GSK-COM-05 without arcs: G00, G01, G04, G28, G50; and the motions that every cycle is made of.
#include <fmt/format.h>

#include "reference/gsk988ta/machine.hpp"

namespace gonogo::reference::gsk988ta {

void BlockContext::alarm(AlarmClass alarm, ClauseId clause, char address, std::string message) {
  grammar::Span where;
  if (address != 0 && words.has(address)) {
    where = words.word(address)->where;
  } else if (!words.block().words.empty()) {
    where.begin = where.end = words.block().words.back().where.end;
  }
  out.alarms.push_back({alarm, clause, address, where, std::move(message)});
}

void BlockContext::missing(ClauseId clause, char address) {
  alarm(AlarmClass::missing_word, clause, address, fmt::format("The word {} is missing.", address));
}

void BlockContext::need_feed() {
  if (machine.feed.sign() > 0) return;
  alarm(AlarmClass::feed_missing, "GSK-COM-04"_clause, 'F',
        "The block cuts, but no feed is in force.");
}

Record BlockContext::motion(RecordKind kind, ClauseId clause, std::initializer_list<AxisValue> to) {
  Record record;
  record.kind = kind;
  record.block = line;
  record.clause = clause;
  for (const auto& [axis, value] : to) {
    machine.position[axis] = value;
    record.axes.add(axis);
    record.to[axis] = value;
  }
  if (kind != RecordKind::rapid) {
    record.feed = machine.feed;
    record.feed_mode = machine.feed_mode;
  }
  return record;
}

void BlockContext::rapid(ClauseId clause, std::initializer_list<AxisValue> to) {
  put(motion(RecordKind::rapid, clause, to));
}

void BlockContext::feed(ClauseId clause, std::initializer_list<AxisValue> to) {
  put(motion(RecordKind::feed, clause, to));
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

// One motion to the end point of the block, of whichever axes it names.
void move_to_end_point(BlockContext& block, RecordKind kind) {
  Position to;
  AxisSet axes = commanded_end_point(block, to);
  if (axes.empty()) return;
  if (kind == RecordKind::feed) block.need_feed();
  Record record = block.motion(kind, "GSK-COM-05"_clause, {});
  record.axes = axes;
  record.to = to;
  block.machine.position = to;
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
    block.missing("GSK-COM-05"_clause, 'P');
    return;
  }
  Record record;
  record.kind = RecordKind::dwell;
  record.block = block.line;
  record.clause = "GSK-COM-05"_clause;
  record.seconds = words.written(address);
  if (address == 'P') record.seconds = record.seconds / 1000;
  if (record.seconds.sign() < 0) {
    block.alarm(AlarmClass::value_sign, "GSK-COM-05"_clause, address,
                "A dwell cannot be negative.");
  }
  block.put(std::move(record));
}

// G28 (GSK-MOD-08): traverse to the point of the words, then those axes to the reference point.
void run_reference_point(BlockContext& block) {
  move_to_end_point(block, RecordKind::rapid);
  Position to;
  AxisSet axes = commanded_end_point(block, to);
  if (axes.empty()) return;
  Record record = block.motion(RecordKind::rapid, "GSK-MOD-08"_clause, {});
  record.axes = axes;
  for (Axis axis : kAllAxes) {
    if (axes.has(axis)) block.machine.position[axis] = block.profile.reference_point[axis];
  }
  record.to = block.machine.position;
  block.put(std::move(record));
}

// G50 (GSK-MOD-08): the position gets a new name; nothing moves.
void run_rename_position(BlockContext& block) {
  Machine& machine = block.machine;
  Position to;
  commanded_end_point(block, to);
  const Axis d = axes_of(machine.plane).d;
  machine.pocket.initial_plane += to[d] - machine.position[d];
  Renaming renaming{block.line, {}};
  for (Axis axis : kAllAxes) renaming.shift[axis] = to[axis] - machine.position[axis];
  machine.position = to;
  block.out.items.emplace_back(std::move(renaming));
}

}  // namespace gonogo::reference::gsk988ta
