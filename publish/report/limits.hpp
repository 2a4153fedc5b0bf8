// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a manual fixes where it leaves a path open, as lines to draw.
#pragma once

#include <vector>

#include "publish/report/figure.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle::report {

// Those of one item; none for an item whose path is given.
std::vector<Limit> limits_of(const reference::Item& item);

}  // namespace gonogo::oracle::report
