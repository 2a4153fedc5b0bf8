// SPDX-License-Identifier: GPL-3.0-or-later
//
// G80, the cutting cycle of the inner and outer diameter: cylinder and taper. From A, where the
// tool stands, to B, C, D and back.
#include "reference/clause_literal.hpp"
#include "reference/hnc21t/cycle.hpp"

namespace gonogo::reference::hnc21t {

void run_g80(BlockContext& block) {
  if (does_nothing(block, kAxisAddresses)) return;
  const Position a = block.machine.position;
  const std::optional<EndPoint> c = cycle_end_point(block);
  block.need_feed();
  if (!c) return;
  // HNC-G80-02: a true length, in absolute and incremental programs; nothing limits it.
  const Number i = block.machine.command.i.value_or(0);

  block.name_corners(Axis::x, Axis::z, i, c->over(a));
  // HNC-G80-01
  const ClauseId clause = "HNC-G80-01"_clause;
  block.rapid(clause, {{Axis::x, c->x + i}});
  block.feed(clause, {{Axis::x, c->x}, {Axis::z, c->z}});
  block.feed(clause, {{Axis::x, a[Axis::x]}});
  block.rapid(clause, {{Axis::z, a[Axis::z]}});
}

}  // namespace gonogo::reference::hnc21t
