// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/motion.hpp"

#include <cmath>
#include <numbers>

#include "oracle/approximate.hpp"

namespace gonogo::oracle {

using reference::kAllAxes;

Motion motion_from(const Position& from, const Record& record, std::size_t number) {
  Motion motion{record, from, number};
  for (Axis axis : kAllAxes) {
    if (!record.axes.has(axis)) motion.record.to[axis] = from[axis];
  }
  return motion;
}

void shift(Position& position, const Position& by) {
  for (Axis axis : kAllAxes) position[axis] += by[axis];
}

bool agree(const Number& a, const Number& b, const Number& tolerance) {
  // Not by abs(): the sign of a difference that is zero cannot be decided for enclosures.
  const Number difference = a - b;
  return difference <= tolerance && -difference <= tolerance;
}

bool agree(const Position& a, const Position& b, const Number& tolerance) {
  for (Axis axis : kAllAxes) {
    if (!agree(a[axis], b[axis], tolerance)) return false;
  }
  return true;
}

Number largest_difference(const Position& a, const Position& b) {
  Number largest = 0;
  for (Axis axis : kAllAxes) {
    const Number difference = a[axis] - b[axis];
    if (difference > largest) largest = difference;
    if (-difference > largest) largest = -difference;
  }
  return largest;
}

AxisSet moved_axes(const Motion& motion, const Number& tolerance) {
  AxisSet moved;
  for (Axis axis : kAllAxes) {
    if (!agree(motion.from[axis], motion.to()[axis], tolerance)) moved.add(axis);
  }
  return moved;
}

PlaneVector from_centre(const Record& arc, const Position& point) {
  const reference::PlaneAxes axes = reference::axes_of(arc.plane);
  return {point[axes.p] - arc.centre[0], point[axes.q] - arc.centre[1]};
}

namespace {

// Vectors of [0, 180) degrees from the origin come before those of [180, 360).
struct TurnedVector {
  Number along;   // times the origin's length
  Number across;  // positive on the side to which the arc turns
  bool second_half() const { return across.sign() < 0 || (across.sign() == 0 && along.sign() < 0); }
};

TurnedVector turned(const PlaneVector& origin, const PlaneVector& v, int sense) {
  Number across = origin.p * v.q - origin.q * v.p;
  return {origin.p * v.p + origin.q * v.q, sense < 0 ? -across : across};
}

}  // namespace

int compare_angles(const PlaneVector& origin, const PlaneVector& a, const PlaneVector& b,
                   int sense) {
  const TurnedVector ta = turned(origin, a, sense);
  const TurnedVector tb = turned(origin, b, sense);
  if (ta.second_half() != tb.second_half()) return ta.second_half() ? 1 : -1;
  return -(ta.along * tb.across - ta.across * tb.along).sign();
}

bool same_direction(const PlaneVector& a, const PlaneVector& b) {
  return (a.p * b.q - a.q * b.p).sign() == 0 && (a.p * b.p + a.q * b.q).sign() > 0;
}

bool makes_full_turn(const Motion& motion) {
  if (motion.record.kind != RecordKind::arc) return false;
  if (std::abs(motion.record.rot) > 1) return true;
  const reference::PlaneAxes axes = reference::axes_of(motion.record.plane);
  return motion.from[axes.p] == motion.to()[axes.p] && motion.from[axes.q] == motion.to()[axes.q];
}

double approximate_turns(const Motion& arc) {
  const PlaneVector a = from_centre(arc.record, arc.from);
  const PlaneVector b = from_centre(arc.record, arc.to());
  const int sense = arc.record.rot < 0 ? -1 : 1;
  const TurnedVector t = turned(a, b, sense);
  const double along = approximate(t.along);
  const double across = approximate(t.across);
  // Far from a whole turn nothing has to be decided, which enclosures of equal values could not be;
  // near it their equality is looked at first, which shows for one and the same expression.
  constexpr double kNear = 1e-6;
  const bool near_whole = along >= 0 && std::abs(across) <= kNear * along;
  const bool whole = near_whole && ((a.p == b.p && a.q == b.q) || t.across.sign() == 0);
  double fraction = whole ? 1.0 : std::atan2(across, along) / (2 * std::numbers::pi);
  if (fraction < 0) fraction += 1.0;
  return fraction + static_cast<double>(std::abs(arc.record.rot) - 1);
}

bool nearly_full_turn(const Motion& motion) {
  return motion.record.kind == RecordKind::arc && approximate_turns(motion) > 0.5;
}

namespace {

bool same_terms(const Record& a, const Record& b) {
  return a.kind == b.kind && a.block == b.block &&
         (a.kind == RecordKind::rapid || (a.feed == b.feed && a.feed_mode == b.feed_mode));
}

// The one axis that moves, and its direction; nothing when it is not one.
std::optional<std::pair<Axis, int>> single_direction(const Motion& motion) {
  std::optional<std::pair<Axis, int>> found;
  for (Axis axis : kAllAxes) {
    const int sign = (motion.to()[axis] - motion.from[axis]).sign();
    if (sign == 0) continue;
    if (found) return std::nullopt;
    found = {axis, sign};
  }
  return found;
}

bool same_line(const Motion& a, const Motion& b) {
  for (std::size_t i = 0; i < reference::kAxes; ++i) {
    const Number ai = a.to().at[i] - a.from.at[i];
    const Number bi = b.to().at[i] - b.from.at[i];
    if (ai.sign() != bi.sign()) return false;
    for (std::size_t j = i + 1; j < reference::kAxes; ++j) {
      const Number aj = a.to().at[j] - a.from.at[j];
      const Number bj = b.to().at[j] - b.from.at[j];
      if (ai * bj != aj * bi) return false;
    }
  }
  return true;
}

// The same circle, both flat: helices are matched piece by piece instead.
bool same_circle(const Motion& a, const Motion& b) {
  if (a.record.plane != b.record.plane || (a.record.rot < 0) != (b.record.rot < 0)) return false;
  if (a.record.centre != b.record.centre) return false;
  const reference::PlaneAxes axes = reference::axes_of(a.record.plane);
  for (Axis axis : kAllAxes) {
    if (axis == axes.p || axis == axes.q) continue;
    if (a.from[axis] != a.to()[axis] || b.from[axis] != b.to()[axis]) return false;
  }
  const PlaneVector start = from_centre(a.record, a.from);
  const PlaneVector middle = from_centre(a.record, a.to());
  const PlaneVector end = from_centre(a.record, b.to());
  const Number radius_2 = start.p * start.p + start.q * start.q;
  return radius_2 == middle.p * middle.p + middle.q * middle.q &&
         radius_2 == end.p * end.p + end.q * end.q && radius_2.sign() > 0;
}

// The sign and number of turns of two arcs of one circle run through in one go. With the parts of a
// turn f and g in (0, 1], f + g passes a whole turn when the sum's part is no larger than f.
std::int32_t joined_rot(const Motion& a, const Motion& b) {
  const int sense = a.record.rot < 0 ? -1 : 1;
  const PlaneVector start = from_centre(a.record, a.from);
  const PlaneVector middle = from_centre(a.record, a.to());
  const PlaneVector end = from_centre(a.record, b.to());
  const bool middle_whole = same_direction(start, middle);
  const bool end_whole = same_direction(start, end);
  const bool passes =
      middle_whole || (!end_whole && compare_angles(start, end, middle, sense) <= 0);
  const std::int32_t turns = std::abs(a.record.rot) + std::abs(b.record.rot) - 1 + (passes ? 1 : 0);
  return sense * turns;
}

}  // namespace

bool join(Motion& motion, const Motion& next) {
  if (!same_terms(motion.record, next.record) || motion.to() != next.from) return false;
  switch (motion.record.kind) {
    case RecordKind::rapid: {
      const auto a = single_direction(motion);
      if (!a || a != single_direction(next)) return false;
      break;
    }
    case RecordKind::feed:
      if (!same_line(motion, next)) return false;
      break;
    case RecordKind::arc:
      if (!same_circle(motion, next)) return false;
      motion.record.rot = joined_rot(motion, next);
      break;
    default:
      return false;
  }
  motion.record.to = next.record.to;
  motion.record.axes = motion.record.axes | next.record.axes;
  return true;
}

}  // namespace gonogo::oracle
