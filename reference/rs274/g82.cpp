// SPDX-License-Identifier: GPL-3.0-or-later
//
// G82, drilling with a dwell.
#include "reference/clause_literal.hpp"
#include "reference/rs274/hole_block.hpp"

namespace gonogo::reference::rs274 {
namespace {

// NGC-G82-01
Generator<Item> drill_and_dwell(const Holes& holes) {
  const ClauseId clause = "NGC-G82-01"_clause;
  co_yield holes.feed(clause, holes.bottom);
  co_yield holes.dwell(clause);
  co_yield holes.rapid(clause, holes.clear);
}

}  // namespace

void run_g82(BlockContext& block) {
  HoleBlock(block, OwnWord::needs_p).run(drill_and_dwell);
}

}  // namespace gonogo::reference::rs274
