// SPDX-License-Identifier: GPL-3.0-or-later
//
// One straight motion of a level: exact, with enclosures beside it.
#pragma once

#include "oracle/region/arc.hpp"

namespace gonogo::oracle::region {

struct Line {
  PlanePoint from;
  PlanePoint to;

  IntervalVector a;  // the ends
  IntervalVector b;
  IntervalVector u;  // unit direction
  Interval length;
};

// REQUIRES: the points differ.
Line make_line(const PlanePoint& from, const PlanePoint& to);
// One line for two, the second going on straight where the first ends.
std::optional<Line> joined(const Line& first, const Line& second);

Number squared_distance(const Line& line, const PlanePoint& point);
Interval squared_distance(const Line& line, const IntervalVector& point);
// The same for a line that is known by its enclosures only.
Interval squared_distance(const IntervalVector& a, const IntervalVector& b, const IntervalVector& u,
                          Interval length, const IntervalVector& point);

}  // namespace gonogo::oracle::region
