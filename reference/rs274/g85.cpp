// SPDX-License-Identifier: GPL-3.0-or-later
//
// G85, boring, out at the feed.
#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/hole_block.hpp"

namespace gonogo::reference::rs274 {
namespace {

// NGC-G85-01. `feeds_to`: the level to which the tool leaves the hole at the feed.
Generator<Item> bore(const Holes& holes, Number feeds_to) {
  const ClauseId clause = "NGC-G85-01"_clause;
  co_yield holes.feed(clause, holes.bottom);
  co_yield holes.feed(clause, feeds_to);
  co_yield holes.rapid(clause, holes.clear);
}

}  // namespace

void run_g85(BlockContext& block) {
  HoleBlock holes(block);
  if (!holes.is_sound()) return holes.stop();
  Number feeds_to = holes.levels().r_plane;
  const Number clear = holes.clear();
  if (clear != feeds_to && block.readings.is("ngc.g85.out=clear"_reading)) feeds_to = clear;
  holes.run([feeds_to](const Holes& ready) { return bore(ready, feeds_to); });
}

}  // namespace gonogo::reference::rs274
