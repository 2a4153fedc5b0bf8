// SPDX-License-Identifier: GPL-3.0-or-later
//
// G33, a straight motion in step with the spindle.
#include "reference/clause_literal.hpp"
#include "reference/rs274/synchronous.hpp"

namespace gonogo::reference::rs274 {

void run_g33(BlockContext& block) {
  const std::optional<SynchronousMotion> motion = synchronous_motion(block, "G33");
  if (!motion || !motion->moves_from(block.machine.position)) return;
  block.put(thread_to(block, "NGC-G33-01"_clause, *motion));
}

}  // namespace gonogo::reference::rs274
