// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves of records as points, in double.
#pragma once

#include <vector>

#include "publish/report/path.hpp"

namespace gonogo::oracle::report {

inline constexpr double kStepsPerTurn = 128;

// An arc or helix: `plane`, `centre` (p, q) and `rot` as in a record. The radius is linear from the
// radius at the start to that at the end. At most `max_segments` segments.
struct ArcShape {
  reference::Plane plane = reference::Plane::g17;
  std::array<double, 2> centre{};
  int rot = 1;
};
std::vector<Point3> sample_arc(const Point3& from, const Point3& to, const ArcShape& shape,
                               std::size_t max_segments);

// The circle in space from `from` through `via` to `to`; three points in line: two lines.
std::vector<Point3> sample_circle(const Point3& from, const Point3& via, const Point3& to,
                                  std::size_t max_segments);

}  // namespace gonogo::oracle::report
