// SPDX-License-Identifier: GPL-3.0-or-later
//
// A round motion of the reference (arc, helix, circle in space) as a curve: which points lie on it,
// and how far along it they lie.
#pragma once

#include <optional>

#include "oracle/judge/space_circle.hpp"
#include "oracle/judge/turned_start.hpp"

namespace gonogo::oracle {

// An arc that may begin anywhere on a circle: then the reference's motion is only one of those that
// are meant, and its ends and centre follow from the starts that are left.
struct OpenArc {
  const TurnedStart* starts = nullptr;  // about `origin`
  PlaneVector origin;                   // along p and q
  Similarity end;                       // the end of the arc, from its start
  Similarity centre;                    // its centre, from its start
  Number radius;                        // of the arc
  Number slack;                         // how far its centre may lie from the motion's
};

// Rationals near a point of any numbers, and how far it may lie from them along an axis.
struct RationalPoint {
  explicit RationalPoint(const Position& point);
  SpacePoint at;
  Number error = 0;
};

inline RationalPoint::RationalPoint(const Position& point) : at(space_point(point)) {
  constexpr int kBits = 512;
  for (Number& each : at) {
    if (each.is_rational()) continue;
    const auto [low, high] = each.bounds(kBits);
    each = low;
    error = max(error, high - low);
  }
}

// Three points of an arc3 and their circle; none where they lie in line.
struct ThreePoints {
  explicit ThreePoints(const Motion& arc3);
  RationalPoint from;
  RationalPoint via;
  RationalPoint to;
  std::optional<SpaceCircle> circle;
  bool exact() const { return (from.error + via.error + to.error).sign() == 0; }
  bool is_over_half() const { return dot(from.at - via.at, to.at - via.at).sign() > 0; }
  // The sweep in turns, in (0, 1); an estimate. REQUIRES: a circle.
  double turns() const;
  // Whether the arc is its own chord within the tolerance: at most half a turn, and its middle no
  // farther from the chord.
  bool is_flat(const Number& tolerance) const;
};

inline ThreePoints::ThreePoints(const Motion& arc3)
    : from(arc3.from),
      via(via_of(arc3)),
      to(arc3.to()),
      circle(circle_through(from.at, via.at, to.at)) {}

inline double ThreePoints::turns() const {
  const double part = part_of_turn(*circle, from.at, to.at);
  // Near the start the estimate may lie on either side of it.
  if (is_over_half()) return part < 0.25 ? part + 1 : part;
  return part > 0.75 ? part - 1 : part;
}

// The height s of an arc of radius r over a chord 2 h: h^2 = 2 r s - s^2.
inline bool ThreePoints::is_flat(const Number& tolerance) const {
  if (is_over_half()) return false;
  const SpacePoint chord = to.at - from.at;
  const Number half_2 = dot(chord, chord) / 4;
  const Number tau_2 = tolerance * tolerance;
  if (half_2 <= tau_2) return true;
  const Number least = half_2 + tau_2;  // of 2 s r
  return circle->radius_2 * tau_2 * 4 >= least * least;
}

class RoundCurve {
 public:
  // `motion` is an arc or an arc3, and outlives the curve.
  RoundCurve(const Motion& motion, const std::optional<OpenArc>& open);
  RoundCurve(const RoundCurve&) = delete;

  // The motion as `arc`: an arc3 too, in a plane parallel to a coordinate plane; null where it is
  // none.
  const Motion* arc() const { return arc_; }
  double whole() const { return whole_; }  // sweep in turns; an estimate

  // Whether a point of the circle that the curve runs on, or of the cylinder of a helix, lies in
  // the box round the point.
  bool on_circle(const Position& point, Number tolerance) const;
  // +1: the axes outside the plane agree at this part of the sweep; -1: they do not; 0: too close
  // to the tolerance to say. The linear ones alone on demand.
  int on_helix(const Position& point, double turns, const Number& tolerance,
               bool linear_only = false) const;
  // The part of a turn from one point to another in the sense of the curve; an estimate.
  double part_of_turn(const Position& from, const Position& to) const;
  // Whether an arc about this normal turns in the sense of the curve.
  bool same_sense(const SpacePoint& normal) const;

 private:
  bool on_space_circle(const Position& point, const Number& tolerance) const;

  const Motion& motion_;
  const std::optional<OpenArc>& open_;
  std::optional<Motion> flat_;         // an arc3 as arc
  const Motion* arc_ = nullptr;        // the motion or `flat_`
  std::optional<ThreePoints> points_;  // of an arc3 that is no arc
  double whole_ = 0;
  double radius_ = 0;  // at its start
};

inline RoundCurve::RoundCurve(const Motion& motion, const std::optional<OpenArc>& open)
    : motion_(motion), open_(open) {
  if (motion.record.kind == RecordKind::arc3) {
    flat_ = as_arc(motion);
    if (flat_) arc_ = &*flat_;
  } else {
    arc_ = &motion;
  }
  if (arc_ != nullptr) {
    const PlaneVector start = from_centre(arc_->record, arc_->from);
    radius_ = std::hypot(estimate(start.p), estimate(start.q));
    whole_ = approximate_turns(*arc_);
    return;
  }
  points_.emplace(motion);
  if (!points_->circle) return;
  radius_ = std::sqrt(approximate(points_->circle->radius_2));
  whole_ = points_->turns();
}

// On a plane: the box's nearest and farthest distances from the centre enclose the radius, of which
// there are two where the arc is none of a circle.
inline bool RoundCurve::on_circle(const Position& point, Number tolerance) const {
  if (arc_ == nullptr) return on_space_circle(point, tolerance);
  const PlaneVector v = from_centre(arc_->record, point);
  const PlaneVector a = from_centre(arc_->record, arc_->from);
  const PlaneVector b = from_centre(arc_->record, arc_->to());
  Number start_2 = a.p * a.p + a.q * a.q;
  Number end_2 = b.p * b.p + b.q * b.q;
  if (open_) {
    start_2 = end_2 = open_->radius * open_->radius;
    tolerance += open_->slack;
  }
  const Number p = abs(v.p);
  const Number q = abs(v.q);
  const Number near_p = max(p - tolerance, 0);
  const Number near_q = max(q - tolerance, 0);
  const Number far_p = p + tolerance;
  const Number far_q = q + tolerance;
  const Number near_2 = near_p * near_p + near_q * near_q;
  const Number far_2 = far_p * far_p + far_q * far_q;
  // Not by min() and max(), which enclosures of one radius could not decide.
  return (near_2 <= start_2 || near_2 <= end_2) && (far_2 >= start_2 || far_2 >= end_2);
}

// By rationals. Where they stand for other numbers, the circle is off by far less than the slack:
// 2^-512 in the points, times a condition below 2^400 for points that are 2^-40 mm off a line.
inline bool RoundCurve::on_space_circle(const Position& point, const Number& tolerance) const {
  if (!points_->circle) return false;
  const RationalPoint at(point);
  Number slack = at.error;
  if (!points_->exact()) slack += Number::binary(1, -80);
  if (passes_box(*points_->circle, at.at, tolerance - slack)) return true;
  if (slack.sign() == 0 || !passes_box(*points_->circle, at.at, tolerance + slack)) return false;
  throw exact::Undecided("whether a point agrees with the circle hangs on an enclosure's width");
}

// The sweep is estimated, so a band round the tolerance is left undecided: the estimate's own
// error, and the height that the helix gains over a tolerance's length of arc.
inline int RoundCurve::on_helix(const Position& point, double turns, const Number& tolerance,
                                bool linear_only) const {
  constexpr double kEstimate = 1e-7;  // mm
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
    if (difference > within + 2 * slope * within + kEstimate) return -1;
    if (difference > within - kEstimate) answer = 0;
  }
  return answer;
}

inline double RoundCurve::part_of_turn(const Position& from, const Position& to) const {
  if (arc_ == nullptr) {
    return oracle::part_of_turn(*points_->circle, RationalPoint(from).at, RationalPoint(to).at);
  }
  Motion part{arc_->record, from};
  part.record.rot = arc_->record.rot < 0 ? -1 : 1;
  part.record.to = to;
  return approximate_turns(part);
}

inline bool RoundCurve::same_sense(const SpacePoint& normal) const {
  if (arc_ == nullptr) return dot(normal, points_->circle->normal).sign() > 0;
  const auto depth = static_cast<std::size_t>(reference::axes_of(arc_->record.plane).d);
  return normal[depth].sign() * arc_->record.rot > 0;
}

}  // namespace gonogo::oracle
