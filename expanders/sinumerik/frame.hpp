// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "expanders/common/axes.hpp"
#include "expanders/sinumerik/real.hpp"

namespace gonogo::expanders::sinumerik {

/// From the coordinates of the workpiece, in which everything is reckoned, to those of the machine,
/// which are put out: a rotation in a plane about the workpiece zero, then a translation. All that
/// leaves the controller goes through here. 840D has no programmable frames: both are the same.
class Frame {
 public:
  Point to_machine(const Point& workpiece) const;
  Point to_workpiece(const Point& machine) const;
  /// The machine axes that move when `axes` of the workpiece are named.
  Axes to_machine(Axes axes) const;
  /// A place of `plane`, which is the one of the rotation if there is one.
  std::array<Wide, 2> to_machine(const Plane& plane, Wide p, Wide q) const;
  /// Along X, Y, Z.
  using Direction = std::array<Real, 3>;
  /// A place between whole counts.
  Direction place_to_machine(const Direction& workpiece) const;
  Direction place_to_workpiece(const Direction& machine) const;
  Direction direction_to_machine(const Direction& workpiece) const {
    return turned(workpiece, false);
  }
  Direction direction_to_workpiece(const Direction& machine) const { return turned(machine, true); }

  const Point& shift() const { return shift_; }
  /// `rounded`: axes along which it is only nearly what was asked for.
  void shift_to(const Point& place, Axes rounded);
  /// Turns by `degrees` more, in counts, from the first axis of the plane toward the second; they
  /// may be beside by `doubt`, in radians.
  void turn_by(Fixed degrees, int plane, Real doubt);
  void clear_rotation() {
    turn_to(0);
    doubt_ = 0;
  }
  /// What the rotation may be beside, in radians.
  Real doubt() const { return doubt_; }

  bool is_turned() const { return angle_ != 0; }
  /// Whether work in the plane is possible under the rotation in force.
  bool allows(int plane) const { return !is_turned() || plane == plane_; }
  /// Axes along which a place in whole counts does not stay one.
  Axes rounded() const { return shift_rounded_ | (is_exact() ? 0 : turned_axes()); }

  // Faults.
  void turn_as(const Frame& other) { turn_by(other.angle_, other.plane_, other.doubt_); }
  void turn_about_machine_zero() { about_machine_zero_ = true; }
  void turn_the_other_way_in_g18() { flipped_in_g18_ = true; }

 private:
  void turn_to(Fixed degrees);
  bool is_exact() const { return turn_.cosine == 0 || turn_.sine == 0; }
  Axes turned_axes() const;
  Point turned(const Point& point, bool back) const;
  std::array<Wide, 2> turned(Wide p, Wide q, bool back) const;
  Direction turned(const Direction& direction, bool back) const;

  Point shift_{};
  Axes shift_rounded_ = 0;
  int plane_ = 17;
  Fixed angle_ = 0;  // degrees, 0 to below 360
  Real doubt_ = 0;
  Direction2 turn_{1, 0};
  bool about_machine_zero_ = false;
  bool flipped_in_g18_ = false;
};

}  // namespace gonogo::expanders::sinumerik
