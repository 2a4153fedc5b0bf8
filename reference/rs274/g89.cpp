// SPDX-License-Identifier: GPL-3.0-or-later
//
// G89, boring with a dwell, out at the feed.
#include "reference/clause_literal.hpp"
#include "reference/rs274/hole_block.hpp"

namespace gonogo::reference::rs274 {
namespace {

// NGC-G89-01: at the feed all the way, also to the initial level, unlike G85.
Generator<Item> bore_and_dwell(const Holes& holes) {
  const ClauseId clause = "NGC-G89-01"_clause;
  co_yield holes.feed(clause, holes.bottom);
  co_yield holes.dwell(clause);
  co_yield holes.feed(clause, holes.clear);
}

}  // namespace

void run_g89(BlockContext& block) {
  HoleBlock(block, OwnWord::needs_p).run(bore_and_dwell);
}

}  // namespace gonogo::reference::rs274
