// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/frame.hpp"

#include <stdexcept>

#include "oracle/region/arc.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {
namespace {

Number power_of_two(int exponent) {
  return Number::binary(1, exponent);
}

// The multiple of 2^-bits next to the value.
Number rounded(const Number& value, int bits) {
  return (value * power_of_two(bits) + power_of_two(-1)).floor() * power_of_two(-bits);
}

// The smallest multiple of 1e-18 not below the value: a bound that is short to write.
Number short_bound(const Number& value) {
  static const Number scale = Number(1'000'000'000) * Number(1'000'000'000);
  return (value * scale).ceil() / scale;
}

// Bounds of the distance of a rational value from what lies in the bounds.
Number farthest(const Number& value, const std::array<Number, 2>& bounds) {
  return exact::max(exact::abs(value - bounds[0]), exact::abs(value - bounds[1]));
}

Number middle(const std::array<Number, 2>& bounds) {
  return (bounds[0] + bounds[1]) / Number(2);
}

struct Rounded {
  Number value;
  Number error;
};

Rounded rational_near(const Number& value) {
  if (value.is_rational()) return {value, Number()};
  const auto bounds = value.bounds(kRationalBits);
  const Number near = rounded(middle(bounds), kShortBits);
  return {near, farthest(near, bounds)};
}

}  // namespace

PocketFrame make_frame(const PlanePoint& origin, const Number& cos, const Number& sin) {
  PocketFrame frame;
  const Rounded p = rational_near(origin.p);
  const Rounded q = rational_near(origin.q);
  frame.origin = {p.value, q.value};
  frame.shift = short_bound(p.error + q.error);
  if (cos.is_rational() && sin.is_rational() && cos * cos + sin * sin == Number(1)) {
    frame.cos = cos;
    frame.sin = sin;
    return frame;
  }
  // (cos, sin) = ((1 - t^2), 2 t) / (1 + t^2), t = sin / (1 + cos), by the axis on the nearer side.
  const auto c = cos.bounds(kRationalBits);
  const auto s = sin.bounds(kRationalBits);
  const bool left = middle(c).sign() < 0;
  const Number t = rounded(middle(s) / (Number(1) + exact::abs(middle(c))), kShortBits);
  const Number below = Number(1) + t * t;
  frame.cos = (Number(1) - t * t) / below;
  if (left) frame.cos = -frame.cos;
  frame.sin = Number(2) * t / below;
  // A rotation's error moves a point at 1 mm by the distance of the two unit vectors.
  const Number turn = farthest(frame.cos, c) + farthest(frame.sin, s);
  if (turn > power_of_two(-kMiddleBits))
    throw std::domain_error("The cosine and sine are of no angle.");
  frame.turn = short_bound(turn);
  return frame;
}

PlanePoint into(const PocketFrame& frame, const PlanePoint& point) {
  const PlanePoint d = point - frame.origin;
  return {frame.cos * d.p + frame.sin * d.q, frame.cos * d.q - frame.sin * d.p};
}

LevelMotion into(const PocketFrame& frame, const LevelMotion& motion) {
  LevelMotion moved = motion;
  moved.from = into(frame, motion.from);
  moved.to = into(frame, motion.to);
  if (motion.is_arc) moved.centre = into(frame, motion.centre);
  return moved;
}

PlanePoint out_of(const PocketFrame& frame, const PlanePoint& point) {
  return {frame.cos * point.p - frame.sin * point.q + frame.origin.p,
          frame.sin * point.p + frame.cos * point.q + frame.origin.q};
}

Number slack_of(const PocketFrame& frame, const RoundedRectangle& area) {
  return frame.slack(area.core_p + area.core_q + Number(2) * area.radius);
}

}  // namespace gonogo::oracle::region
