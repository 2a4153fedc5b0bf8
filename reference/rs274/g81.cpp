// SPDX-License-Identifier: GPL-3.0-or-later
//
// G81, drilling.
#include "reference/clause_literal.hpp"
#include "reference/rs274/hole_block.hpp"

namespace gonogo::reference::rs274 {
namespace {

// NGC-G81-01
Generator<Item> drill(const Holes& holes) {
  const ClauseId clause = "NGC-G81-01"_clause;
  co_yield holes.feed(clause, holes.bottom);
  co_yield holes.rapid(clause, holes.clear);
}

}  // namespace

void run_g81(BlockContext& block) {
  HoleBlock(block).run(drill);
}

}  // namespace gonogo::reference::rs274
