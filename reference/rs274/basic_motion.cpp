// SPDX-License-Identifier: GPL-3.0-or-later
//
// G0, G1 and G4.
#include <algorithm>
#include <iterator>

#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/rs274/machine.hpp"

namespace gonogo::reference::rs274 {

AxisSet commanded_end_point(const BlockContext& block, Position& to) {
  AxisSet axes;
  const Machine& machine = block.machine;
  to = machine.position;
  for (const AxisLetter& letter : kAxisLetters) {
    const std::optional<Number> value = block.words.along(letter);
    if (!value) continue;
    axes.add(letter.axis);
    if (block.codes.once == 530) {  // NGC-OFS-13
      to[letter.axis] = *value - machine.offsets.origin[letter.axis];
    } else {
      to[letter.axis] = machine.modes.incremental ? to[letter.axis] + *value : *value;
    }
  }
  return axes;
}

// NGC-MOD-02: G0 or G1 without an axis word.
void run_bare_motion(BlockContext& block) {
  const ClauseId clause = "NGC-MOD-02"_clause;
  if (block.codes.motion < 0) return;
  if (block.readings.is(ReadingKey::ngc_bare_motion, "missing-word")) {
    block.missing(clause, 'X');
  } else if (block.codes.motion == 1) {
    block.need_feed(clause);
  }
}

// NGC-G0-01
void run_traverse(BlockContext& block) {
  Position to;
  const AxisSet axes = commanded_end_point(block, to);
  if (axes.empty()) return run_bare_motion(block);
  block.put(block.motion_to(RecordKind::rapid, "NGC-G0-01"_clause, axes, to));
}

// NGC-G0-01
void run_straight_feed(BlockContext& block) {
  Position to;
  const AxisSet axes = commanded_end_point(block, to);
  if (axes.empty()) return run_bare_motion(block);
  block.need_feed("NGC-G0-01"_clause);
  const bool rotary = block.turns_alone(to);
  Record record = block.motion_to(RecordKind::feed, "NGC-G0-01"_clause, axes, to);
  if (rotary) record.feed = block.machine.rotary_feed;
  block.put(std::move(record));
}

std::vector<Item> dwells_of(const BlockContext& block) {
  std::vector<Item> dwells;
  std::ranges::copy_if(block.out.items, std::back_inserter(dwells), [](const Item& item) {
    const auto* record = std::get_if<Record>(&item);
    return record != nullptr && record->kind == RecordKind::dwell && record->seconds.sign() != 0;
  });
  return dwells;
}

// NGC-G4-01
void run_dwell(BlockContext& block) {
  if (!block.words.has('P')) {
    block.missing("NGC-G4-01"_clause, 'P');
    return;
  }
  Record record;
  record.kind = RecordKind::dwell;
  record.block = block.line;
  record.clause = "NGC-G4-01"_clause;
  record.seconds = block.words.written('P');
  if (decided("NGC-G4-01"_clause, "P", record.seconds) < 0) {
    block.alarm(AlarmClass::value_sign, "NGC-G4-01"_clause, 'P',
                with_values("A dwell of {} s is negative.", {record.seconds}));
  }
  block.put(std::move(record));
}

}  // namespace gonogo::reference::rs274
