// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each command of the program with its place in the help and two examples.
#pragma once

#include <vector>

#include "cli/command_line.hpp"

namespace gonogo::cli {

std::vector<CommandGroup> command_groups();

}  // namespace gonogo::cli
