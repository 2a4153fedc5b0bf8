// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace gonogo::cli {

// The words of the command line after the program's name, kept for the results.
std::vector<std::string>& arguments();

}  // namespace gonogo::cli
