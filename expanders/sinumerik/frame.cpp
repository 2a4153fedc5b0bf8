// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/frame.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

Place sum(Place a, const Place& b, Real sign) {
  for (std::size_t axis = 0; axis < a.size(); ++axis) a[axis] += sign * b[axis];
  return a;
}

Direction in_plane(Direction direction, const Plane& plane, const Vector& turn) {
  const Vector result = turned({direction[plane.p], direction[plane.q]}, turn);
  direction[plane.p] = result.p;
  direction[plane.q] = result.q;
  return direction;
}

}  // namespace

// SIE-FRM-02: about the shifted zero.
Place Frame::to_machine(const Place& workpiece) const {
  if (about_machine_zero_) return turned(sum(workpiece, shift_, 1), false);
  return sum(turned(workpiece, false), shift_, 1);
}

Place Frame::to_workpiece(const Place& machine) const {
  if (about_machine_zero_) return sum(turned(machine, true), shift_, -1);
  return turned(sum(machine, shift_, -1), true);
}

Axes Frame::to_machine(Axes axes) const {
  const Plane& plane = plane_of(plane_);
  const Axes both = axis_bit(plane.p) | axis_bit(plane.q);
  return is_turned() && (axes & both) != 0 ? axes | both : axes;
}

Direction Frame::to_machine(const Direction& workpiece) const {
  return in_plane(workpiece, plane_of(plane_), turn(false));
}

Direction Frame::to_workpiece(const Direction& machine) const {
  return in_plane(machine, plane_of(plane_), turn(true));
}

void Frame::turn_by(Real degrees, int plane) {
  plane_ = plane;
  const bool flipped = flipped_in_g18_ && plane == 18;
  angle_ = std::fmod(angle_ + (flipped ? -degrees : degrees), Real{kFullTurn});
}

Vector Frame::turn(bool back) const {
  return direction_of((back ? -angle_ : angle_) / kOne);
}

Place Frame::turned(Place place, bool back) const {
  if (!is_turned()) return place;
  const Plane& plane = plane_of(plane_);
  const Vector result = sinumerik::turned({place[plane.p], place[plane.q]}, turn(back));
  place[plane.p] = result.p;
  place[plane.q] = result.q;
  return place;
}

}  // namespace gonogo::expanders::sinumerik
