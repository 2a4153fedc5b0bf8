// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions in the plane of a pocket, and how far places are from them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace gonogo::mutations {

using Point = std::array<double, 2>;

struct FlatMotion {
  Point from{};
  Point to{};
  bool is_round = false;
  Point centre{};
  double radius = 0;
  double start = 0;
  double sweep = 0;

  Point at(double part) const {
    if (!is_round) {
      return {from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part};
    }
    const double angle = start + sweep * part;
    return {centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)};
  }
};

inline double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

// From a point to the nearest place of a motion.
inline double distance_to(const Point& at, const FlatMotion& motion) {
  if (!motion.is_round) {
    const double along_p = motion.to[0] - motion.from[0];
    const double along_q = motion.to[1] - motion.from[1];
    const double square = along_p * along_p + along_q * along_q;
    double part = 0;
    if (square > 0) {
      part = ((at[0] - motion.from[0]) * along_p + (at[1] - motion.from[1]) * along_q) / square;
    }
    return distance(at, motion.at(std::clamp(part, 0.0, 1.0)));
  }
  constexpr double kTurn = 2 * std::numbers::pi;
  const double ends = std::min(distance(at, motion.from), distance(at, motion.to));
  const double angle = std::atan2(at[1] - motion.centre[1], at[0] - motion.centre[0]);
  double turn = (motion.sweep < 0 ? -1 : 1) * (angle - motion.start);
  turn -= kTurn * std::floor(turn / kTurn);
  if (turn > std::abs(motion.sweep)) return ends;
  return std::min(ends, std::abs(distance(at, motion.centre) - motion.radius));
}

}  // namespace gonogo::mutations
