// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/open_start.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "oracle/region/constants.hpp"
#include "reference/geometry/intersections.hpp"

namespace gonogo::oracle {
namespace {

using geometry::ORIGIN;
using geometry::Point_2;
using geometry::Segment_2;

Point_2 start_at(const PlaneVector& v) {
  return {v.p, v.q};
}

// Half a plane: normal . v <= limit.
struct HalfPlane {
  HalfPlane(PlaneVector across, Number most)
      : normal(std::move(across)),
        limit(std::move(most)),
        p(estimate(normal.p)),
        q(estimate(normal.q)),
        at(estimate(limit)) {}
  Number beyond(const PlaneVector& v) const { return dot(normal, v) - limit; }
  // Its sign, by doubles where they are certain of it: each of the three terms is off by less than
  // 2^-50 of it, and so are the sums.
  int side(const PlaneVector& v) const {
    const double along_p = p * estimate(v.p);
    const double along_q = q * estimate(v.q);
    const double value = along_p + along_q - at;
    const double off = std::ldexp(std::abs(along_p) + std::abs(along_q) + std::abs(at), -kSureBits);
    if (std::abs(value) > off) return value > 0 ? 1 : -1;
    return beyond(v).sign();
  }
  PlaneVector normal;
  Number limit;
  double p, q, at;  // of both
};

// Leaves the part of the polygon that lies in the half plane. CGAL's kernel clips no polygon.
void cut(std::vector<PlaneVector>& polygon, const HalfPlane& half) {
  std::vector<int> sides;
  for (const PlaneVector& corner : polygon) sides.push_back(half.side(corner));
  if (std::ranges::none_of(sides, [](int side) { return side > 0; })) return;
  std::vector<PlaneVector> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    const PlaneVector& here = polygon[i];
    const PlaneVector& next = polygon[j];
    if (sides[i] <= 0) kept.push_back(here);
    if (sides[i] * sides[j] < 0) {
      const Number beyond = half.beyond(here);
      const Number part = beyond / (beyond - half.beyond(next));
      kept.push_back({here.p + part * (next.p - here.p), here.q + part * (next.q - here.q)});
    }
  }
  polygon = std::move(kept);
}

// A rational near a value, and how far from it the value may lie: nothing for a rational.
struct Near {
  explicit Near(const Number& exact) {
    const auto [low, high] = exact.bounds(kRationalBits);
    value = low;
    error = high - low;
  }
  Number value;
  Number error;
};

// Where row_p . v and row_q . v agree with the point within the tolerance.
std::vector<PlaneVector> cut_to_box(std::vector<PlaneVector> polygon, const PlaneVector& row_p,
                                    const PlaneVector& row_q, const PlaneVector& point,
                                    const Number& tolerance) {
  auto opposite = [](const PlaneVector& v) { return PlaneVector{-v.p, -v.q}; };
  cut(polygon, {row_p, point.p + tolerance});
  cut(polygon, {opposite(row_p), tolerance - point.p});
  cut(polygon, {row_q, point.q + tolerance});
  cut(polygon, {opposite(row_q), tolerance - point.q});
  return polygon;
}

}  // namespace

PlaneVector apply(const Similarity& map, const PlaneVector& v) {
  return {map.a * v.p - map.b * v.q, map.b * v.p + map.a * v.q};
}

Similarity turn_by(const Number& degrees) {
  const auto [cosine, sine] = exact::cos_sin_degrees(degrees);
  return {cosine, sine};
}

OpenStart::OpenStart(Number radius, Number tolerance)
    : radius_(std::move(radius)), tolerance_(std::move(tolerance)) {
  left_.sure = {{-radius_, -radius_}, {radius_, -radius_}, {radius_, radius_}, {-radius_, radius_}};
  left_.possible = left_.sure;
}

// Each side of the box round the point, as a half plane of the start. Rationals in place of
// enclosures move a side by no more than `moved`, since no start lies farther out than the square
// round the circle.
OpenStart::Starts OpenStart::narrowed(const Similarity& map, const PlaneVector& point) const {
  const Near a(map.a), b(map.b), p(point.p), q(point.q);
  const PlaneVector row_p{a.value, -b.value};
  const PlaneVector row_q{b.value, a.value};
  const PlaneVector at{p.value, q.value};
  const Number moved = radius_ * (a.error + b.error) + max(p.error, q.error);
  Starts starts;
  starts.possible = cut_to_box(left_.possible, row_p, row_q, at, tolerance_ + moved);
  starts.sure = moved.sign() == 0 && left_.is_certain
                    ? starts.possible
                    : cut_to_box(left_.sure, row_p, row_q, at, tolerance_ - moved);
  starts.is_certain = moved.sign() == 0 && left_.is_certain;
  return starts;
}

// A convex region meets the circle when its nearest point is not outside and its farthest not
// inside.
bool OpenStart::meets_circle(const Polygon& polygon) const {
  const Number radius_2 = radius_ * radius_;
  const Point_2 middle = ORIGIN;
  bool reaches_out = false;
  bool reaches_in = false;
  bool holds_origin = polygon.size() > 2;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point_2 here = start_at(polygon[i]);
    const Segment_2 side(here, start_at(polygon[(i + 1) % polygon.size()]));
    reaches_out = reaches_out || CGAL::squared_distance(middle, here) >= radius_2;
    reaches_in = reaches_in || CGAL::squared_distance(middle, side) <= radius_2;
    holds_origin =
        holds_origin && CGAL::orientation(middle, here, side.target()) == CGAL::LEFT_TURN;
  }
  return reaches_out && (reaches_in || holds_origin);
}

bool OpenStart::meet_circle(const Starts& starts) const {
  if (meets_circle(starts.sure)) return true;
  if (starts.is_certain || !meets_circle(starts.possible)) return false;
  throw exact::Undecided("whether a point agrees with the curve hangs on an enclosure's width");
}

bool OpenStart::admits(const Similarity& map, const PlaneVector& point) const {
  return meet_circle(narrowed(map, point));
}

bool OpenStart::narrow(const Similarity& map, const PlaneVector& point) {
  Starts starts = narrowed(map, point);
  if (!meet_circle(starts)) return false;
  left_ = std::move(starts);
  return true;
}

}  // namespace gonogo::oracle
