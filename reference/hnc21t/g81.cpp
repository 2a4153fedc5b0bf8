// SPDX-License-Identifier: GPL-3.0-or-later
//
// G81, the cutting cycle of the face: straight and taper, the mirror of G80. From A, where the tool
// stands, to B, C, D and back.
#include "reference/clause_literal.hpp"
#include "reference/hnc21t/cycle.hpp"

namespace gonogo::reference::hnc21t {

void run_g81(BlockContext& block) {
  if (does_nothing(block, kAxisAddresses)) return;
  const Position a = block.machine.position;
  const std::optional<EndPoint> c = cycle_end_point(block);
  block.need_feed();
  if (!c) return;
  const Number k = block.machine.command.k.value_or(0);  // HNC-G81-02

  block.name_corners(Axis::z, Axis::x, k, c->over(a));
  // HNC-G81-01
  const ClauseId clause = "HNC-G81-01"_clause;
  block.rapid(clause, {{Axis::z, c->z + k}});
  block.feed(clause, {{Axis::x, c->x}, {Axis::z, c->z}});
  block.feed(clause, {{Axis::z, a[Axis::z]}});
  block.rapid(clause, {{Axis::x, a[Axis::x]}});
}

}  // namespace gonogo::reference::hnc21t
