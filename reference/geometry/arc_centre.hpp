// SPDX-License-Identifier: GPL-3.0-or-later
//
// The centre of an arc in its plane, from its radius or from the offsets I J K. Pure geometry: what
// a dialect makes of a fault is the dialect's.
#pragma once

#include <optional>
#include <string>

#include "reference/geometry/kernel.hpp"

namespace gonogo::reference {

using geometry::Point_2;
using geometry::Vector_2;

// The address of the centre's offset along an axis: I with X, J with Y, K with Z.
constexpr char offset_address(Axis axis) {
  return "IJK"[index(axis)];
}

// The start, the end and the chord of an arc in its plane. Squares here are of micrometres: those
// of 1e-6 mm are then numbers of 64 bits.
struct ArcEnds {
  Point_2 start;
  Point_2 end;
  Vector_2 chord;
  Number chord_2;  // squared, um^2

  ArcEnds(const PlaneAxes& axes, const Position& from, const Position& to);
  // Seen from the start, which is then the origin.
  explicit ArcEnds(const Vector_2& chord);
  bool closed() const { return chord.x().sign() == 0 && chord.y().sign() == 0; }
  Point_2 middle() const { return CGAL::midpoint(start, end); }
  // Whether the chord is no longer than this, mm.
  bool chord_within(const Number& length) const;
};

// The centre from R: on the right of the chord for a short clockwise arc (`sense` -1); a negative R
// asks for the long one. Nothing when twice the radius is less than the chord.
// REQUIRES: !ends.closed().
std::optional<Point_2> centre_from_radius(const ArcEnds& ends, const Number& radius, int sense);

// The centre off the middle of the chord where the circle of this radius (squared, um^2) runs
// through both ends: `side` +1 is right of the chord, -1 left. Nothing when twice the radius is
// less than the chord. REQUIRES: !ends.closed().
std::optional<Point_2> centre_off_middle(const ArcEnds& ends, const Number& radius_2, int side);

// The centre at an offset from the start, and the squares of the radii at start and end.
struct OffsetCentre {
  Point_2 centre;
  Vector_2 to_start;  // from the centre, um
  Vector_2 to_end;
  Number start_2;  // um^2
  Number end_2;

  OffsetCentre(const ArcEnds& ends, const Vector_2& offset);
  bool begins_at_centre() const { return start_2.sign() == 0; }
  bool ends_at_centre() const { return end_2.sign() == 0; }
  // Start, end and centre are one point.
  bool is_point() const { return begins_at_centre() && ends_at_centre(); }
  // Whether the radii differ by no more than `limit`, mm; than the root of `limit_2`, mm^2; than
  // this part of the larger one, 0 to 1.
  bool radii_agree(const Number& limit) const;
  bool radii_agree_squared(const Number& limit_2) const;
  bool radii_agree_in_part(const Number& part) const;
  // The same of the radius at the start, any part.
  bool radii_agree_in_part_of_start(const Number& part) const;
  // Whether a radius is less than `length`, mm.
  bool radius_below(const Number& length) const;
};

// The sentences of alarms. On a lathe X is given as the radius that it is here.
std::string radius_too_small(const ArcEnds& ends, const Number& radius);
std::string radii_apart(const OffsetCentre& arc, const PlaneAxes& axes, bool on_lathe);

}  // namespace gonogo::reference
