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
  double radius = 0;  // at the start; linear in the angle
  double end_radius = 0;
  double start = 0;
  double sweep = 0;

  Point at(double part) const {
    if (!is_round) {
      return {from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part};
    }
    const double angle = start + sweep * part;
    const double here = radius + (end_radius - radius) * part;
    return {centre[0] + here * std::cos(angle), centre[1] + here * std::sin(angle)};
  }
};

inline double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

// A lower bound of the distance from a spiral: by places, less what may be between two of them.
inline double distance_to_spiral(const Point& at, const FlatMotion& motion) {
  constexpr int kPlaces = 64;
  double least = distance(at, motion.to);
  for (int i = 0; i < kPlaces; ++i) {
    least = std::min(least, distance(at, motion.at(static_cast<double>(i) / kPlaces)));
  }
  const double way = std::abs(motion.sweep) * std::max(motion.radius, motion.end_radius) +
                     std::abs(motion.end_radius - motion.radius);
  return std::max(0.0, least - way / (2 * kPlaces));
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
  constexpr double kSameRadius = 1e-6;
  if (std::abs(motion.end_radius - motion.radius) > kSameRadius) {
    return distance_to_spiral(at, motion);
  }
  constexpr double kTurn = 2 * std::numbers::pi;
  const double ends = std::min(distance(at, motion.from), distance(at, motion.to));
  const double angle = std::atan2(at[1] - motion.centre[1], at[0] - motion.centre[0]);
  double turn = (motion.sweep < 0 ? -1 : 1) * (angle - motion.start);
  turn -= kTurn * std::floor(turn / kTurn);
  if (turn > std::abs(motion.sweep)) return ends;
  return std::min(ends, std::abs(distance(at, motion.centre) - motion.radius));
}

// Whether more than twelve turns are made on one ring (J-CYC-02 grants ten).
inline bool turns_over_and_over(const std::vector<FlatMotion>& all, double margin) {
  constexpr double kMostTurns = 12;
  for (const FlatMotion& ring : all) {
    if (!ring.is_round) continue;
    double sweep = 0;
    for (const FlatMotion& other : all) {
      const bool same = other.is_round && distance(ring.centre, other.centre) <= margin &&
                        std::abs(ring.radius - other.radius) <= margin &&
                        std::abs(ring.end_radius - other.end_radius) <= margin;
      if (same) sweep += std::abs(other.sweep);
    }
    if (sweep > kMostTurns * 2 * std::numbers::pi) return true;
  }
  return false;
}

}  // namespace gonogo::mutations
