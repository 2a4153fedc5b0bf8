// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/frame.hpp"

#include <cmath>

namespace gonogo::expanders::sinumerik {
namespace {

constexpr Fixed kTurn = 360 * kOne;

// `factor` is a whole number when one of the two is: then no digit is lost.
Fixed combined(Fixed a, double a_factor, Fixed b, double b_factor) {
  if (a_factor == 0) return b * static_cast<Fixed>(b_factor);
  if (b_factor == 0) return a * static_cast<Fixed>(a_factor);
  return std::llround(static_cast<double>(a) * a_factor + static_cast<double>(b) * b_factor);
}

Point sum(Point a, const Point& b, Fixed sign) {
  for (std::size_t axis = 0; axis < a.size(); ++axis) a[axis] += sign * b[axis];
  return a;
}

}  // namespace

// SIE-FRM-02: about the shifted zero.
Point Frame::to_machine(const Point& workpiece) const {
  if (about_machine_zero_) return turned(sum(workpiece, shift_, 1), false);
  return sum(turned(workpiece, false), shift_, 1);
}

Point Frame::to_workpiece(const Point& machine) const {
  if (about_machine_zero_) return sum(turned(machine, true), shift_, -1);
  return turned(sum(machine, shift_, -1), true);
}

Axes Frame::to_machine(Axes axes) const {
  return is_turned() && (axes & turned_axes()) != 0 ? axes | turned_axes() : axes;
}

std::array<double, 3> Frame::direction_to_machine(const std::array<double, 3>& workpiece) const {
  return turned(workpiece, false);
}

std::array<double, 3> Frame::direction_to_workpiece(const std::array<double, 3>& machine) const {
  return turned(machine, true);
}

void Frame::shift_to(const Point& place, Axes rounded) {
  shift_ = place;
  shift_rounded_ = rounded;
}

void Frame::turn_by(Fixed degrees, int plane) {
  plane_ = plane;
  const bool flipped = flipped_in_g18_ && plane == 18;
  turn_to(angle_ + (flipped ? -degrees : degrees) % kTurn);
}

void Frame::turn_to(Fixed degrees) {
  angle_ = (degrees % kTurn + kTurn) % kTurn;
  turn_ = direction_of(static_cast<double>(angle_) / static_cast<double>(kOne));
}

Axes Frame::turned_axes() const {
  const Plane& plane = plane_of(plane_);
  return axis_bit(plane.p) | axis_bit(plane.q);
}

Point Frame::turned(const Point& point, bool back) const {
  if (!is_turned()) return point;
  const Plane& plane = plane_of(plane_);
  const double sine = back ? -turn_.sine : turn_.sine;
  Point result = point;
  result[plane.p] = combined(point[plane.p], turn_.cosine, point[plane.q], -sine);
  result[plane.q] = combined(point[plane.p], sine, point[plane.q], turn_.cosine);
  return result;
}

std::array<double, 3> Frame::turned(const std::array<double, 3>& direction, bool back) const {
  const Plane& plane = plane_of(plane_);
  const double sine = back ? -turn_.sine : turn_.sine;
  std::array<double, 3> result = direction;
  result[plane.p] = direction[plane.p] * turn_.cosine - direction[plane.q] * sine;
  result[plane.q] = direction[plane.p] * sine + direction[plane.q] * turn_.cosine;
  return result;
}

}  // namespace gonogo::expanders::sinumerik
