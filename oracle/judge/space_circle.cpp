// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/space_circle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "oracle/judge/approximate.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {

SpacePoint space_point(const Position& point) {
  return {point[Axis::x], point[Axis::y], point[Axis::z]};
}

SpacePoint operator+(const SpacePoint& a, const SpacePoint& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

SpacePoint operator-(const SpacePoint& a, const SpacePoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

SpacePoint operator*(const Number& k, const SpacePoint& a) {
  return {k * a[0], k * a[1], k * a[2]};
}

Number dot(const SpacePoint& a, const SpacePoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

SpacePoint cross(const SpacePoint& a, const SpacePoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool is_rational(const SpacePoint& point) {
  return std::ranges::all_of(point, [](const Number& each) { return each.is_rational(); });
}

Position via_of(const Motion& arc3) {
  Position via = arc3.from;
  for (Axis axis : reference::kLinearAxes) via[axis] = arc3.record.via[axis];
  return via;
}

bool is_over_half(const Motion& arc3) {
  const SpacePoint via = space_point(arc3.record.via);
  return dot(space_point(arc3.from) - via, space_point(arc3.to()) - via).sign() > 0;
}

std::optional<SpaceCircle> circle_through(const SpacePoint& a, const SpacePoint& via,
                                          const SpacePoint& b) {
  const SpacePoint u = via - a;
  const SpacePoint v = b - a;
  const SpacePoint normal = cross(u, v);
  const Number normal_2 = dot(normal, normal);
  if (normal_2.sign() == 0) return std::nullopt;
  const SpacePoint to_centre =
      (Number(1) / (normal_2 * 2)) * (dot(u, u) * cross(v, normal) + dot(v, v) * cross(normal, u));
  return SpaceCircle{a + to_centre, normal, dot(to_centre, to_centre)};
}

namespace {

// The part of the convex polygon in which coordinate `i` times `sign` is no more than `limit`.
std::vector<SpacePoint> cut_off(const std::vector<SpacePoint>& polygon, std::size_t i,
                                const Number& sign, const Number& limit) {
  std::vector<SpacePoint> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const SpacePoint& here = polygon[k];
    const SpacePoint& next = polygon[(k + 1) % polygon.size()];
    const Number beyond_here = sign * here[i] - limit;
    const Number beyond_next = sign * next[i] - limit;
    if (beyond_here.sign() <= 0) kept.push_back(here);
    if (beyond_here.sign() * beyond_next.sign() < 0) {
      kept.push_back(here + (beyond_here / (beyond_here - beyond_next)) * (next - here));
    }
  }
  return kept;
}

// The squared distance of the line from a to b from the origin.
Number line_distance_2(const SpacePoint& a, const SpacePoint& b) {
  const SpacePoint along = b - a;
  const Number length_2 = dot(along, along);
  const Number at = -dot(a, along);
  if (length_2.sign() == 0 || at.sign() <= 0) return dot(a, a);
  if (at >= length_2) return dot(b, b);
  return dot(a, a) - at * at / length_2;
}

}  // namespace

bool passes_box(const SpaceCircle& circle, const SpacePoint& point, const Number& tolerance) {
  const SpacePoint& n = circle.normal;
  const SpacePoint at = point - circle.centre;
  std::size_t a = 0;  // the axis across which the plane lies most
  for (std::size_t i : {1U, 2U}) {
    if (abs(n[i]) > abs(n[a])) a = i;
  }
  const std::size_t b = (a + 1) % 3;
  const std::size_t c = (a + 2) % 3;
  std::vector<SpacePoint> polygon;
  for (const auto& [side_b, side_c] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
    SpacePoint corner;
    corner[b] = at[b] + tolerance * side_b;
    corner[c] = at[c] + tolerance * side_c;
    corner[a] = -(n[b] * corner[b] + n[c] * corner[c]) / n[a];
    polygon.push_back(std::move(corner));
  }
  polygon = cut_off(polygon, a, 1, at[a] + tolerance);
  polygon = cut_off(polygon, a, -1, tolerance - at[a]);
  if (polygon.empty()) return false;
  const bool holds_centre =
      std::ranges::all_of(at, [&](const Number& each) { return abs(each) <= tolerance; });
  bool reaches_out = false;
  bool reaches_in = holds_centre;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const SpacePoint& next = polygon[(i + 1) % polygon.size()];
    reaches_out = reaches_out || dot(polygon[i], polygon[i]) >= circle.radius_2;
    reaches_in = reaches_in || line_distance_2(polygon[i], next) <= circle.radius_2;
  }
  return reaches_out && reaches_in;
}

double part_of_turn(const SpaceCircle& circle, const SpacePoint& from, const SpacePoint& to) {
  const auto doubles = [](const SpacePoint& v) {
    return std::array{approximate(v[0]), approximate(v[1]), approximate(v[2])};
  };
  const auto n = doubles(circle.normal);
  const auto a = doubles(from - circle.centre);
  const auto b = doubles(to - circle.centre);
  const double length = std::hypot(n[0], n[1], n[2]);
  if (length == 0) return 0;
  const double across = (n[0] * (a[1] * b[2] - a[2] * b[1]) + n[1] * (a[2] * b[0] - a[0] * b[2]) +
                         n[2] * (a[0] * b[1] - a[1] * b[0])) /
                        length;
  const double along = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const double part = std::atan2(across, along) / (2 * std::numbers::pi);
  return part < 0 ? part + 1 : part;
}

SpacePoint middle_seen_from(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c) {
  const SpacePoint to_b = b - a;
  const SpacePoint to_c = c - a;
  const Number b_2 = dot(to_b, to_b);
  const Number c_2 = dot(to_c, to_c);
  const double length_b = std::sqrt(approximate(b_2));
  const double length_c = std::sqrt(approximate(c_2));
  // Half way where the point's direction halves the angle of the two.
  int exponent = 0;
  const double share = length_b + length_c > 0 ? length_c / (length_b + length_c) : 0.5;
  const double part = std::frexp(share, &exponent);
  const Number t = Number::binary(static_cast<std::int64_t>(std::ldexp(part, kMiddleBits)),
                                  exponent - kMiddleBits);
  const SpacePoint w = ((Number(1) - t) / b_2) * to_b + (t / c_2) * to_c;
  return a + (Number(1) / dot(w, w)) * w;
}

}  // namespace gonogo::oracle
