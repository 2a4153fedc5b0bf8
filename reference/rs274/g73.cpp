// SPDX-License-Identifier: GPL-3.0-or-later
//
// G73, drilling with chip breaking: pecks, each with a short way up.
#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/pecking.hpp"

namespace gonogo::reference::rs274 {
namespace {

struct ShortPecks {
  Number count;      // N
  Number depth;      // q
  Number clearance;  // d
  bool ends_at_r_plane = true;
};

Generator<Item> break_chips(const Holes& holes, ShortPecks pecks) {
  for (Number k = 1; k < pecks.count; k += 1) {
    const Number end = end_of_peck(holes, pecks.depth, k);
    co_yield holes.feed("NGC-G73-01"_clause, end);
    co_yield holes.dwell("NGC-G73-01"_clause);
    co_yield holes.rapid("NGC-G73-01"_clause, end + pecks.clearance);  // NGC-G73-04: also above R
  }
  co_yield holes.feed("NGC-G73-01"_clause, holes.bottom);
  co_yield holes.dwell("NGC-G73-01"_clause);
  if (pecks.ends_at_r_plane) co_yield holes.rapid("NGC-G73-02"_clause, holes.r_plane);
  co_yield holes.rapid("NGC-G73-02"_clause, holes.clear);
}

}  // namespace

void run_g73(BlockContext& block) {
  PeckBlock pecks(block);
  HoleBlock& holes = pecks.holes();
  if (!holes.is_sound()) return holes.stop();
  // NGC-G73-03
  ShortPecks plan{pecks.count(), pecks.depth(), {}};
  if (pecks.has_several()) plan.clearance = pecks.clearance();
  // NGC-G73-02
  if (holes.clear() != holes.levels().r_plane) {
    if (block.readings.is("ngc.g73.end=r-plane"_reading)) holes.end_at_r_plane();
    plan.ends_at_r_plane = !block.readings.is("ngc.g73.end=clear"_reading);
  }
  holes.run([plan](const Holes& ready) { return break_chips(ready, plan); });
}

}  // namespace gonogo::reference::rs274
