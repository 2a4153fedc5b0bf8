// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "publish/evidence/case_row.hpp"

namespace gonogo::oracle::evidence {

// In what the header of a run differs from the command line that it names: sentences. Empty for a
// merged run, whose command line is that of `merge`.
std::vector<std::string> header_faults(const Json& header);

}  // namespace gonogo::oracle::evidence
