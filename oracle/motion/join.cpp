// SPDX-License-Identifier: GPL-3.0-or-later
//
// R1. The joining of motions that go on in one way.
#include <algorithm>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>

#include "oracle/motion/motion.hpp"
#include "oracle/motion/space_circle.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {

using reference::kAllAxes;

namespace {

bool differ(const Number& a, const Number& b) {
  return visible_sign(a - b) != 0;
}

// What is known to an enclosure's width alone is the same where the enclosures are.
bool is_known_alike(const Number& a, const Number& b) {
  const auto is_enclosed = [](const Number& x) { return x.form() == Number::Form::enclosure; };
  if (!is_enclosed(a) && !is_enclosed(b)) return a == b;
  return is_enclosed(a) && is_enclosed(b) && a.bounds(kSignBits) == b.bounds(kSignBits);
}

bool same_terms(const Record& a, const Record& b) {
  if (a.kind != b.kind || a.block != b.block) return false;
  if (a.kind == RecordKind::thread)
    return is_known_alike(a.lead, b.lead) && is_known_alike(a.start, b.start);
  return a.kind == RecordKind::rapid ||
         (is_known_alike(a.feed, b.feed) && a.feed_mode == b.feed_mode);
}

// The one axis that moves, and its direction; nothing when it is not one.
std::optional<std::pair<Axis, int>> single_direction(const Motion& motion) {
  std::optional<std::pair<Axis, int>> found;
  for (Axis axis : kAllAxes) {
    const int sign = visible_sign(motion.to()[axis] - motion.from[axis]);
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
    if (visible_sign(ai) != visible_sign(bi)) return false;
    for (std::size_t j = i + 1; j < reference::kAxes; ++j) {
      const Number aj = a.to().at[j] - a.from.at[j];
      const Number bj = b.to().at[j] - b.from.at[j];
      if (differ(ai * bj, aj * bi)) return false;
    }
  }
  return true;
}

// The same circle, both flat: helices are matched piece by piece instead.
bool same_circle(const Motion& a, const Motion& b) {
  if (a.record.plane != b.record.plane || (a.record.rot < 0) != (b.record.rot < 0)) return false;
  if (differ(a.record.centre[0], b.record.centre[0]) ||
      differ(a.record.centre[1], b.record.centre[1])) {
    return false;
  }
  const reference::PlaneAxes axes = reference::axes_of(a.record.plane);
  for (Axis axis : kAllAxes) {
    if (axis == axes.p || axis == axes.q) continue;
    if (differ(a.from[axis], a.to()[axis]) || differ(b.from[axis], b.to()[axis])) return false;
  }
  const PlaneVector start = from_centre(a.record, a.from);
  const PlaneVector middle = from_centre(a.record, a.to());
  const PlaneVector end = from_centre(a.record, b.to());
  const Number radius_2 = norm_squared(start);
  return !differ(radius_2, norm_squared(middle)) && !differ(radius_2, norm_squared(end)) &&
         visible_sign(radius_2) > 0;
}

// The same circle in space in the same sense, less than a full turn together. Where an enclosure
// enters they stay two: nothing is lost, since each is matched for itself.
bool same_space_circle(const Motion& a, const Motion& b) {
  for (Axis axis : kAllAxes) {
    if (!reference::is_linear(axis) &&
        (differ(a.from[axis], a.to()[axis]) || differ(b.from[axis], b.to()[axis]))) {
      return false;
    }
  }
  const SpacePoint start = space_point(a.from);
  const SpacePoint middle = space_point(a.to());
  const SpacePoint via = space_point(b.record.via);
  const SpacePoint end = space_point(b.to());
  if (!is_rational(start) || !is_rational(space_point(a.record.via)) || !is_rational(middle) ||
      !is_rational(via) || !is_rational(end)) {
    return false;
  }
  const auto circle = circle_through(start, space_point(a.record.via), middle);
  const auto next = circle_through(middle, via, end);
  if (!circle || !next || circle->centre != next->centre || circle->radius_2 != next->radius_2) {
    return false;
  }
  const SpacePoint tilt = cross(circle->normal, next->normal);
  return dot(tilt, tilt).sign() == 0 && dot(circle->normal, next->normal).sign() > 0 &&
         dot(cross(middle - start, end - start), circle->normal).sign() > 0;
}

// The sign and number of turns of two arcs of one circle run through in one go. With the parts of a
// turn f and g in (0, 1], f + g passes a whole turn when the sum's part is no larger than f.
// Nothing: more turns than a record can name.
std::optional<std::int32_t> joined_rot(const Motion& a, const Motion& b) {
  const int sense = a.record.rot < 0 ? -1 : 1;
  const PlaneVector start = from_centre(a.record, a.from);
  const PlaneVector middle = from_centre(a.record, a.to());
  const PlaneVector end = from_centre(a.record, b.to());
  const bool middle_whole = same_direction(start, middle);
  const bool end_whole = same_direction(start, end);
  const bool passes =
      middle_whole || (!end_whole && compare_angles(start, end, middle, sense) <= 0);
  const std::int64_t turns = std::abs(std::int64_t{a.record.rot}) +
                             std::abs(std::int64_t{b.record.rot}) - 1 + (passes ? 1 : 0);
  if (turns > std::numeric_limits<std::int32_t>::max()) return std::nullopt;
  return sense * static_cast<std::int32_t>(turns);
}

}  // namespace

bool join(Motion& motion, const Motion& next) {
  if (!same_terms(motion.record, next.record)) return false;
  if (!std::ranges::equal(motion.to().at, next.from.at, is_known_alike)) return false;
  switch (motion.record.kind) {
    case RecordKind::rapid: {
      const auto a = single_direction(motion);
      if (!a || a != single_direction(next)) return false;
      break;
    }
    case RecordKind::feed:
    case RecordKind::thread:
      if (!same_line(motion, next)) return false;
      break;
    case RecordKind::arc: {
      if (!same_circle(motion, next)) return false;
      const std::optional<std::int32_t> turns = joined_rot(motion, next);
      if (!turns) return false;
      motion.record.rot = *turns;
      break;
    }
    case RecordKind::arc3:
      if (!same_space_circle(motion, next)) return false;
      break;
    default:
      return false;
  }
  motion.record.to = next.record.to;
  motion.behind_first = next.number + next.behind_first - motion.number;
  motion.record.axes = motion.record.axes | next.record.axes;
  return true;
}

}  // namespace gonogo::oracle
