// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fuzz/engine/shared_page.hpp"

namespace gonogo::fuzz {

// Runs the engine until it ends the process.
[[noreturn]] void run_engine_here(const FuzzOptions& options, SharedPage& page);

}  // namespace gonogo::fuzz
