// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/round_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "oracle/motion/approximate.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {
namespace {

// How far the nearest and the farthest point of the box round a point are from the centre, squared.
std::pair<Number, Number> distances_of_box(const PlaneVector& point, const Number& tolerance) {
  const Number p = abs(point.p);
  const Number q = abs(point.q);
  const Number near_p = max(p - tolerance, 0);
  const Number near_q = max(q - tolerance, 0);
  const Number far_p = p + tolerance;
  const Number far_q = q + tolerance;
  return {near_p * near_p + near_q * near_q, far_p * far_p + far_q * far_q};
}

}  // namespace

RationalPoint::RationalPoint(const Position& point) : at(space_point(point)) {
  for (Number& each : at) {
    if (each.is_rational()) continue;
    const auto [low, high] = each.bounds(kSpaceBits);
    each = low;
    error = max(error, high - low);
  }
}

ThreePoints::ThreePoints(const Motion& arc3)
    : from(arc3.from),
      via(via_of(arc3)),
      to(arc3.to()),
      circle(circle_through(from.at, via.at, to.at)) {}

double ThreePoints::turns() const {
  const double part = part_of_turn(*circle, from.at, to.at);
  // Near the start the estimate may lie on either side of it.
  if (is_over_half()) return part < kQuarterTurn ? part + 1 : part;
  return part > 1 - kQuarterTurn ? part - 1 : part;
}

// The height s of an arc of radius r over a chord 2 h: h^2 = 2 r s - s^2.
bool ThreePoints::is_flat(const Number& tolerance) const {
  if (is_over_half()) return false;
  const SpacePoint chord = to.at - from.at;
  const Number half_2 = dot(chord, chord) / 4;
  const Number tau_2 = tolerance * tolerance;
  if (half_2 <= tau_2) return true;
  const Number least = half_2 + tau_2;  // of 2 s r
  return circle->radius_2 * tau_2 * 4 >= least * least;
}

// Their height over their longest side is the least; the area decides.
bool ThreePoints::nearly_lie_in_line(const Number& tolerance) const {
  if (!circle) return false;  // known to be in line
  const auto square = [](const SpacePoint& v) { return dot(v, v); };
  const Number longest_2 =
      max(square(to.at - from.at), max(square(via.at - from.at), square(to.at - via.at)));
  const Number tau_2 = tolerance * tolerance;
  // So short a side shows no direction, nor does the arc.
  if (longest_2 <= tau_2 * (kNoDirection * kNoDirection)) return false;
  return square(circle->normal) <= tau_2 * longest_2 && !is_flat(tolerance);
}

bool hangs_on_rounding(const Motion& motion, const Number& tolerance) {
  if (motion.record.kind != RecordKind::arc3) return false;
  const auto is_short = [](const Position& point) {
    return std::ranges::all_of(reference::kLinearAxes, [&](Axis axis) {
      return exact::NumberAccess::node(point[axis]) == nullptr;
    });
  };
  if (is_short(motion.from) && is_short(motion.record.via) && is_short(motion.to())) return false;
  return ThreePoints(motion).nearly_lie_in_line(tolerance);
}

RoundCurve::RoundCurve(const Motion& motion, const std::optional<OpenArc>& open)
    : motion_(motion), open_(open) {
  if (motion.record.kind == RecordKind::arc3) {
    flat_ = as_arc(motion);
    if (flat_) arc_ = &*flat_;
  } else {
    arc_ = &motion;
  }
  if (arc_ != nullptr) {
    radius_ = estimate_length(from_centre(arc_->record, arc_->from));
    whole_ = approximate_turns(*arc_);
    return;
  }
  points_.emplace(motion);
  if (!points_->circle) return;
  radius_ = std::sqrt(approximate(points_->circle->radius_2));
  whole_ = points_->turns();
}

// On a plane: between the radii at the arc's ends, of which there are two where it is none of a
// circle.
bool RoundCurve::on_circle(const Position& point, Number tolerance) const {
  if (arc_ == nullptr) return on_space_circle(point, tolerance);
  const PlaneVector v = from_centre(arc_->record, point);
  const PlaneVector a = from_centre(arc_->record, arc_->from);
  const PlaneVector b = from_centre(arc_->record, arc_->to());
  Number start_2 = norm_squared(a);
  Number end_2 = norm_squared(b);
  if (open_) {
    start_2 = end_2 = open_->radius * open_->radius;
    tolerance += open_->slack;
  }
  const auto [near_2, far_2] = distances_of_box(v, tolerance);
  return (near_2 <= start_2 || near_2 <= end_2) && (far_2 >= start_2 || far_2 >= end_2);
}

bool RoundCurve::is_spiral() const {
  if (arc_ == nullptr || open_) return false;
  const double end = estimate_length(from_centre(arc_->record, arc_->to()));
  return std::abs(end - radius_) > kEstimate;
}

// J-PATH-09. Where the box meets the circles of both radii it meets every one between them,
// exactly. Else the radius is estimated, and a band round the tolerance is left undecided: the
// estimate's own error, and what the radius changes by over a tolerance's length of arc.
int RoundCurve::on_spiral(const Position& point, double turns, const Number& tolerance) const {
  if (arc_ == nullptr || open_) return 1;
  const PlaneVector a = from_centre(arc_->record, arc_->from);
  const PlaneVector b = from_centre(arc_->record, arc_->to());
  const Number start_2 = norm_squared(a);
  const Number end_2 = norm_squared(b);
  const PlaneVector v = from_centre(arc_->record, point);
  const auto [near_2, far_2] = distances_of_box(v, tolerance);
  const bool meets_both =
      near_2 <= start_2 && near_2 <= end_2 && far_2 >= start_2 && far_2 >= end_2;
  if (meets_both) return 1;
  const double within = approximate(tolerance);
  const double change = estimate_length(b) - radius_;
  const double want = radius_ + turns / whole_ * change;
  const double slope = std::abs(change) / (2 * std::numbers::pi * radius_ * whole_);
  const double slack = kEstimate + 2 * slope * within;
  const double p = std::abs(estimate(v.p));
  const double q = std::abs(estimate(v.q));
  const double nearest = std::hypot(std::max(p - within, 0.0), std::max(q - within, 0.0));
  const double farthest = std::hypot(p + within, q + within);
  if (nearest > want + slack || farthest < want - slack) {
    return is_surely_off_spiral(point, turns, tolerance) ? -1 : 0;
  }
  return nearest <= want - slack && farthest >= want + slack ? 1 : 0;
}

// By rationals. Where they stand for other numbers, the circle is off by far less than the slack:
// 2^-512 in the points, times a condition below 2^400 for points that are 2^-40 mm off a line.
bool RoundCurve::on_space_circle(const Position& point, const Number& tolerance) const {
  if (!points_->circle) return false;
  const RationalPoint at(point);
  Number slack = at.error;
  if (!points_->exact()) slack += Number::binary(1, -kRationalBits);
  if (passes_box(*points_->circle, at.at, tolerance - slack)) return true;
  if (slack.sign() == 0 || !passes_box(*points_->circle, at.at, tolerance + slack)) return false;
  throw exact::Undecided("whether a point agrees with the circle hangs on an enclosure's width");
}

// R2. The sweep is estimated, so a band round the tolerance is left undecided: the
// estimate's own error, and the height that the helix gains over a tolerance's length of arc. What
// lies beyond the band is off only where that is certain.
int RoundCurve::on_helix(const Position& point, double turns, const Number& tolerance,
                         bool linear_only) const {
  const double within = approximate(tolerance);
  int answer = 1;
  for (Axis axis : reference::kAllAxes) {
    if (linear_only && !reference::is_linear(axis)) continue;
    if (arc_ == nullptr && reference::is_linear(axis)) continue;
    if (arc_ != nullptr) {
      const reference::PlaneAxes axes = reference::axes_of(arc_->record.plane);
      if (axis == axes.p || axis == axes.q) continue;
    }
    const Number travel = motion_.to()[axis] - motion_.from[axis];
    if (travel.sign() == 0) {
      if (!agree(point[axis], motion_.from[axis], tolerance)) return -1;
      continue;
    }
    const double height = estimate(travel);
    const double slope = std::abs(height) / (2 * std::numbers::pi * radius_ * whole_);
    const double want = estimate(motion_.from[axis]) + turns / whole_ * height;
    const double difference = std::abs(want - estimate(point[axis]));
    if (difference > within + 2 * slope * within + kEstimate) {
      if (arc_ == nullptr || is_surely_off_helix(axis, point, turns, tolerance)) return -1;
      answer = 0;
    }
    if (difference > within - kEstimate) answer = 0;
  }
  return answer;
}

double RoundCurve::part_of_turn(const Position& from, const Position& to) const {
  if (arc_ == nullptr) {
    return oracle::part_of_turn(*points_->circle, RationalPoint(from).at, RationalPoint(to).at);
  }
  Motion part{arc_->record, from};
  part.record.rot = arc_->record.rot < 0 ? -1 : 1;
  part.record.to = to;
  return approximate_turns(part);
}

bool RoundCurve::same_sense(const SpacePoint& normal) const {
  if (arc_ == nullptr) return dot(normal, points_->circle->normal).sign() > 0;
  const auto depth = static_cast<std::size_t>(reference::axes_of(arc_->record.plane).d);
  return normal[depth].sign() * arc_->record.rot > 0;
}

}  // namespace gonogo::oracle
