// SPDX-License-Identifier: GPL-3.0-or-later
//
// G74, deep drilling of the face: from A, where the tool stands, along Z to the bottom of the hole
// and back. HNC-G74-04: X and U have no effect, or as a reading says the tool is positioned there
// first. The text announces three ways and has lost the third: hnc.g74.mode3 has it as in G75.
#include "reference/clause_literal.hpp"
#include "reference/hnc21t/pecking.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference::hnc21t {

namespace {

void position_x(BlockContext& block) {
  const std::optional<Number> x = block.commanded(kX);
  if (!x || *x == block.machine.position[Axis::x]) return;
  if (block.readings.is("hnc.g74.x=none"_reading)) return;
  block.rapid("HNC-G74-01"_clause, {{Axis::x, *x}});
}

}  // namespace

void run_g74(BlockContext& block) {
  // HNC-G74-02, HNC-G74-03: pecks with withdrawals, or straight to the bottom.
  constexpr PlungeClauses kClauses{"HNC-G74-02"_clause, "HNC-G74-03"_clause};
  check_peck_words(block, "HNC-G74-01"_clause);
  if (does_nothing(block, std::array{kZ})) return;
  const std::optional<Number> bottom = cycle_end_point(block, kZ);
  block.need_feed();
  const Plunge plunge =
      plan_plunge(block, Axis::z, bottom.value_or(block.machine.position[Axis::z]), kClauses);
  if (!block.out.alarms.empty() || block.out.not_covered) return;
  position_x(block);
  block.out.cycle = run_plunge(plunge);
}

}  // namespace gonogo::reference::hnc21t
