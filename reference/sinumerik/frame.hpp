// SPDX-License-Identifier: GPL-3.0-or-later
//
// The frame between workpiece and base coordinates: base = translation(rotation(workpiece)).
#pragma once

#include "reference/geometry/kernel.hpp"
#include "reference/record.hpp"

namespace gonogo::reference::sinumerik {

class Frame {
 public:
  // Whether a rotation other than by whole turns is in force, and its plane.
  bool is_rotated() const { return angle_.sign() != 0; }
  Plane plane() const { return plane_; }
  // Cosine and sine of the rotation as it is seen in a plane: 1 and 0 in one that is not turned.
  std::array<Number, 2> direction_in(Plane plane) const;

  void clear();
  void set_translation(const Position& by) {
    translation_ = by;
    is_translated_ = true;
  }
  const Position& translation() const { return translation_; }
  // A translation in the coordinates of the frame, added to the one in force.
  void translate(const Position& by);
  // Degrees from the first axis of the plane toward the second.
  void set_rotation(Plane plane, const Number& degrees);
  const Number& angle() const { return angle_; }
  // Whether a translation was set; it may be by nothing.
  bool is_translated() const { return is_translated_; }
  bool is_in_force() const { return is_translated() || is_rotated(); }

  Position to_base(const Position& workpiece) const;
  Position to_workpiece(const Position& base) const;
  // A way, not a place.
  Position turned(const Position& way) const;
  Position turned_back(const Position& way) const;
  // The record of a motion to `end`, a place of the workpiece, in base coordinates.
  // REQUIRES: an arc lies in the plane of the rotation, or nothing is rotated.
  Record to_base(Record record, const Position& end) const;

 private:
  Position translation_;
  bool is_translated_ = false;
  Plane plane_ = Plane::g17;
  Number angle_;                                             // degrees, 0 <= angle < 360
  geometry::Aff_transformation_2 rotation_{CGAL::IDENTITY};  // in that plane
};

}  // namespace gonogo::reference::sinumerik
