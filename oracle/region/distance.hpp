// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a point is from the path that clears a level: the exact check behind every NO-GO of the
// cover and step rules.
#pragma once

#include <optional>
#include <vector>

#include "oracle/region/line.hpp"

namespace gonogo::oracle::region {

// What clears a level: its arcs, its lines where they count, the single points that it visits, and
// the plunge point.
struct Path {
  std::vector<Arc> arcs;
  std::vector<PlanePoint> points;
  std::vector<Line> lines = {};
};

// By how much the point is farther than `reach` from the whole path; nothing when it is not, or
// when that does not show. Where a spiral is nearest, the answer is a lower bound above 0.
// REQUIRES: the point is rational.
std::optional<Number> excess(const Path& path, const PlanePoint& point, const Number& reach);

// Bounds of the distance to a round arc; the lower one holds wherever the nearest point is.
Interval distance_to_round(const Arc& arc, const IntervalVector& point);

}  // namespace gonogo::oracle::region
