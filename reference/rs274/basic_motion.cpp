// SPDX-License-Identifier: GPL-3.0-or-later
//
// G0, G1 and G4.
#include <algorithm>
#include <iterator>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/polar_words.hpp"
#include "reference/rs274/tool_lengths.hpp"

namespace gonogo::reference::rs274 {

AxisSet commanded_end_point(const BlockContext& block, Position& to) {
  AxisSet axes;
  const Machine& machine = block.machine;
  to = machine.position;
  const bool is_of_machine = block.codes.once == 530;
  const bool adds = machine.modes.incremental && !is_of_machine;
  for (const AxisLetter& letter : kAxisLetters) {
    const std::optional<Number> value = block.words.along(letter);
    if (!value) continue;
    axes.add(letter.axis);
    to[letter.axis] = adds ? to[letter.axis] + *value : *value;
  }
  if (block.words.is_polar()) {
    axes.add(Axis::x);
    axes.add(Axis::y);
    const PlaceInXy end = polar_end(block);
    to[Axis::x] = end[0];
    to[Axis::y] = end[1];
  }
  // NGC-OFS-13
  if (is_of_machine) to = at_machine_places(machine.offsets.frame, machine.position, axes, to);
  return axes;
}

// NGC-MOD-02: G0 or G1 without an axis word.
void run_bare_motion(BlockContext& block) {
  const ClauseId clause = "NGC-MOD-02"_clause;
  if (block.codes.motion < 0) return;
  if (block.readings.is("ngc.bare-motion=missing-word"_reading)) {
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

// NGC-FED-01: the way that F of inverse time counts; of the rotary axes where they move alone.
Number way_of_feed(const Position& from, const Position& to, bool rotary) {
  Number squares;
  for (const Axis axis : kAllAxes) {
    if (is_linear(axis) == rotary) continue;
    const Number way = to[axis] - from[axis];
    squares += way * way;
  }
  return exact::sqrt(squares);
}

// NGC-G0-01
void run_straight_feed(BlockContext& block) {
  Position to;
  const AxisSet axes = commanded_end_point(block, to);
  if (axes.empty()) return run_bare_motion(block);
  const Machine& machine = block.machine;
  if (!machine.is_inverse_time) block.need_feed("NGC-G0-01"_clause);
  const bool rotary = block.turns_alone(to);
  const Number feed = machine.is_inverse_time && block.words.has('F')
                          ? block.words.written('F') * way_of_feed(machine.position, to, rotary)
                          : machine.feed;
  Record record = block.motion_to(RecordKind::feed, "NGC-G0-01"_clause, axes, to);
  record.feed = rotary && !machine.is_inverse_time ? machine.rotary_feed : feed;
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
  if (is_arc(block.codes.motion)) block.out.accept("NGC-G4-03"_clause);
  Record record = record_of(RecordKind::dwell, block.line, "NGC-G4-01"_clause);
  record.seconds = block.words.written('P');
  if (decided("NGC-G4-01"_clause, "P", record.seconds) < 0) {
    block.alarm(AlarmClass::value_sign, "NGC-G4-01"_clause, 'P',
                with_values("A dwell of {} s is negative.", {record.seconds}));
  }
  block.put(std::move(record));
}

}  // namespace gonogo::reference::rs274
