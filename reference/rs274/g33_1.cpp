// SPDX-License-Identifier: GPL-3.0-or-later
//
// G33.1, rigid tapping: in step with the spindle to the point and back. NGC-G331-03: I, the speed
// of the spindle on the way back, changes nothing of this.
#include "reference/clause_literal.hpp"
#include "reference/rs274/synchronous.hpp"

namespace gonogo::reference::rs274 {
// NGC-G331-01
void run_g33_1(BlockContext& block) {
  const ClauseId clause = "NGC-G331-01"_clause;
  const std::optional<SynchronousMotion> in = synchronous_motion(block, "G33.1");
  if (!in) return;
  SynchronousMotion out = *in;
  out.to = block.machine.position;
  // NGC-G331-02
  const int sense = block.machine.spindle;
  const auto turn = [&](int m) { block.put(function_record(block.line, "NGC-G331-02"_clause, m)); };
  const bool moves = in->moves_from(out.to);
  if (moves) block.put(thread_to(block, clause, *in));
  turn(sense == 3 ? 4 : 3);
  if (moves) block.put(thread_to(block, clause, out));
  turn(sense);
}

}  // namespace gonogo::reference::rs274
