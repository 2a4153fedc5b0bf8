// SPDX-License-Identifier: GPL-3.0-or-later
//
// The limits that a run was given, which its results hold as its command line only.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cli/options.hpp"

namespace gonogo::cli {

// The limits of the run with this header, its sandbox, how it read captured output, and whether it
// showed names of cases.
LimitOptions limits_of_run(const nlohmann::ordered_json& header);

// Throws UsageError when the run whose journal this is was begun with other limits. A journal that
// is not there or cannot be read is no matter of this.
void need_same_limits(const std::string& journal, const LimitOptions& limits);

}  // namespace gonogo::cli
