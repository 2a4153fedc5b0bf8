// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "oracle/motion/approximate.hpp"
#include "oracle/motion/space_circle.hpp"
#include "oracle/region/constants.hpp"
#include "reference/exact/enclosure.hpp"
#include "reference/exact/interval.hpp"

namespace gonogo::oracle {

using reference::kAllAxes;

Motion motion_from(const Position& from, const Record& record, std::size_t number) {
  Motion motion{record, from, number};
  for (Axis axis : kAllAxes) {
    if (!record.axes.has(axis)) motion.record.to[axis] = from[axis];
  }
  return motion;
}

namespace {

// Two numbers that are small and the same; false where that takes more than a look.
bool is_same(const Number& a, const Number& b) {
  using exact::NumberAccess;
  return NumberAccess::node(a) == nullptr && NumberAccess::node(b) == nullptr &&
         NumberAccess::millionths(a) == NumberAccess::millionths(b);
}

template <std::size_t size>
bool is_same(const std::array<Number, size>& a, const std::array<Number, size>& b) {
  for (std::size_t i = 0; i < size; ++i) {
    if (!is_same(a[i], b[i])) return false;
  }
  return true;
}

}  // namespace

bool is_same_motion(const Motion& got, const Motion& want) {
  const Record& a = got.record;
  const Record& b = want.record;
  if (a.kind != b.kind || a.block != b.block) return false;
  if (!is_same(a.to.at, b.to.at) || !is_same(got.from.at, want.from.at)) return false;
  if (a.kind == RecordKind::rapid) return true;
  if (!is_same(a.feed, b.feed) || a.feed_mode != b.feed_mode) return false;
  if (a.kind == RecordKind::feed) return true;
  return a.kind == RecordKind::arc && a.plane == b.plane && a.rot == b.rot &&
         is_same(a.centre, b.centre);
}

bool is_same_point(const Position& a, const Position& b) {
  return is_same(a.at, b.at);
}

bool tells_end(const Motion& motion, Axis axis) {
  return is_linear(axis) && motion.record.axes.has(axis) &&
         !is_same(motion.from[axis], motion.to()[axis]);
}

std::size_t coordinates_in(const Motion& motion) {
  const auto ends = std::ranges::count_if(reference::kLinearAxes,
                                          [&](Axis axis) { return tells_end(motion, axis); });
  return static_cast<std::size_t>(ends) + (motion.record.kind == RecordKind::arc ? 2 : 0);
}

void shift(Position& position, const Position& by) {
  for (Axis axis : kAllAxes) position[axis] += by[axis];
}

namespace {

// Whether |a - b| <= tolerance, by the bounds that an enclosure has already, which decide nearly
// always: their difference is made no expression for it.
std::optional<bool> agree_within_bounds(const Number& a, const Number& b, const Number& tolerance) {
  using exact::interval_of;
  constexpr mpfr_prec_t kBits = exact::kBaseBits;
  const exact::Interval apart = subtract(interval_of(a, kBits), interval_of(b, kBits), kBits);
  const exact::Interval most = interval_of(tolerance, kBits);
  const int above = compare(apart, most);
  const int below = compare(apart, negate(most, kBits));
  if (above == 1 || below == -1) return false;
  if (above == -1 && below == 1) return true;
  return std::nullopt;
}

}  // namespace

bool agree(const Number& a, const Number& b, const Number& tolerance) {
  using exact::NumberAccess;
  std::int64_t apart = 0;
  const bool small = NumberAccess::node(a) == nullptr && NumberAccess::node(b) == nullptr &&
                     NumberAccess::node(tolerance) == nullptr;
  if (small &&
      !__builtin_sub_overflow(NumberAccess::millionths(a), NumberAccess::millionths(b), &apart)) {
    const std::int64_t most = NumberAccess::millionths(tolerance);
    return apart <= most && apart >= -most;
  }
  if (a.form() == Number::Form::enclosure || b.form() == Number::Form::enclosure) {
    if (const auto answer = agree_within_bounds(a, b, tolerance)) return *answer;
  }
  const Number difference = a - b;
  if (difference.form() == Number::Form::enclosure) {
    const auto [low, high] = difference.bounds(kEstimateBits);
    if (low > tolerance || high < -tolerance) return false;
    if (high <= tolerance && low >= -tolerance) return true;
  }
  // Not by abs(): the sign of a difference that is zero cannot be decided for enclosures.
  return difference <= tolerance && -difference <= tolerance;
}

bool agree(const Position& a, const Position& b, const Number& tolerance) {
  for (Axis axis : kAllAxes) {
    if (!agree(a[axis], b[axis], tolerance)) return false;
  }
  return true;
}

AxisSet moved_axes(const Motion& motion, const Number& tolerance) {
  AxisSet moved;
  for (Axis axis : kAllAxes) {
    const bool moves = tolerance.sign() == 0
                           ? visible_sign(motion.to()[axis] - motion.from[axis]) != 0
                           : !agree(motion.from[axis], motion.to()[axis], tolerance);
    if (moves) moved.add(axis);
  }
  return moved;
}

PlaneVector from_centre(const Record& arc, const Position& point) {
  const reference::PlaneAxes axes = reference::axes_of(arc.plane);
  return {point[axes.p] - arc.centre[0], point[axes.q] - arc.centre[1]};
}

int visible_sign(const Number& value) {
  if (value.form() != Number::Form::enclosure) return value.sign();
  const auto [low, high] = value.bounds(kSignBits);
  return low.sign() > 0 ? 1 : high.sign() < 0 ? -1 : 0;
}

namespace {

bool differ(const Number& a, const Number& b) {
  return visible_sign(a - b) != 0;
}

}  // namespace

// Two that are equal as far as can be seen are as large as each other: a centre whose coordinates
// changed places differs by the same on both axes, and no precision distinguishes these.
Number largest_difference(const Position& a, const Position& b) {
  Number largest = 0;
  for (Axis axis : reference::kLinearAxes) {
    const Number difference = a[axis] - b[axis];
    if (visible_sign(difference - largest) > 0) largest = difference;
    if (visible_sign(-difference - largest) > 0) largest = -difference;
  }
  return largest;
}

namespace {

// Vectors of [0, 180) degrees from the origin come before those of [180, 360).
struct TurnedVector {
  Number along;   // times the origin's length
  Number across;  // positive on the side to which the arc turns
  bool second_half() const {
    const int side = visible_sign(across);
    return side < 0 || (side == 0 && visible_sign(along) < 0);
  }
};

TurnedVector turned(const PlaneVector& origin, const PlaneVector& v, int sense) {
  Number across = cross(origin, v);
  return {dot(origin, v), sense < 0 ? -across : across};
}

}  // namespace

int compare_angles(const PlaneVector& origin, const PlaneVector& a, const PlaneVector& b,
                   int sense) {
  const TurnedVector ta = turned(origin, a, sense);
  const TurnedVector tb = turned(origin, b, sense);
  if (ta.second_half() != tb.second_half()) return ta.second_half() ? 1 : -1;
  return -visible_sign(ta.along * tb.across - ta.across * tb.along);
}

bool same_direction(const PlaneVector& a, const PlaneVector& b) {
  return visible_sign(cross(a, b)) == 0 && visible_sign(dot(a, b)) > 0;
}

bool makes_full_turn(const Motion& motion) {
  if (motion.record.kind != RecordKind::arc) return false;
  if (std::abs(motion.record.rot) > 1) return true;
  const reference::PlaneAxes axes = reference::axes_of(motion.record.plane);
  return motion.from[axes.p] == motion.to()[axes.p] && motion.from[axes.q] == motion.to()[axes.q];
}

// Without the text that `approximate` rounds.
double estimate(const Number& value) {
  switch (value.form()) {
    case Number::Form::rational:
      if (exact::NumberAccess::node(value) == nullptr) return approximate(value);
      return exact::rational_of(value).get_d();
    case Number::Form::root:
      return mpfr_get_d(
          exact::interval_of(exact::root_of(value), mpfr_prec_t{2} * kEstimateBits).low(),
          MPFR_RNDN);
    case Number::Form::enclosure:
      break;
  }
  // By the bounds that it has already: any more digits would evaluate it anew.
  return exact::rational_of(value.bounds(kEstimateBits)[0]).get_d();
}

Number two_units_of_double(double size) {
  int exponent = 0;
  std::frexp(size, &exponent);
  return Number::binary(1, exponent - kUlpBits);
}

namespace {

double part_of_turn(double across, double along) {
  const double part = std::atan2(across, along) / (2 * std::numbers::pi);
  return part < 0 ? part + 1.0 : part;
}

// The sweep of one turn, where that is far from a whole one.
std::optional<double> estimated_part(const PlaneVector& a, const PlaneVector& b, int sense) {
  const std::array<double, 2> from = {estimate(a.p), estimate(a.q)};
  const std::array<double, 2> to = {estimate(b.p), estimate(b.q)};
  const double along = from[0] * to[0] + from[1] * to[1];
  const double across = sense * (from[0] * to[1] - from[1] * to[0]);
  if (!(along < 0 || std::abs(across) > 2 * kShort * along)) return std::nullopt;
  return part_of_turn(across, along);
}

// Near a whole turn no estimate says whether the end lies before the start or behind it.
double decided_part(const PlaneVector& a, const PlaneVector& b, int sense) {
  const TurnedVector t = turned(a, b, sense);
  const double along = estimate(t.along);
  const double across = estimate(t.across);
  const bool near_whole = along >= 0 && std::abs(across) <= kShort * along;
  if (!near_whole) return part_of_turn(across, along);
  const double beside = part_of_turn(std::abs(across), along);
  return visible_sign(t.across) > 0 ? beside : 1.0 - beside;
}

}  // namespace

double approximate_turns(const Motion& arc) {
  const PlaneVector a = from_centre(arc.record, arc.from);
  const PlaneVector b = from_centre(arc.record, arc.to());
  const int sense = arc.record.rot < 0 ? -1 : 1;
  const std::optional<double> part = estimated_part(a, b, sense);
  return (part ? *part : decided_part(a, b, sense)) +
         static_cast<double>(std::abs(arc.record.rot) - 1);
}

bool nearly_full_turn(const Motion& motion) {
  return motion.record.kind == RecordKind::arc && approximate_turns(motion) > 0.5;
}

bool goes_round(const Motion& motion, const Number& tolerance) {
  if (motion.record.kind != RecordKind::arc3) return nearly_full_turn(motion);
  const Position via = via_of(motion);
  if (!agree(via, motion.from, tolerance) && !agree(via, motion.to(), tolerance)) return true;
  // Three points near each other: the small way, unless they lie nearly in line and the middle one
  // not in the middle.
  const auto circle =
      circle_through(space_point(motion.from), space_point(via), space_point(motion.to()));
  return circle && is_over_half(motion) && circle->radius_2 > tolerance * tolerance;
}

Motion straightened(Motion motion) {
  if (motion.record.kind != RecordKind::arc3) return motion;
  const SpacePoint from = space_point(motion.from);
  const SpacePoint via = space_point(motion.record.via);
  const SpacePoint to = space_point(motion.to());
  const bool between = dot(via - from, to - via).sign() >= 0;
  if (between && !circle_through(from, via, to)) motion.record.kind = RecordKind::feed;
  return motion;
}

namespace {

// Two enclosures that overlap are left to the circle in space, which fits either way.
bool is_level(const Number& height, const Number& depth) {
  try {
    return height == depth;
  } catch (const exact::Undecided&) {
    return false;
  }
}

}  // namespace

std::optional<Motion> as_arc(const Motion& arc3) {
  for (reference::Plane plane :
       {reference::Plane::g17, reference::Plane::g18, reference::Plane::g19}) {
    const reference::PlaneAxes axes = reference::axes_of(plane);
    const Number& depth = arc3.from[axes.d];
    if (!is_level(arc3.record.via[axes.d], depth) || !is_level(arc3.to()[axes.d], depth)) continue;
    const auto from_start = [&](const Position& point) {
      return PlaneVector{point[axes.p] - arc3.from[axes.p], point[axes.q] - arc3.from[axes.q]};
    };
    const PlaneVector u = from_start(arc3.record.via);
    const PlaneVector v = from_start(arc3.to());
    const Number across = cross(u, v);
    const int sense = across.sign();
    if (sense == 0) return std::nullopt;
    const Number u_2 = norm_squared(u);
    const Number v_2 = norm_squared(v);
    Motion arc = arc3;
    arc.record.kind = RecordKind::arc;
    arc.record.plane = plane;
    arc.record.rot = sense;
    arc.record.centre = {arc3.from[axes.p] + (v.q * u_2 - u.q * v_2) / (across * 2),
                         arc3.from[axes.q] + (u.p * v_2 - v.p * u_2) / (across * 2)};
    return arc;
  }
  return std::nullopt;
}

namespace {

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
