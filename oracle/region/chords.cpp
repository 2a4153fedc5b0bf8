// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/chords.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "oracle/region/arc.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {
namespace {

bool is_line(const LevelMotion& motion) {
  return !motion.is_arc && !(motion.from == motion.to);
}

// A chord of length c of a circle of radius R runs within h of the shorter arc, h <= R, when
// c^2 + 4 h^2 <= 8 R h.
// By enclosures, then exactly. R is a b c / (2 |cross|) of the three sides.
std::optional<bool> near_circle(const IntervalVector& first, const IntervalVector& second,
                                Interval limit) {
  if (scalar_product(first, second).sup() <= 0) return false;
  const Interval a2 = first.squared_length();
  const Interval b2 = second.squared_length();
  const Interval sides = norm(first) * norm(second) * norm(first + second);
  // c^2 + 4 h^2 <= 8 R h, times |cross| / 4.
  const Interval longest = CGAL::max(a2, b2);
  const Interval left = (longest + 4.0 * square(limit)) * abs(determinant(first, second));
  const Interval right = 4.0 * sides * limit;
  if (left.inf() > right.sup()) return false;
  if (left.sup() <= right.inf() && scalar_product(first, second).inf() > 0) return true;
  return std::nullopt;
}

bool near_circle_exactly(const PlanePoint& first, const PlanePoint& second, const Number& limit) {
  if (dot(first, second).sign() <= 0) return false;
  const Number a2 = norm_squared(first);
  const Number b2 = norm_squared(second);
  const Number turn = cross(first, second);
  const Number left = (exact::max(a2, b2) + Number(4) * limit * limit);
  return left * left * turn * turn <=
         Number(16) * a2 * b2 * norm_squared(first + second) * limit * limit;
}

bool make_an_arc(const LevelMotion& first, const LevelMotion& second, const Number& limit,
                 Interval enclosed) {
  if (!(first.to == second.from)) return false;
  const IntervalVector middle = enclose(first.to);
  const auto answer =
      near_circle(middle - enclose(first.from), enclose(second.to) - middle, enclosed);
  if (answer) return *answer;
  return near_circle_exactly(first.to - first.from, second.to - second.from, limit);
}

}  // namespace

std::vector<bool> find_chords(std::span<const LevelMotion> motions, const Number& limit) {
  std::vector<bool> chords(motions.size(), false);
  const Interval enclosed = enclose(limit);
  const LevelMotion* before = nullptr;  // the line before, with nothing that moves between
  std::size_t place = 0;                // of it
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (!is_line(motions[i])) {
      if (motions[i].is_arc) before = nullptr;
      continue;
    }
    if (before != nullptr && make_an_arc(*before, motions[i], limit, enclosed)) {
      chords[place] = true;
      chords[i] = true;
    }
    before = &motions[i];
    place = i;
  }
  return chords;
}

ChordTurning turning_of(std::span<const LevelMotion> motions, const std::vector<bool>& chords,
                        int sense, const Number& shortest) {
  // Angles in doubles: a sum of so many is off by less than this; what is nearer stays undecided.
  constexpr double kMost = kQuarterTurn * std::numbers::pi;
  const double least = enclose(shortest).sup();
  ChordTurning result;
  bool in_row = false;
  bool has_direction = false;
  double x = 0, y = 0;    // where the last counted direction ended
  double dx = 0, dy = 0;  // that direction
  double turned = 0, most = 0;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (!chords[i]) {
      in_row = in_row && !motions[i].is_arc && motions[i].from == motions[i].to;
      continue;
    }
    const IntervalVector from = enclose(motions[i].from);
    const IntervalVector to = enclose(motions[i].to);
    if (!in_row) {
      in_row = true;
      has_direction = false;
      turned = most = 0;
      x = median(from.x());
      y = median(from.y());
    }
    const double nx = median(to.x()) - x;
    const double ny = median(to.y()) - y;
    if (std::hypot(nx, ny) <= least) continue;
    if (has_direction) {
      turned += sense * std::atan2(dx * ny - dy * nx, dx * nx + dy * ny);
      most = std::max(most, turned);
      const double against = most - turned;
      if (against > kMost + kEstimate) return {Turning::against, i};
      if (against > kMost - kEstimate) result.kind = Turning::undecided;
    }
    has_direction = true;
    dx = nx;
    dy = ny;
    x = median(to.x());
    y = median(to.y());
  }
  return result;
}

}  // namespace gonogo::oracle::region
