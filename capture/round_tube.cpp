// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/round_tube.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonogo::oracle {
namespace {

using reference::kAllAxes;

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kAngleNoise = 1e-12;  // turns

// Signed turns from direction a to direction b.
double turns_between(double ap, double aq, double bp, double bq) {
  return std::atan2(ap * bq - aq * bp, ap * bp + aq * bq) / kTwoPi;
}

bool in_plane(const Motion* arc, reference::Axis axis) {
  if (arc == nullptr) return reference::is_linear(axis);
  const reference::PlaneAxes axes = reference::axes_of(arc->record.plane);
  return axis == axes.p || axis == axes.q;
}

}  // namespace

RoundTube::RoundTube(const Motion& motion) : motion_(motion), curve_(motion_, none_) {
  whole_ = curve_.whole();
  const Motion* arc = curve_.arc();
  if (arc != nullptr) {
    const PlaneVector start = from_centre(arc->record, arc->from);
    const PlaneVector end = from_centre(arc->record, arc->to());
    start_ = {estimate(start.p), estimate(start.q)};
    centre_ = {estimate(arc->record.centre[0]), estimate(arc->record.centre[1])};
    radius_ = std::hypot(start_[0], start_[1]);
    end_radius_ = std::hypot(estimate(end.p), estimate(end.q));
    sense_ = arc->record.rot < 0 ? -1 : 1;
  } else {
    const ThreePoints points(motion_);
    radius_ = end_radius_ = points.circle ? std::sqrt(approximate(points.circle->radius_2)) : 0;
  }
  double along_2 = std::pow(kTwoPi * radius_ * whole_, 2);
  for (reference::Axis axis : reference::kLinearAxes) {
    if (!in_plane(arc, axis))
      along_2 += std::pow(estimate(motion_.to()[axis] - motion_.from[axis]), 2);
  }
  length_ = std::sqrt(along_2);
}

// The extreme angles of what the box of this half width and the circle have in common, seen from
// the direction of the box's middle: they lie on the edges of the box or in its corners.
std::optional<RoundTube::Angles> RoundTube::angles_in_plane(const SamplePoint& sample,
                                                            double half) const {
  const reference::PlaneAxes axes = reference::axes_of(curve_.arc()->record.plane);
  const std::array<double, 2> at = {sample.near[reference::index(axes.p)] - centre_[0],
                                    sample.near[reference::index(axes.q)] - centre_[1]};
  std::optional<Angles> found;
  auto take = [&](double p, double q) {
    const double turns = turns_between(at[0], at[1], p, q) * sense_;
    if (!found) found = Angles{turns, turns};
    found->low = std::min(found->low, turns);
    found->high = std::max(found->high, turns);
  };
  const double least = std::min(radius_, end_radius_);
  const double most = std::max(radius_, end_radius_);
  for (const double side : {-half, half}) {
    for (const double radius : {radius_, end_radius_}) {
      for (const std::size_t i : {0U, 1U}) {
        const double edge = at[i] + side;
        const double rest = radius * radius - edge * edge;
        if (rest < 0) continue;
        for (const double other : {-std::sqrt(rest), std::sqrt(rest)}) {
          if (std::abs(other - at[1 - i]) > half) continue;
          if (i == 0) take(edge, other);
          if (i == 1) take(other, edge);
        }
      }
    }
    for (const double other : {-half, half}) {
      const double distance = std::hypot(at[0] + side, at[1] + other);
      if (distance >= least && distance <= most) take(at[0] + side, at[1] + other);
    }
  }
  // Round the centre there is no order.
  const bool holds_centre = std::abs(at[0]) <= half && std::abs(at[1]) <= half;
  if (found && holds_centre) found = Angles{-0.5, 0.5};
  return found;
}

std::optional<RoundTube::Angles> RoundTube::angles(const SamplePoint& sample,
                                                   const Tube& tube) const {
  if (curve_.arc() == nullptr) return angles_in_space(sample, tube);
  const auto outer = angles_in_plane(sample, tube.half + Tube::kUnsure);
  if (!outer) return std::nullopt;
  const auto inner = angles_in_plane(sample, tube.half - Tube::kUnsure);
  if (inner) return tube.strict ? inner : outer;
  // The border of the box: it touches the circle, if at all, in the middle of what is left open.
  if (!curve_.on_circle(sample.exact, tube.tolerance)) return std::nullopt;
  if (!tube.strict) return outer;
  const double middle = (outer->low + outer->high) / 2;
  return Angles{middle, middle};
}

// A ball within the box for the strict answer, a ball round it for the other.
std::optional<RoundTube::Angles> RoundTube::angles_in_space(const SamplePoint& sample,
                                                            const Tube& tube) const {
  const ThreePoints points(motion_);
  if (!points.circle || radius_ == 0) return std::nullopt;
  if (!curve_.on_circle(sample.exact, tube.tolerance)) return std::nullopt;
  double reach = std::numbers::sqrt3 * tube.half;
  if (tube.strict) {
    const SpacePoint v = RationalPoint(sample.exact).at - points.circle->centre;
    const SpacePoint& n = points.circle->normal;
    const double height = approximate(dot(v, n)) / std::sqrt(approximate(dot(n, n)));
    const double radial =
        std::sqrt(std::max(0.0, approximate(dot(v, v)) - height * height)) - radius_;
    reach = std::sqrt(std::max(0.0, tube.half * tube.half - height * height - radial * radial));
    reach *= 1 - 1e-6;
  }
  const double turns = std::asin(std::min(1.0, reach / radius_)) / kTwoPi;
  return Angles{-turns, turns};
}

double RoundTube::turns_to(const SamplePoint& sample) const {
  if (curve_.arc() == nullptr) return curve_.part_of_turn(motion_.from, sample.exact);
  const reference::PlaneAxes axes = reference::axes_of(curve_.arc()->record.plane);
  const double turns = sense_ * turns_between(start_[0], start_[1],
                                              sample.near[reference::index(axes.p)] - centre_[0],
                                              sample.near[reference::index(axes.q)] - centre_[1]);
  return turns < 0 ? turns + 1 : turns;
}

bool RoundTube::heights(const SamplePoint& sample, const Tube& tube, Span& within) const {
  for (reference::Axis axis : kAllAxes) {
    if (in_plane(curve_.arc(), axis)) continue;
    const Number travel = motion_.to()[axis] - motion_.from[axis];
    if (travel.sign() == 0) {
      if (!agree(sample.exact[axis], motion_.from[axis], tube.tolerance)) return false;
      continue;
    }
    const double height = quick(travel);
    const double at = sample.near[reference::index(axis)] - quick(motion_.from[axis]);
    const double half = tube.sure_half();
    const double one = (at - half) / height * whole_;
    const double other = (at + half) / height * whole_;
    within.low = std::max(within.low, std::min(one, other));
    within.high = std::min(within.high, std::max(one, other));
  }
  return within.low <= within.high;
}

void RoundTube::spans(const SamplePoint& sample, const Tube& tube, std::vector<Span>& out) const {
  Span within{0, whole_};
  if (!heights(sample, tube, within)) return;
  const auto about = angles(sample, tube);
  if (!about) return;
  const double at = turns_to(sample);
  for (double turn = -1; turn <= std::ceil(whole_); ++turn) {
    const Span span{std::max(within.low, at + about->low + turn),
                    std::min(within.high, at + about->high + turn)};
    if (span.low <= span.high + kAngleNoise) {
      out.push_back({std::min(span.low, span.high), span.high});
    }
  }
  if (!out.empty() || whole_ == 0) return;
  // The ends themselves are known exactly.
  if (agree(sample.exact, motion_.from, tube.tolerance)) out.push_back({0, 0});
  if (agree(sample.exact, motion_.to(), tube.tolerance)) out.push_back({whole_, whole_});
}

double RoundTube::off(const SamplePoint& sample) const {
  if (curve_.arc() == nullptr) return 0;
  const reference::PlaneAxes axes = reference::axes_of(curve_.arc()->record.plane);
  return std::abs(std::hypot(sample.near[reference::index(axes.p)] - centre_[0],
                             sample.near[reference::index(axes.q)] - centre_[1]) -
                  radius_);
}

Number RoundTube::deviation(const Position& point) const {
  const Number to_end =
      min(largest_difference(point, motion_.from), largest_difference(point, motion_.to()));
  const Motion* arc = curve_.arc();
  if (arc == nullptr) return to_end;
  const PlaneVector v = from_centre(arc->record, point);
  const PlaneVector a = from_centre(arc->record, arc->from);
  Number off = abs(sqrt(v.p * v.p + v.q * v.q) - sqrt(a.p * a.p + a.q * a.q));
  for (reference::Axis axis : kAllAxes) {
    if (in_plane(arc, axis) || motion_.to()[axis] != motion_.from[axis]) continue;
    off = max(off, abs(point[axis] - motion_.from[axis]));
  }
  Motion part{arc->record, arc->from};
  part.record.rot = sense_;
  part.record.to = point;
  const bool swept = approximate_turns(part) <= whole_;
  return swept ? off : to_end;
}

}  // namespace gonogo::oracle
