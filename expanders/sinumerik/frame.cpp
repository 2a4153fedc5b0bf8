// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/frame.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// `factor` is a whole number when one of the two is: then no digit is lost.
Wide combined(Wide a, Real a_factor, Wide b, Real b_factor) {
  if (a_factor == 0) return b * static_cast<Fixed>(b_factor);
  if (b_factor == 0) return a * static_cast<Fixed>(a_factor);
  return to_whole(static_cast<Real>(a) * a_factor + static_cast<Real>(b) * b_factor);
}

template <typename Place>
Place sum(Place a, const Point& b, Fixed sign) {
  using Number = typename Place::value_type;
  for (std::size_t axis = 0; axis < a.size(); ++axis)
    a[axis] += static_cast<Number>(sign * b[axis]);
  return a;
}

}  // namespace

// SIE-FRM-02: about the shifted zero.
Point Frame::to_machine(const Point& workpiece) const {
  if (about_machine_zero_) return turned(sum(workpiece, shift_, 1), false);
  return sum(turned(workpiece, false), shift_, 1);
}

std::array<Wide, 2> Frame::to_machine(const Plane& plane, Wide p, Wide q) const {
  const Fixed shift_p = shift_[plane.p];
  const Fixed shift_q = shift_[plane.q];
  if (about_machine_zero_) return turned(p + shift_p, q + shift_q, false);
  const auto [turned_p, turned_q] = turned(p, q, false);
  return {turned_p + shift_p, turned_q + shift_q};
}

Frame::Direction Frame::place_to_machine(const Direction& workpiece) const {
  if (about_machine_zero_) return turned(sum(workpiece, shift_, 1), false);
  return sum(turned(workpiece, false), shift_, 1);
}

Frame::Direction Frame::place_to_workpiece(const Direction& machine) const {
  if (about_machine_zero_) return sum(turned(machine, true), shift_, -1);
  return turned(sum(machine, shift_, -1), true);
}

Point Frame::to_workpiece(const Point& machine) const {
  if (about_machine_zero_) return sum(turned(machine, true), shift_, -1);
  return turned(sum(machine, shift_, -1), true);
}

Axes Frame::to_machine(Axes axes) const {
  return is_turned() && (axes & turned_axes()) != 0 ? axes | turned_axes() : axes;
}

void Frame::shift_to(const Point& place, Axes rounded) {
  shift_ = place;
  shift_rounded_ = rounded;
}

void Frame::turn_by(Fixed degrees, int plane, Real doubt) {
  plane_ = plane;
  doubt_ += doubt;
  const bool flipped = flipped_in_g18_ && plane == 18;
  turn_to(angle_ + (flipped ? -degrees : degrees) % kFullTurn);
}

void Frame::turn_to(Fixed degrees) {
  angle_ = (degrees % kFullTurn + kFullTurn) % kFullTurn;
  turn_ = direction_of(static_cast<Real>(angle_) / kOne);
}

Axes Frame::turned_axes() const {
  const Plane& plane = plane_of(plane_);
  return axis_bit(plane.p) | axis_bit(plane.q);
}

std::array<Wide, 2> Frame::turned(Wide p, Wide q, bool back) const {
  const Real sine = back ? -turn_.sine : turn_.sine;
  return {combined(p, turn_.cosine, q, -sine), combined(p, sine, q, turn_.cosine)};
}

Point Frame::turned(const Point& point, bool back) const {
  if (!is_turned()) return point;
  const Plane& plane = plane_of(plane_);
  const auto [p, q] = turned(point[plane.p], point[plane.q], back);
  Point result = point;
  result[plane.p] = static_cast<Fixed>(p);
  result[plane.q] = static_cast<Fixed>(q);
  return result;
}

Frame::Direction Frame::turned(const Direction& direction, bool back) const {
  const Plane& plane = plane_of(plane_);
  const Real sine = back ? -turn_.sine : turn_.sine;
  Direction result = direction;
  result[plane.p] = direction[plane.p] * turn_.cosine - direction[plane.q] * sine;
  result[plane.q] = direction[plane.p] * sine + direction[plane.q] * turn_.cosine;
  return result;
}

}  // namespace gonogo::expanders::sinumerik
