// SPDX-License-Identifier: GPL-3.0-or-later
// Places, and what is computed between them: in counts, with what is left beside whole ones.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "expanders/common/axes.hpp"

namespace gonogo::expanders::sinumerik {

using Real = long double;
/// A coordinate of each axis, in the order of gonogo_axis.
using Place = std::array<Real, GONOGO_AXES>;
/// Along X, Y, Z.
using Direction = std::array<Real, 3>;

/// Lengths differ when they differ by more: what angles and roots gave is as good as that.
inline constexpr Real kRounding = 1e-3L;

/// To whole counts, as they are put out.
inline Point rounded(const Place& place) {
  Point point{};
  for (std::size_t axis = 0; axis < point.size(); ++axis) point[axis] = std::llround(place[axis]);
  return point;
}

/// A place or direction in the plane, counts.
struct Vector {
  Real p = 0;
  Real q = 0;
  Real length() const { return std::hypot(p, q); }
  /// No place of its own beside the zero.
  bool is_nothing() const { return std::fabs(p) <= kRounding && std::fabs(q) <= kRounding; }
  friend constexpr Vector operator-(const Vector& a, const Vector& b) {
    return {a.p - b.p, a.q - b.q};
  }
};
inline constexpr Real cross(const Vector& a, const Vector& b) {
  return a.p * b.q - a.q * b.p;
}
inline constexpr Real dot(const Vector& a, const Vector& b) {
  return a.p * b.p + a.q * b.q;
}

/// The vector of length 1 with this angle.
inline Vector direction_of(Real degrees) {
  const Real radians = std::remainder(degrees, Real{360}) * (std::numbers::pi_v<Real> / 180);
  return {std::cos(radians), std::sin(radians)};
}

/// `a` turned by the angle of `turn`, which has length 1.
inline constexpr Vector turned(const Vector& a, const Vector& turn) {
  return {a.p * turn.p - a.q * turn.q, a.p * turn.q + a.q * turn.p};
}

inline Real dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Real length(const Direction& a) {
  return std::hypot(a[0], a[1], a[2]);
}
/// The way from one place to another; none at all where it is within rounding.
inline Direction way_between(const Place& from, const Place& to) {
  Direction way{};
  bool moves = false;
  for (std::size_t axis = 0; axis < way.size(); ++axis) {
    way[axis] = to[axis] - from[axis];
    moves = moves || std::fabs(way[axis]) > kRounding;
  }
  return moves ? way : Direction{};
}
inline bool is_nothing(const Direction& a) {
  return a == Direction{};
}

}  // namespace gonogo::expanders::sinumerik
