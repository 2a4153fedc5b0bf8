// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounded rectangles: all that the judge asks of one is how far a point is from its core.
#pragma once

#include "oracle/region/arc.hpp"

namespace gonogo::oracle::region {

// 0 in the core.
Number squared_distance_to_core(const RoundedRectangle& shape, const PlanePoint& point);
inline bool contains(const RoundedRectangle& shape, const PlanePoint& point) {
  return squared_distance_to_core(shape, point) <= shape.radius * shape.radius;
}
// The same core with another radius.
inline RoundedRectangle with_radius(const RoundedRectangle& shape, const Number& radius) {
  return {shape.core_p, shape.core_q, radius};
}
// Half the width of the shape where it is narrowest.
Number inner_radius(const RoundedRectangle& shape);
// The points whose disc of the given radius lies in the shape: it first takes the radius away,
// then the core. Nothing when there are none.
std::optional<RoundedRectangle> eroded(const RoundedRectangle& shape, const Number& by);

// Whether the direction points away from the core at its corner (sp, sq), each 1 or -1: whether the
// core's nearest point to what lies there is that corner. A core of no extent has no sides.
bool leads_away(const RoundedRectangle& shape, int sp, int sq, const PlanePoint& direction);

// The corners of the core, each once: one of a point, two of a line.
struct Corner {
  int sp;
  int sq;
  PlanePoint at;
};
std::vector<Corner> corners_of(const RoundedRectangle& shape);

// The same shape in doubles.
struct EnclosedRectangle {
  Interval core_p;
  Interval core_q;
  Interval radius;
  Interval radius2;

  bool is_disc() const { return core_p.sup() == 0 && core_q.sup() == 0; }
};

EnclosedRectangle enclose(const RoundedRectangle& shape);
Interval squared_distance_to_core(const EnclosedRectangle& shape, const IntervalVector& point);
// About how far the point lies outside the shape; negative: inside.
double rough_distance(const EnclosedRectangle& shape, double x, double y);

}  // namespace gonogo::oracle::region
