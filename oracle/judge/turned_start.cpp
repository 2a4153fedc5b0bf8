// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/turned_start.hpp"

namespace gonogo::oracle {
namespace {

Number dot(const PlaneVector& a, const PlaneVector& b) {
  return a.p * b.p + a.q * b.q;
}

Number cross(const PlaneVector& a, const PlaneVector& b) {
  return a.p * b.q - a.q * b.p;
}

// The part of the polygon where normal . v <= limit.
std::vector<PlaneVector> cut(const std::vector<PlaneVector>& polygon, const PlaneVector& normal,
                             const Number& limit) {
  std::vector<PlaneVector> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlaneVector& here = polygon[i];
    const PlaneVector& next = polygon[(i + 1) % polygon.size()];
    const Number beyond_here = dot(normal, here) - limit;
    const Number beyond_next = dot(normal, next) - limit;
    const int side_here = beyond_here.sign();
    const int side_next = beyond_next.sign();
    if (side_here <= 0) kept.push_back(here);
    if (side_here * side_next < 0) {
      const Number part = beyond_here / (beyond_here - beyond_next);
      kept.push_back({here.p + part * (next.p - here.p), here.q + part * (next.q - here.q)});
    }
  }
  return kept;
}

// The squared distance of the segment from the origin.
Number squared_distance(const PlaneVector& a, const PlaneVector& b) {
  const PlaneVector along{b.p - a.p, b.q - a.q};
  const Number length_2 = dot(along, along);
  const Number at = -dot(a, along);
  if (length_2.sign() == 0 || at.sign() <= 0) return dot(a, a);
  if (at >= length_2) return dot(b, b);
  const Number away = cross(a, along);
  return away * away / length_2;
}

// The value, or a rational within 2^-80 of it.
constexpr int kBits = 80;
Number near(const Number& value) {
  return value.is_rational() ? value : value.bounds(kBits)[0];
}

bool is_rational(const PlaneVector& v) {
  return v.p.is_rational() && v.q.is_rational();
}

// Where row_p . v and row_q . v agree with the point within the tolerance.
std::vector<PlaneVector> cut_to_box(std::vector<PlaneVector> polygon, const PlaneVector& row_p,
                                    const PlaneVector& row_q, const PlaneVector& point,
                                    const Number& tolerance) {
  auto opposite = [](const PlaneVector& v) { return PlaneVector{-v.p, -v.q}; };
  polygon = cut(polygon, row_p, point.p + tolerance);
  polygon = cut(polygon, opposite(row_p), tolerance - point.p);
  polygon = cut(polygon, row_q, point.q + tolerance);
  return cut(polygon, opposite(row_q), tolerance - point.q);
}

}  // namespace

PlaneVector apply(const Similarity& map, const PlaneVector& v) {
  return {map.a * v.p - map.b * v.q, map.b * v.p + map.a * v.q};
}

Similarity turn_by(const Number& degrees) {
  const auto [cosine, sine] = exact::cos_sin_degrees(degrees);
  return {cosine, sine};
}

TurnedStart::TurnedStart(Number radius, Number tolerance)
    : radius_(std::move(radius)), tolerance_(std::move(tolerance)) {
  left_.sure = {{-radius_, -radius_}, {radius_, -radius_}, {radius_, radius_}, {-radius_, radius_}};
  left_.possible = left_.sure;
}

// Each side of the box round the point, as a half plane of the start. Rationals in place of
// enclosures move a side by less than `moved`.
TurnedStart::Starts TurnedStart::narrowed(const Similarity& map, const PlaneVector& point) const {
  const PlaneVector row_p{near(map.a), -near(map.b)};
  const PlaneVector row_q{near(map.b), near(map.a)};
  const PlaneVector at{near(point.p), near(point.q)};
  const bool exactly = is_rational({map.a, map.b}) && is_rational(point);
  const Number moved = exactly ? Number(0) : (radius_ * 4 + 2) * Number::binary(1, -kBits);
  Starts starts;
  starts.possible = cut_to_box(left_.possible, row_p, row_q, at, tolerance_ + moved);
  starts.sure = cut_to_box(left_.sure, row_p, row_q, at, tolerance_ - moved);
  return starts;
}

// A convex region meets the circle when its nearest point is not outside and its farthest not
// inside.
bool TurnedStart::meets_circle(const Polygon& polygon) const {
  const Number radius_2 = radius_ * radius_;
  bool reaches_out = false;
  bool reaches_in = false;
  bool holds_origin = polygon.size() > 2;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PlaneVector& here = polygon[i];
    const PlaneVector& next = polygon[(i + 1) % polygon.size()];
    reaches_out = reaches_out || dot(here, here) >= radius_2;
    reaches_in = reaches_in || squared_distance(here, next) <= radius_2;
    holds_origin = holds_origin && cross(here, next).sign() > 0;
  }
  return reaches_out && (reaches_in || holds_origin);
}

bool TurnedStart::meet_circle(const Starts& starts) const {
  if (meets_circle(starts.sure)) return true;
  if (!meets_circle(starts.possible)) return false;
  throw exact::Undecided("whether a point agrees with the curve hangs on 2^-70 mm");
}

bool TurnedStart::admits(const Similarity& map, const PlaneVector& point) const {
  return meet_circle(narrowed(map, point));
}

bool TurnedStart::narrow(const Similarity& map, const PlaneVector& point) {
  Starts starts = narrowed(map, point);
  if (!meet_circle(starts)) return false;
  left_ = std::move(starts);
  return true;
}

}  // namespace gonogo::oracle
