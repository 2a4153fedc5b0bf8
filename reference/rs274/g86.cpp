// SPDX-License-Identifier: GPL-3.0-or-later
//
// G86, boring, out by a traverse with the spindle stopped.
#include "reference/clause_literal.hpp"
#include "reference/rs274/hole_block.hpp"

namespace gonogo::reference::rs274 {
namespace {

// NGC-G86-02
Generator<Item> bore_and_stop(const Holes& holes) {
  const ClauseId clause = "NGC-G86-02"_clause;
  co_yield holes.feed(clause, holes.bottom);
  co_yield holes.dwell(clause);
  co_yield holes.spindle_function(clause, 5);
  co_yield holes.rapid(clause, holes.clear);
  co_yield holes.spindle_function(clause, holes.spindle);
}

}  // namespace

void run_g86(BlockContext& block) {
  HoleBlock holes(block, OwnWord::needs_p);
  // NGC-G86-01
  if (!block.machine.spindle_turns()) {
    holes.alarm_at_hole(AlarmClass::spindle_stopped, "NGC-G86-01"_clause, 'M',
                        "The cycle stops the spindle in the hole, and it does not turn.");
  }
  holes.run(bore_and_stop);
}

}  // namespace gonogo::reference::rs274
