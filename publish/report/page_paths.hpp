// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths as the page's turnable view takes them.
#pragma once

#include "publish/report/case_paths.hpp"
#include "publish/report/figure.hpp"

namespace gonogo::oracle::report {

// A list of whole numbers a record, in 1e-4 mm: what it is (1 rapid, 2 it begins elsewhere than the
// one before ended), in the latter case where, then the steps from point to point, three numbers
// each. A record that does not move has an empty list. Curves have at most `steps_of_turn` steps a
// turn.
Json moves_json(const Path& path, std::size_t steps_of_turn);
// The points of limits: {"kind", "text", "points"}, of the border of a pocket with "tool", its
// radius, and "axes", the places of the plane's axes in a point.
Json limits_json(const std::vector<Limit>& limits);

}  // namespace gonogo::oracle::report
