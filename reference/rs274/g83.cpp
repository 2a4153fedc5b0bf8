// SPDX-License-Identifier: GPL-3.0-or-later
//
// G83, deep drilling: pecks, each with the way out of the hole and back.
#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/pecking.hpp"

namespace gonogo::reference::rs274 {
namespace {

struct DeepPecks {
  Number count;                     // N
  Number depth;                     // q
  Number withdrawn;                 // NGC-G83-02: the level to which the tool leaves the hole
  std::optional<Number> clearance;  // d; nothing: back at the feed (ngc.g83.return = feed)
};

Generator<Item> drill_deep(const Holes& holes, DeepPecks pecks) {
  for (Number k = 1; k < pecks.count; k += 1) {
    const Number end = end_of_peck(holes, pecks.depth, k);
    co_yield holes.feed("NGC-G83-01"_clause, end);
    co_yield holes.dwell("NGC-G83-01"_clause);
    co_yield holes.rapid("NGC-G83-02"_clause, pecks.withdrawn);
    // NGC-G83-05: above R where d is larger than k q.
    if (pecks.clearance) co_yield holes.rapid("NGC-G83-03"_clause, end + *pecks.clearance);
  }
  co_yield holes.feed("NGC-G83-01"_clause, holes.bottom);
  co_yield holes.dwell("NGC-G83-01"_clause);
  co_yield holes.rapid("NGC-G83-06"_clause, holes.clear);
}

DeepPecks plan_deep_pecks(PeckBlock& block) {
  const HoleBlock& holes = block.holes();
  const ReadingsInUse& readings = holes.block().readings;
  DeepPecks pecks{block.count(), block.depth(), holes.levels().r_plane, std::nullopt};
  if (!block.has_several()) return pecks;
  // NGC-G83-02
  const Number clear = holes.clear();
  if (clear != pecks.withdrawn && readings.is("ngc.g83.retract=clear"_reading)) {
    pecks.withdrawn = clear;
  }
  // NGC-G83-03
  if (readings.is("ngc.g83.return=rapid"_reading)) pecks.clearance = block.clearance();
  return pecks;
}

}  // namespace

void run_g83(BlockContext& block) {
  PeckBlock pecks(block);
  if (!pecks.holes().is_sound()) return pecks.holes().stop();
  pecks.holes().run(
      [plan = plan_deep_pecks(pecks)](const Holes& holes) { return drill_deep(holes, plan); });
}

}  // namespace gonogo::reference::rs274
