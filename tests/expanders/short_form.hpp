// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "harness.hpp"

namespace gonogo::expanders::testing {

/// The records of an outcome, but M2 and the end, and its alarm: `R1,2,3` rapid, `F1,2,3` feed and
/// `T1,2,3@4` thread to x, y, z with its lead; `D0.5` dwell, `M3` function; `alarm CLASS`. Axes
/// that have not moved are at 0.
std::vector<std::string> short_form(const Outcome& outcome);

}  // namespace gonogo::expanders::testing
