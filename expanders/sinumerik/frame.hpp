// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/sinumerik/geometry.hpp"

namespace gonogo::expanders::sinumerik {

/// From the coordinates of the workpiece, in which everything is computed, to those of the machine,
/// which are put out: a rotation in a plane about the workpiece zero, then a translation. All that
/// leaves the controller goes through here. 840D has no programmable frames: both are the same.
class Frame {
 public:
  Place to_machine(const Place& workpiece) const;
  Place to_workpiece(const Place& machine) const;
  /// The machine axes that move when `axes` of the workpiece are named.
  Axes to_machine(Axes axes) const;
  Direction to_machine(const Direction& workpiece) const;
  Direction to_workpiece(const Direction& machine) const;

  const Place& shift() const { return shift_; }
  void shift_to(const Place& place) { shift_ = place; }
  /// Turns by `degrees` more, in counts, from the first axis of the plane toward the second.
  void turn_by(Real degrees, int plane);
  void clear_rotation() { angle_ = 0; }

  bool is_turned() const { return angle_ != 0; }
  /// Whether work in the plane is possible under the rotation in force.
  bool allows(int plane) const { return !is_turned() || plane == plane_; }

  // Faults.
  void turn_as(const Frame& other) { turn_by(other.angle_, other.plane_); }
  void turn_about_machine_zero() { about_machine_zero_ = true; }
  void turn_the_other_way_in_g18() { flipped_in_g18_ = true; }

 private:
  Vector turn(bool back) const;
  Place turned(Place place, bool back) const;

  Place shift_{};
  int plane_ = 17;
  Real angle_ = 0;  // degrees, in counts
  bool about_machine_zero_ = false;
  bool flipped_in_g18_ = false;
};

}  // namespace gonogo::expanders::sinumerik
