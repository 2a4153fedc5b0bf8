// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a motion keeps clear of the material of a round part: outside a circle about the axis
// (a bolt), or inside it (a bore). Decided in the plane; the axis is the origin.
#pragma once

#include "oracle/region/level.hpp"

namespace gonogo::oracle {

struct Keep {
  bool outside = true;   // of the circle; else inside
  exact::Number radius;  // the limit
  exact::Number slack;   // how far beyond the limit agrees with it

  exact::Number bound() const { return outside ? radius - slack : radius + slack; }
};

struct Clearance {
  enum class Kind { clear, touches, undecided } kind = Kind::clear;
  region::PlanePoint witness;  // touches: a point of the motion that is beyond the limit
  exact::Number deviation;     // touches: how far it is beyond the limit
};

Clearance clearance_of_line(const region::PlanePoint& from, const region::PlanePoint& to,
                            const Keep& keep);
// The whole box that two corners span: the path inside is not known.
Clearance clearance_of_box(const region::PlanePoint& from, const region::PlanePoint& to,
                           const Keep& keep);
// Halves within certified enclosures; `undecided` where that does not end. The witness of an arc
// lies within 1e-9 of it. The part of the sweep before `from`, in [0, 1), does not count.
Clearance clearance_of_arc(const region::LevelMotion& arc, const Keep& keep,
                           const exact::Number& from = exact::Number(0));

}  // namespace gonogo::oracle
