// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonogo::oracle::report {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kSamePoint = 1e-9;  // mm

Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

std::size_t steps_for(double sweep, std::size_t most) {
  const double wanted = std::ceil(std::abs(sweep) / kTurn * kStepsPerTurn - 1e-6);
  const double limited = std::min(wanted, static_cast<double>(std::max<std::size_t>(most, 1)));
  return static_cast<std::size_t>(std::max(limited, 1.0));
}

// The way from one polar vector to the other in the sense of rot, with its whole turns.
double sweep_of(double from, double to, bool same_point, int rot) {
  double sweep = same_point ? 0 : std::fmod(to - from, kTurn);
  if (rot > 0 && sweep <= 0) sweep += kTurn;
  if (rot < 0 && sweep >= 0) sweep -= kTurn;
  const double whole = std::abs(static_cast<double>(rot)) - 1;
  return sweep + (rot > 0 ? kTurn : -kTurn) * whole;
}

}  // namespace

std::vector<Point3> sample_arc(const Point3& from, const Point3& to, const ArcShape& shape,
                               std::size_t max_segments) {
  const auto [p, q, d] = reference::axes_of(shape.plane);
  const double p0 = from[p] - shape.centre[0];
  const double q0 = from[q] - shape.centre[1];
  const double p1 = to[p] - shape.centre[0];
  const double q1 = to[q] - shape.centre[1];
  const double r0 = std::hypot(p0, q0);
  const double r1 = std::hypot(p1, q1);
  if (shape.rot == 0) return {from, to};
  // Where the radius is nothing at one end, that end has the angle of the other.
  const double a0 = r0 > kSamePoint ? std::atan2(q0, p0) : std::atan2(q1, p1);
  const double a1 = r1 > kSamePoint ? std::atan2(q1, p1) : a0;
  const bool same_point = std::hypot(p1 - p0, q1 - q0) < kSamePoint;
  const double sweep = sweep_of(a0, a1, same_point, shape.rot);
  const std::size_t steps = steps_for(sweep, max_segments);
  std::vector<Point3> points;
  points.reserve(steps + 1);
  points.push_back(from);
  for (std::size_t i = 1; i < steps; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(steps);
    const double radius = r0 + (r1 - r0) * share;
    Point3 point = from + share * (to - from);
    point[p] = shape.centre[0] + radius * std::cos(a0 + sweep * share);
    point[q] = shape.centre[1] + radius * std::sin(a0 + sweep * share);
    points.push_back(point);
  }
  points.push_back(to);
  return points;
}

std::vector<Point3> sample_circle(const Point3& from, const Point3& via, const Point3& to,
                                  std::size_t max_segments) {
  // The circumcentre in the plane of the three points.
  const Point3 u = via - from;
  const Point3 v = to - from;
  const Point3 normal = cross(u, v);
  const double n2 = dot(normal, normal);
  if (n2 <= 1e-18 * dot(u, u) * dot(v, v)) return {from, via, to};
  const Point3 to_centre =
      (1 / (2 * n2)) * (dot(u, u) * cross(v, normal) + dot(v, v) * cross(normal, u));
  const Point3 centre = from + to_centre;
  const Point3 e1 = from - centre;
  const Point3 e2 = (1 / std::sqrt(n2)) * cross(normal, e1);
  // The normal is u x v, so that via comes before to in the positive sense.
  double sweep = std::atan2(dot(to - centre, e2), dot(to - centre, e1));
  if (sweep <= 0) sweep += kTurn;
  const std::size_t steps = steps_for(sweep, max_segments);
  std::vector<Point3> points = {from};
  for (std::size_t i = 1; i < steps; ++i) {
    const double angle = sweep * static_cast<double>(i) / static_cast<double>(steps);
    points.push_back(centre + std::cos(angle) * e1 + std::sin(angle) * e2);
  }
  points.push_back(to);
  return points;
}

}  // namespace gonogo::oracle::report
