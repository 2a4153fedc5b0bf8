// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motion in step with the spindle, and G33, which is nothing else.
#include "reference/rs274/synchronous.hpp"

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/predicate.hpp"
#include "reference/reading_literal.hpp"

#include <fmt/format.h>

namespace gonogo::reference::rs274 {
namespace {

// NGC-G33-06
bool leaves_out_rotary_axis(BlockContext& block, std::string_view code) {
  if (!block.words.has_rotary_axis_word()) return false;
  const char address = block.words.has('A') ? 'A' : 'C';
  block.out.not_covered = NotCovered{
      block.line, std::string(code),
      fmt::format("The gauge does not read {} with the word {} of a rotary axis.", code, address),
      block.words.word(address)->where};
  return true;
}

// NGC-G33-02, NGC-G33-05
void check_lead(BlockContext& block) {
  if (!block.words.has('K')) {
    block.alarm(AlarmClass::lead_missing, "NGC-G33-02"_clause, 'K',
                "K, the lead, is needed in every block.");
  } else if (decided("NGC-G33-05"_clause, "K", block.words.written('K')) <= 0 &&
             block.readings.is("ngc.g33.k=positive"_reading)) {
    block.alarm(AlarmClass::value_sign, "NGC-G33-05"_clause, 'K',
                with_values("The lead, {}, is not above zero.", {block.words.written('K')}));
  }
}

// A thread record has the lead along the axis that moves farthest; programs of RS274/NGC say it
// along the path. mm; exact, with one square root where more than one axis moves.
// REQUIRES: the points differ along a linear axis.
Number lead_of(const Number& path_lead, const Position& from, const Position& to) {
  Number squares;
  Number longest;
  for (const Axis axis : kLinearAxes) {
    const Number way = abs(to[axis] - from[axis]);
    squares += way * way;
    longest = max(longest, way);
  }
  return path_lead * longest / sqrt(squares);
}

}  // namespace

std::optional<SynchronousMotion> synchronous_motion(BlockContext& block, std::string_view code) {
  if (leaves_out_rotary_axis(block, code)) return std::nullopt;
  // NGC-G33-01
  if (!block.words.has_linear_axis_word()) block.missing("NGC-G33-01"_clause, 'X');
  check_lead(block);
  // NGC-G33-03
  if (block.words.has('F')) {
    block.alarm(AlarmClass::conflicting_words, "NGC-G33-03"_clause, 'F',
                fmt::format("{} has its feed from the spindle, and F stands beside it.", code));
  }
  // NGC-G33-04
  if (!block.machine.spindle_turns()) {
    block.alarm(AlarmClass::spindle_stopped, "NGC-G33-04"_clause, 'M',
                fmt::format("{} needs a spindle that turns.", code));
  }
  if (!block.out.alarms.empty()) return std::nullopt;
  SynchronousMotion motion;
  motion.named = commanded_end_point(block, motion.to);
  motion.path_lead = *block.words.length('K');
  return motion;
}

Record thread_to(BlockContext& block, ClauseId clause, const SynchronousMotion& motion) {
  const Number lead = lead_of(motion.path_lead, block.machine.position, motion.to);
  Record record = block.motion_to(RecordKind::thread, clause, motion.named, motion.to);
  record.lead = lead;
  return record;
}

void run_g33(BlockContext& block) {
  const std::optional<SynchronousMotion> motion = synchronous_motion(block, "G33");
  if (!motion || !motion->moves_from(block.machine.position)) return;
  block.put(thread_to(block, "NGC-G33-01"_clause, *motion));
}

}  // namespace gonogo::reference::rs274
