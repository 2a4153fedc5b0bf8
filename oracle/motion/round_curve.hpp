// SPDX-License-Identifier: GPL-3.0-or-later
//
// A round motion of the reference (arc, helix, circle in space) as a curve: which points lie on it,
// and how far along it they lie.
#pragma once

#include <optional>

#include "oracle/motion/open_start.hpp"
#include "oracle/motion/space_circle.hpp"

namespace gonogo::oracle {

// An arc that may begin anywhere on a circle: the reference's motion is only one of those that are
// possible, and their ends and centre follow from the starts that are left.
struct OpenArc {
  const OpenStart* starts = nullptr;  // about `origin`
  PlaneVector origin;                 // along p and q
  Similarity end;                     // the end of the arc, from its start
  Similarity centre;                  // its centre, from its start
  Number radius;                      // of the arc
  Number slack;                       // how far its centre may lie from the motion's
};

// A rational point near a point of any numbers, and how far the two may differ along an axis.
struct RationalPoint {
  explicit RationalPoint(const Position& point);
  SpacePoint at;
  Number error = 0;
};

// Three points of an arc3 and their circle; none where they lie in line.
struct ThreePoints {
  explicit ThreePoints(const Motion& arc3);
  RationalPoint from;
  RationalPoint via;
  RationalPoint to;
  std::optional<SpaceCircle> circle;
  bool exact() const { return (from.error + via.error + to.error).sign() == 0; }
  // Whether the ends are seen from the intermediate point at less than a right angle.
  bool is_over_half() const { return dot(from.at - via.at, to.at - via.at).sign() > 0; }
  // The sweep in turns, in (0, 1); an estimate. REQUIRES: a circle.
  double turns() const;
  // Whether the arc is its own chord within the tolerance: at most half a turn, and its middle no
  // farther from the chord.
  bool is_flat(const Number& tolerance) const;
  // Whether they lie in line within the tolerance, and are no flat arc.
  bool nearly_lie_in_line(const Number& tolerance) const;
};

// SIE-CIP-01: whether a control that rounds the points makes another circle, a line or an alarm of
// them: they lie nearly in line, and not all are decimals that it need not round.
bool hangs_on_rounding(const Motion& motion, const Number& tolerance);
inline constexpr const char* kPointsNearlyInLine =
    "The points of the arc lie in line within the tolerance: rounded, they make another circle, a "
    "line or an alarm.";

class RoundCurve {
 public:
  // `motion` is an arc or an arc3, and outlives the curve.
  RoundCurve(const Motion& motion, const std::optional<OpenArc>& open);
  RoundCurve(const RoundCurve&) = delete;

  // The motion as `arc`: an arc3 too, in a plane parallel to a coordinate plane; null where it is
  // none.
  const Motion* arc() const { return arc_; }
  double whole() const { return whole_; }  // sweep in turns; an estimate
  // Whether its ends are not equally far from its centre, as far as estimates show: then every
  // point between the two radii will do.
  bool is_spiral() const;

  // Whether a point of the circle that the curve runs on, or of the cylinder of a helix, lies in
  // the box round the point.
  bool on_circle(const Position& point, Number tolerance) const;
  // +1: the axes outside the plane agree at this part of the sweep; -1: they do not; 0: too close
  // to the tolerance to say. On demand the linear axes alone.
  int on_helix(const Position& point, double turns, const Number& tolerance,
               bool linear_only = false) const;
  // The same for the distance from the centre, which is linear in the angle where the arc's ends
  // are not equally far from it.
  int on_spiral(const Position& point, double turns, const Number& tolerance) const;
  // The part of a turn from one point to another in the sense of the curve; an estimate.
  double part_of_turn(const Position& from, const Position& to) const;
  // How far the point is from the curve, which is `turns` along it; from a circle in space, from
  // the whole of it. In curve_distance.cpp.
  Number distance(const Position& point, double turns) const;
  // Whether an arc about this normal turns in the sense of the curve.
  bool same_sense(const SpacePoint& normal) const;

 private:
  // Without estimates: false says nothing. In curve_distance.cpp.
  bool is_surely_off_helix(Axis axis, const Position& point, double turns,
                           const Number& tolerance) const;
  bool is_surely_off_spiral(const Position& point, double turns, const Number& tolerance) const;
  // What is linear in the angle from `first` to `last`, where the box round a point is seen.
  struct AtAngle;
  std::optional<AtAngle> at_angle(const Position& point, double turns, const Number& tolerance,
                                  const Number& first, const Number& last) const;
  Number distance_in_space(const Position& point) const;
  bool on_space_circle(const Position& point, const Number& tolerance) const;

  const Motion& motion_;
  const std::optional<OpenArc>& open_;
  std::optional<Motion> flat_;         // an arc3 as arc
  const Motion* arc_ = nullptr;        // the motion or `flat_`
  std::optional<ThreePoints> points_;  // of an arc3 that is no arc
  double whole_ = 0;
  double radius_ = 0;  // at its start
};

}  // namespace gonogo::oracle
