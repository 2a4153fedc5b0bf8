// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether a motion stays within a disc about the middle of the pocket.
#pragma once

#include "oracle/region/arc.hpp"

namespace gonogo::oracle::region {

struct Reach {
  enum class Kind { inside, outside, undecided } kind = Kind::inside;
  PlanePoint witness;  // outside: a point of the motion (of a spiral: within 1e-9 of it)
  Number beyond;       // how far it lies outside the limit (of a spiral: at least so far)
};

// Whether a point lies at most `limit` from the origin.
Reach reach_of_point(const PlanePoint& point, const Number& limit);
// Whether all of the arc does. Exact for round arcs; a spiral that just touches the limit between
// its ends may stay undecided.
Reach reach_of_arc(const Arc& arc, const Number& limit);

}  // namespace gonogo::oracle::region
