// SPDX-License-Identifier: GPL-3.0-or-later
//
// G33.1, rigid tapping: in step with the spindle to the point and back. NGC-G331-03: I, the speed
// of the spindle on the way back, changes nothing of this.
#include "reference/clause_literal.hpp"
#include "reference/rs274/synchronous.hpp"

namespace gonogo::reference::rs274 {
namespace {

// NGC-G331-02
Record reversal(const BlockContext& block, int m) {
  Record record;
  record.kind = RecordKind::m;
  record.block = block.line;
  record.clause = "NGC-G331-02"_clause;
  record.m = m;
  record.among_motions = true;
  return record;
}

}  // namespace

// NGC-G331-01
void run_g33_1(BlockContext& block) {
  const ClauseId clause = "NGC-G331-01"_clause;
  const std::optional<SynchronousMotion> in = synchronous_motion(block, "G33.1");
  if (!in) return;
  SynchronousMotion out = *in;
  out.to = block.machine.position;
  const int sense = block.machine.spindle;
  const bool moves = in->moves_from(out.to);
  if (moves) block.put(thread_to(block, clause, *in));
  block.put(reversal(block, sense == 3 ? 4 : 3));
  if (moves) block.put(thread_to(block, clause, out));
  block.put(reversal(block, sense));
}

}  // namespace gonogo::reference::rs274
