// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/space_circle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "oracle/motion/approximate.hpp"
#include "oracle/region/constants.hpp"
#include "reference/geometry/intersections.hpp"

namespace gonogo::oracle {

namespace {

using geometry::Iso_cuboid_3;
using geometry::Plane_3;
using geometry::Point_3;
using geometry::Segment_3;
using geometry::Triangle_3;
using geometry::Vector_3;

Point_3 place(const SpacePoint& point) {
  return {point[0], point[1], point[2]};
}

Vector_3 way(const SpacePoint& vector) {
  return {vector[0], vector[1], vector[2]};
}

template <typename T>  // Point_3, Vector_3
SpacePoint coordinates(const T& of) {
  return {of.x(), of.y(), of.z()};
}

}  // namespace

SpacePoint space_point(const Position& point) {
  return {point[Axis::x], point[Axis::y], point[Axis::z]};
}

SpacePoint operator-(const SpacePoint& a, const SpacePoint& b) {
  return coordinates(way(a) - way(b));
}

Number dot(const SpacePoint& a, const SpacePoint& b) {
  return CGAL::scalar_product(way(a), way(b));
}

SpacePoint cross(const SpacePoint& a, const SpacePoint& b) {
  return coordinates(CGAL::cross_product(way(a), way(b)));
}

bool is_rational(const SpacePoint& point) {
  return std::ranges::all_of(point, [](const Number& each) { return each.is_rational(); });
}

Position via_of(const Motion& arc3) {
  Position via = arc3.from;
  for (Axis axis : reference::kLinearAxes) via[axis] = arc3.record.via[axis];
  return via;
}

std::optional<SpaceCircle> circle_through(const SpacePoint& a, const SpacePoint& via,
                                          const SpacePoint& b) {
  const Point_3 start = place(a);
  const Vector_3 normal = CGAL::cross_product(place(via) - start, place(b) - start);
  if (normal.squared_length().sign() == 0) return std::nullopt;
  const Point_3 centre = CGAL::circumcenter(start, place(via), place(b));
  return SpaceCircle{coordinates(centre), coordinates(normal), (start - centre).squared_length()};
}

namespace {

// The corners of what a plane and a box have in common, one after the other.
struct CornersInCommon {
  using result_type = std::vector<Point_3>;
  result_type operator()(const Point_3& point) const { return {point}; }
  result_type operator()(const Segment_3& side) const { return {side.source(), side.target()}; }
  result_type operator()(const Triangle_3& area) const { return {area[0], area[1], area[2]}; }
  result_type operator()(const result_type& polygon) const { return polygon; }
};

}  // namespace

bool passes_box(const SpaceCircle& circle, const SpacePoint& point, const Number& tolerance) {
  const Point_3 centre = place(circle.centre);
  const Plane_3 plane(centre, way(circle.normal));
  const Point_3 at = place(point);
  if (tolerance.sign() <= 0) {
    return tolerance.sign() == 0 && plane.has_on(at) &&
           CGAL::squared_distance(centre, at) == circle.radius_2;
  }
  const Vector_3 half(tolerance, tolerance, tolerance);
  const Iso_cuboid_3 box(at - half, at + half);
  const auto common = CGAL::intersection(plane, box);
  if (!common) return false;
  const std::vector<Point_3> corners = boost::apply_visitor(CornersInCommon(), *common);
  bool reaches_out = false;
  bool reaches_in = !box.has_on_unbounded_side(centre);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Segment_3 side(corners[i], corners[(i + 1) % corners.size()]);
    reaches_out = reaches_out || CGAL::squared_distance(centre, corners[i]) >= circle.radius_2;
    reaches_in = reaches_in || CGAL::squared_distance(centre, side) <= circle.radius_2;
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
  const Vector_3 to_b = way(b) - way(a);
  const Vector_3 to_c = way(c) - way(a);
  const Number b_2 = to_b.squared_length();
  const Number c_2 = to_c.squared_length();
  const double length_b = std::sqrt(approximate(b_2));
  const double length_c = std::sqrt(approximate(c_2));
  // Half way where the point's direction halves the angle of the two.
  int exponent = 0;
  const double share = length_b + length_c > 0 ? length_c / (length_b + length_c) : 0.5;
  const double part = std::frexp(share, &exponent);
  const Number t = Number::binary(static_cast<std::int64_t>(std::ldexp(part, kMiddleBits)),
                                  exponent - kMiddleBits);
  const Vector_3 w = to_b * ((Number(1) - t) / b_2) + to_c * (t / c_2);
  return coordinates(place(a) + w / w.squared_length());
}

}  // namespace gonogo::oracle
