// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the free steps of one program know of each other.
#pragma once

#include <optional>

#include "oracle/open/thread_run_out.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle {

class FreeStepMemory {
 public:
  RunOutSet run_outs;                           // that explain the threads so far
  std::optional<reference::PocketLevel> level;  // the last one that was judged GO
};

}  // namespace gonogo::oracle
