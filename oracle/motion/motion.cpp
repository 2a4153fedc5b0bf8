// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

double estimate_length(const PlaneVector& v) {
  return std::hypot(estimate(v.p), estimate(v.q));
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
  const SpacePoint middle = space_point(via);
  const SpacePoint from = space_point(motion.from);
  const SpacePoint to = space_point(motion.to());
  const auto circle = circle_through(from, middle, to);
  const auto is_over_half = [&] { return dot(from - middle, to - middle).sign() > 0; };
  return circle && is_over_half() && circle->radius_2 > tolerance * tolerance;
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

std::optional<Motion> as_arc(const Motion& motion) {
  if (motion.record.kind != RecordKind::arc3) return motion;
  for (reference::Plane plane :
       {reference::Plane::g17, reference::Plane::g18, reference::Plane::g19}) {
    const reference::PlaneAxes axes = reference::axes_of(plane);
    const Number& depth = motion.from[axes.d];
    if (!is_level(motion.record.via[axes.d], depth)) continue;
    if (!is_level(motion.to()[axes.d], depth)) continue;
    const auto from_start = [&](const Position& point) {
      return PlaneVector{point[axes.p] - motion.from[axes.p], point[axes.q] - motion.from[axes.q]};
    };
    const PlaneVector u = from_start(motion.record.via);
    const PlaneVector v = from_start(motion.to());
    const Number across = cross(u, v);
    const int sense = across.sign();
    if (sense == 0) return std::nullopt;
    const Number u_2 = norm_squared(u);
    const Number v_2 = norm_squared(v);
    Motion arc = motion;
    arc.record.kind = RecordKind::arc;
    arc.record.plane = plane;
    arc.record.rot = sense;
    arc.record.centre = {motion.from[axes.p] + (v.q * u_2 - u.q * v_2) / (across * 2),
                         motion.from[axes.q] + (u.p * v_2 - v.p * u_2) / (across * 2)};
    return arc;
  }
  return std::nullopt;
}

}  // namespace gonogo::oracle
