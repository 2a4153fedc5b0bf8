// SPDX-License-Identifier: GPL-3.0-or-later
//
// --sandbox and --bind.
#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"

namespace gonogo::cli {

// Adds --sandbox auto|off|required and --bind PATH[:rw] to a command. `by_default` holds where
// --sandbox is not given.
void add_sandbox_options(Command& command, SandboxOptions& options, const std::string& by_default);

// The limits with the sandbox for a subject of this kind; `hidden` are folders that it does not
// see. Throws UsageError when a sandbox is required and cannot be had.
oracle::Limits sandboxed(oracle::Limits limits, const SandboxOptions& options,
                         const std::string& subject, const std::vector<std::string>& hidden);

// "bubblewrap", "none"; empty for a subject that starts no process.
std::string sandbox_name(const oracle::Limits& limits, const std::string& subject);

}  // namespace gonogo::cli
