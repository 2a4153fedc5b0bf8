// SPDX-License-Identifier: GPL-3.0-or-later
#include "stroke.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle/motion/approximate.hpp"

namespace gonogo::mutations {

using reference::Axis;
using reference::PlaneAxes;
using std::numbers::pi;

namespace {

constexpr double kMillionth = 1e-6;
constexpr double kSmallest = 1e-9;  // mm: below it a vector has no direction

Vector linear_part(const Place& place) {
  return {place[0], place[1], place[2]};
}

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector scaled(const Vector& a, double by) {
  return {a[0] * by, a[1] * by, a[2] * by};
}

Vector unit(Axis axis) {
  Vector v{};
  v[index(axis)] = 1;
  return v;
}

double angle_about(const Stroke& stroke, const Place& place) {
  const Vector arm = linear_part(place) - stroke.centre;
  return std::atan2(dot(arm, stroke.v), dot(arm, stroke.u));
}

double radius_about(const Stroke& stroke, const Place& place) {
  const Vector arm = linear_part(place) - stroke.centre;
  return std::hypot(dot(arm, stroke.u), dot(arm, stroke.v));
}

void measure(Stroke& stroke) {
  stroke.start_angle = angle_about(stroke, stroke.from);
  stroke.from_radius = radius_about(stroke, stroke.from);
  stroke.to_radius = radius_about(stroke, stroke.to);
}

// In [0, 2 pi).
double wrapped(double angle) {
  const double turns = std::floor(angle / (2 * pi));
  return angle - turns * 2 * pi;
}

void make_arc(Stroke& stroke, bool ends_meet) {
  stroke.meets_itself = ends_meet;
  const Record& record = *stroke.record;
  const PlaneAxes axes = axes_of(record.plane);
  stroke.is_round = true;
  stroke.u = unit(axes.p);
  stroke.v = unit(axes.q);
  stroke.centre = linear_part(stroke.from);
  stroke.centre[index(axes.p)] = value_of(record.centre[0]);
  stroke.centre[index(axes.q)] = value_of(record.centre[1]);
  measure(stroke);
  const int sense = record.rot < 0 ? -1 : 1;
  double turn = wrapped(sense * (angle_about(stroke, stroke.to) - stroke.start_angle));
  // From radius to radius on one ray the arc goes all the way round.
  constexpr double kSameRay = 1e-12;
  const bool on_one_ray = turn < kSameRay && std::abs(stroke.to_radius - stroke.from_radius) > 0.1;
  if (ends_meet || on_one_ray) turn = 2 * pi;
  stroke.sweep = sense * (turn + 2 * pi * (std::abs(record.rot) - 1));
}

// The circle through three points; false where they are in line.
bool make_circle_in_space(Stroke& stroke, const Place& via) {
  const Vector a = linear_part(stroke.from);
  const Vector b = linear_part(via) - a;
  const Vector c = linear_part(stroke.to) - a;
  const Vector normal = cross(b, c);
  const double size = dot(normal, normal);
  if (size < kSmallest * kSmallest) return false;
  const Vector arm =
      scaled(cross(scaled(b, dot(c, c)) - scaled(c, dot(b, b)), normal), -1 / (2 * size));
  stroke.is_round = true;
  stroke.centre = a - scaled(arm, -1);
  const double radius = length_of(arm);
  if (radius < kSmallest) return false;
  stroke.u = scaled(arm, -1 / radius);
  stroke.v = scaled(cross(normal, stroke.u), 1 / std::sqrt(size));
  measure(stroke);
  stroke.sweep = wrapped(angle_about(stroke, stroke.to) - stroke.start_angle);
  return true;
}

}  // namespace

double value_of(const Number& number) {
  using exact::NumberAccess;
  if (NumberAccess::node(number) == nullptr) {
    return static_cast<double>(NumberAccess::millionths(number)) * kMillionth;
  }
  return oracle::approximate(number);
}

Place place_of(const reference::Position& position) {
  Place place{};
  for (const Axis axis : reference::kAllAxes) place[index(axis)] = value_of(position[axis]);
  return place;
}

double apart(const Place& a, const Place& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

double length_of(const Vector& v) {
  return std::sqrt(dot(v, v));
}

double plane_radius(const PlaneAxes& axes, const Place& at, const std::array<double, 2>& centre) {
  return std::hypot(at[index(axes.p)] - centre[0], at[index(axes.q)] - centre[1]);
}

Place Stroke::unnamed(const Place& place) const {
  Place first = place;
  for (std::size_t i = 0; i < first.size(); ++i) first[i] -= renamed[i];
  return first;
}

Place Stroke::at(double part) const {
  Place place = from;
  for (std::size_t i = 0; i < place.size(); ++i) place[i] += (to[i] - from[i]) * part;
  if (!is_round) return place;
  const double radius = from_radius + (to_radius - from_radius) * part;
  const double angle = start_angle + sweep * part;
  const bool in_space = record->kind == RecordKind::arc3;
  for (std::size_t i = 0; i < 3; ++i) {
    const double round = centre[i] + radius * (std::cos(angle) * u[i] + std::sin(angle) * v[i]);
    if (in_space || u[i] != 0 || v[i] != 0) place[i] = round;
  }
  return place;
}

bool Stroke::is_nil(double tolerance) const {
  if (is_dwell()) return record->seconds.sign() == 0;
  if (apart(from, to) > tolerance) return false;
  if (!is_round) return via_apart <= tolerance;
  if (std::max(from_radius, to_radius) <= tolerance / 2) return true;
  return std::abs(sweep) < pi;
}

bool Stroke::is_surely_nil(double tolerance) const {
  return is_nil(tolerance) && (!is_round || std::abs(sweep) < pi);
}

std::vector<Stroke> strokes_of(std::span<const Record> records, const Place& start,
                               std::span<const NewName> names) {
  std::vector<Stroke> strokes;
  strokes.reserve(records.size());
  Place here = start;
  Place renamed{};
  std::size_t named = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const Record& record = records[i];
    for (; named < names.size() && record.block > names[named].block; ++named) {
      for (std::size_t a = 0; a < here.size(); ++a) {
        here[a] += names[named].shift[a];
        renamed[a] += names[named].shift[a];
      }
    }
    if (!is_motion(record.kind) && record.kind != RecordKind::dwell) continue;
    Stroke stroke;
    stroke.record = &record;
    stroke.number = i;
    stroke.from = stroke.to = here;
    stroke.renamed = renamed;
    if (record.kind != RecordKind::dwell) {
      for (const Axis axis : reference::kAllAxes) {
        if (record.axes.has(axis)) stroke.to[index(axis)] = value_of(record.to[axis]);
      }
    }
    if (record.kind == RecordKind::arc) {
      constexpr double kSame = 1e-11;
      const PlaneAxes axes = axes_of(record.plane);
      const bool meet = std::abs(stroke.from[index(axes.p)] - stroke.to[index(axes.p)]) < kSame &&
                        std::abs(stroke.from[index(axes.q)] - stroke.to[index(axes.q)]) < kSame;
      make_arc(stroke, meet);
    } else if (record.kind == RecordKind::arc3) {
      Place via = here;
      for (const Axis axis : reference::kLinearAxes) {
        if (record.via_axes.has(axis)) via[index(axis)] = value_of(record.via[axis]);
      }
      const bool is_circle = make_circle_in_space(stroke, via);
      stroke.via_apart = is_circle ? 0 : apart(stroke.from, via);
    }
    here = stroke.to;
    strokes.push_back(stroke);
  }
  return strokes;
}

}  // namespace gonogo::mutations
