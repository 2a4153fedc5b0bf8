// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which judge a free step has. A cycle whose path is open comes in here.
#include "oracle/open/free_step_memory.hpp"
#include "oracle/open/helix_pocket_judge.hpp"
#include "oracle/open/pocket_level_step.hpp"
#include "oracle/open/pocket_milling_judge.hpp"
#include "oracle/open/thread_step.hpp"

namespace gonogo::oracle {

bool is_free_step(const ReferenceStep& step) {
  return std::holds_alternative<reference::PocketLevel>(step) ||
         std::holds_alternative<reference::HelixPocket>(step) ||
         std::holds_alternative<reference::ThreadMilling>(step) ||
         std::holds_alternative<reference::PocketMilling>(step);
}

std::unique_ptr<FreeStep> make_free_step(const ReferenceSteps::Step& step,
                                         const Tolerances& tolerances, FreeStepMemory& memory) {
  if (auto* level = std::get_if<reference::PocketLevel>(&step.what)) {
    return std::make_unique<PocketLevelStep>(*level, step.place, tolerances, memory.level);
  }
  if (auto* pocket = std::get_if<reference::HelixPocket>(&step.what)) {
    return std::make_unique<HelixPocketJudge>(*pocket, step.place, tolerances);
  }
  if (auto* thread = std::get_if<reference::ThreadMilling>(&step.what)) {
    return std::make_unique<ThreadStep>(*thread, step.place, tolerances, memory.run_outs);
  }
  if (auto* pocket = std::get_if<reference::PocketMilling>(&step.what)) {
    return std::make_unique<PocketMillingJudge>(*pocket, step.place, tolerances);
  }
  return nullptr;
}

}  // namespace gonogo::oracle
