// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a motion stays within a rounded rectangle (a disc) about the middle of the pocket.
#pragma once

#include "oracle/region/rectangle.hpp"

namespace gonogo::oracle::region {

struct Reach {
  enum class Kind { inside, outside, undecided } kind = Kind::inside;
  PlanePoint witness;  // outside: a point of the motion (of a spiral: within 1e-9 of it)
  Number beyond;       // how far it lies outside the limit (of a spiral: at least so far)
};

Reach reach_of(const PlanePoint& point, const RoundedRectangle& limit);
// Exact for round arcs; a spiral that just touches the limit between its ends may stay undecided.
Reach reach_of(const Arc& arc, const RoundedRectangle& limit);

}  // namespace gonogo::oracle::region
