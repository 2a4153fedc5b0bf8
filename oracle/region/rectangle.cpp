// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/rectangle.hpp"

namespace gonogo::oracle::region {
namespace {

// How far beyond [-half, half].
Number beyond(const Number& coordinate, const Number& half) {
  Number excess = exact::abs(coordinate) - half;
  return excess.sign() > 0 ? excess : Number();
}

Interval beyond(Interval coordinate, Interval half) {
  const Interval size = abs(coordinate);
  if (half.sup() == 0) return size;
  return CGAL::max(size - half, Interval(0));
}

}  // namespace

RoundedRectangle rounded_rectangle(const Number& half_length, const Number& half_width,
                                   const Number& corner_radius) {
  return {half_length - corner_radius, half_width - corner_radius, corner_radius};
}

Number squared_distance_to_core(const RoundedRectangle& shape, const PlanePoint& point) {
  const Number p = beyond(point.p, shape.core_p);
  const Number q = beyond(point.q, shape.core_q);
  return p * p + q * q;
}

Number inner_radius(const RoundedRectangle& shape) {
  return exact::min(shape.core_p, shape.core_q) + shape.radius;
}

std::optional<RoundedRectangle> eroded(const RoundedRectangle& shape, const Number& by) {
  if (by <= shape.radius) return with_radius(shape, shape.radius - by);
  const Number rest = by - shape.radius;
  if (rest > shape.core_p || rest > shape.core_q) return std::nullopt;
  return RoundedRectangle{shape.core_p - rest, shape.core_q - rest, Number()};
}

bool leads_away(const RoundedRectangle& shape, int sp, int sq, const PlanePoint& direction) {
  if (shape.core_p.sign() != 0 && direction.p.sign() * sp < 0) return false;
  return shape.core_q.sign() == 0 || direction.q.sign() * sq >= 0;
}

std::vector<Corner> corners_of(const RoundedRectangle& shape) {
  std::vector<Corner> corners;
  for (const int sp : {1, -1}) {
    if (sp < 0 && shape.core_p.sign() == 0) continue;
    for (const int sq : {1, -1}) {
      if (sq < 0 && shape.core_q.sign() == 0) continue;
      corners.push_back({sp, sq, {Number(sp) * shape.core_p, Number(sq) * shape.core_q}});
    }
  }
  return corners;
}

EnclosedRectangle enclose(const RoundedRectangle& shape) {
  const Rounding outward;
  const Interval radius = enclose(shape.radius);
  return {enclose(shape.core_p), enclose(shape.core_q), radius, square(radius)};
}

Interval squared_distance_to_core(const EnclosedRectangle& shape, const IntervalVector& point) {
  return square(beyond(point.x(), shape.core_p)) + square(beyond(point.y(), shape.core_q));
}

double rough_distance(const EnclosedRectangle& shape, double x, double y) {
  const double dx = std::max(0.0, std::fabs(x) - shape.core_p.inf());
  const double dy = std::max(0.0, std::fabs(y) - shape.core_q.inf());
  return std::sqrt(dx * dx + dy * dy) - shape.radius.inf();
}

}  // namespace gonogo::oracle::region
