// SPDX-License-Identifier: GPL-3.0-or-later
//
// G84 and G74, right-hand and left-hand tapping with a floating chuck. NGC-G74-01: whether G74
// takes L stands with the words of codes.
#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/hole_block.hpp"

namespace gonogo::reference::rs274 {
namespace {

struct Tap {
  int forward;            // the M function of the sense in which it goes in
  int backward;           // and out
  std::string_view hand;  // "right-hand"
};

// NGC-G84-02: not synchronous; NGC-G84-05: along the third axis in every plane.
Generator<Item> tap_hole(const Holes& holes, Tap tap) {
  const ClauseId clause = "NGC-G84-02"_clause;
  co_yield holes.feed(clause, holes.bottom);
  co_yield holes.spindle_function(clause, 5);
  co_yield holes.spindle_function(clause, tap.backward);
  co_yield holes.dwell(clause);
  co_yield holes.feed(clause, holes.clear);
  // NGC-G84-03: so that the next hole finds the spindle as this one did.
  co_yield holes.spindle_function("NGC-G84-03"_clause, 5);
  co_yield holes.spindle_function("NGC-G84-03"_clause, tap.forward);
}

// NGC-G84-01
void check_spindle(HoleBlock& holes, const Tap& tap) {
  const Machine& machine = holes.block().machine;
  const ClauseId clause = "NGC-G84-01"_clause;
  if (!machine.spindle_turns()) {
    holes.alarm_at_hole(AlarmClass::spindle_stopped, clause, 'M',
                        fmt::format("A {} tap needs a spindle that turns.", tap.hand));
  } else if (machine.spindle != tap.forward) {
    holes.alarm_at_hole(AlarmClass::direction_conflict, clause, 'M',
                        fmt::format("A {} tap needs M{}, and M{} is in force.", tap.hand,
                                    tap.forward, machine.spindle));
  }
}

// NGC-G84-04: P.
void take_dwell(BlockContext& block, HoleBlock& holes) {
  CycleState& cycle = block.machine.cycle;
  if (block.words.has('P') || cycle.words.p) return;
  if (block.readings.is("ngc.tap.p=needed"_reading)) holes.missing_dwell("NGC-G84-04"_clause);
  if (block.readings.is("ngc.tap.p=last"_reading)) holes.dwell_for(cycle.last_p.value_or(0));
}

// NGC-G84-04: a P that a tap does not take is that of G4, or a word that nothing uses.
OwnWord own_word(BlockContext& block) {
  if (!block.words.has('P') || !block.readings.is("ngc.tap.p=barred"_reading)) {
    return OwnWord::takes_p;
  }
  block.machine.cycle.words.p.reset();
  return OwnWord::none;
}

void run_tap(BlockContext& block, const Tap& tap) {
  const OwnWord own = own_word(block);
  HoleBlock holes(block, own);
  if (own == OwnWord::takes_p) take_dwell(block, holes);
  check_spindle(holes, tap);
  holes.run([tap](const Holes& ready) { return tap_hole(ready, tap); });
}

}  // namespace

void run_g74(BlockContext& block) {
  run_tap(block, {.forward = 4, .backward = 3, .hand = "left-hand"});
}

void run_g84(BlockContext& block) {
  run_tap(block, {.forward = 3, .backward = 4, .hand = "right-hand"});
}

}  // namespace gonogo::reference::rs274
