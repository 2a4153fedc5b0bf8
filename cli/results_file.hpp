// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results named on the command line.
#pragma once

#include <string>

namespace gonogo::cli {

// The file itself; a folder stands for the results in it, or for the journal of a run that has not
// ended. Throws UsageError where there is none.
std::string results_in(const std::string& path);

}  // namespace gonogo::cli
