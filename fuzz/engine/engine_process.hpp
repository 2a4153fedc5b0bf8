// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fuzz/engine/shared_page.hpp"

namespace gonogo::fuzz {

// libFuzzer's own: what a timeout and too much memory end the process with.
inline constexpr int kTimeoutExit = 70;
inline constexpr int kMemoryExit = 71;

// Whether libFuzzer is linked in.
bool is_engine_linked();

// Runs the engine until it ends the process.
[[noreturn]] void run_engine_here(const FuzzOptions& options, SharedPage& page);

}  // namespace gonogo::fuzz
