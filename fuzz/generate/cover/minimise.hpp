// SPDX-License-Identifier: GPL-3.0-or-later
//
// Few cases for many purposes.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace gonogo::cover {

// Numbers of cases, rising, that serve every purpose which one of the cases serves, such that none
// of them can be left out. Greedy, and deterministic: of equally useful cases the first.
std::vector<std::size_t> smallest_cover(const std::vector<std::set<std::string>>& purposes);

}  // namespace gonogo::cover
