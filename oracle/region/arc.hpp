// SPDX-License-Identifier: GPL-3.0-or-later
//
// One arc of a level, read counterclockwise about the middle of the pocket: exact, with enclosures
// beside it. Directions are vectors; no angle is ever computed.
#pragma once

#include <array>
#include <optional>

#include "oracle/region/interval.hpp"
#include "oracle/region/level.hpp"

namespace gonogo::oracle::region {

// The counterclockwise turn from the direction a to the direction b, in (0, 360] degrees.
struct Sweep {
  PlanePoint a;
  PlanePoint b;
  bool wide = false;  // more than 180 degrees
};

Sweep make_sweep(const PlanePoint& a, const PlanePoint& b);
// Whether the direction lies in the closed sweep.
bool contains(const Sweep& sweep, const PlanePoint& direction);

struct Arc {
  PlanePoint centre;
  Sweep sweep;  // its a and b are the ends, seen from the centre; their lengths are the radii
  Number a2;    // the squared radii at the ends
  Number b2;
  int turns = 0;       // whole turns besides the sweep
  bool round = false;  // both radii equal
  bool full = false;   // a whole circle (round only)
  std::size_t record = 0;
  // A line of the path begins or ends at the arc's end: its band holds the disc about it.
  bool capped_a = false;
  bool capped_b = false;

  IntervalVector c;
  IntervalVector ua;  // unit directions of the ends
  IntervalVector ub;
  Interval ra;  // radii
  Interval rb;

  PlanePoint end_a() const { return centre + sweep.a; }
  PlanePoint end_b() const { return centre + sweep.b; }
};

// The whole turns that come before the turn to the end. REQUIRES: rot != 0.
inline int whole_turns(int rot) {
  return rot > 0 ? rot - 1 : -(rot + 1);
}

// REQUIRES: motion.is_arc, rot != 0, neither end on the centre. `middle` becomes the origin.
Arc make_arc(const LevelMotion& motion, const PlanePoint& middle);
// One arc for two round ones on the same circle, the second beginning where the first ends.
std::optional<Arc> joined(const Arc& first, const Arc& second, bool counterclockwise);

// At most 90 degrees of a circle, counterclockwise from the unit direction ua to ub.
struct CirclePiece {
  IntervalVector c;
  Interval r;
  IntervalVector ua;
  IntervalVector ub;
};

// A part of an arc whose radius runs linearly with the angle; halved without computing an angle.
struct Stretch {
  IntervalVector ua;
  IntervalVector ub;
  Interval ra;
  Interval rb;
  int turns = 0;
  bool wide = false;

  // The ends, seen from the centre.
  IntervalVector a() const { return ra * ua; }
  IntervalVector b() const { return rb * ub; }
  bool is_at_most_quarter() const {
    return turns == 0 && !wide && scalar_product(ua, ub).inf() >= 0;
  }
  // Not to be halved any more.
  bool is_tiny() const;
  // All circles between its radii, about the centre. REQUIRES: at most a quarter.
  CirclePiece circles(const IntervalVector& centre) const { return {centre, hull(ra, rb), ua, ub}; }
};

Stretch whole(const Arc& arc);
std::array<Stretch, 2> halves(const Stretch& stretch);
// Its middle, seen from the centre.
inline IntervalVector middle_of(const Stretch& stretch) {
  return halves(stretch)[0].b();
}
// The direction in the middle of a sweep.
IntervalVector middle_direction(const IntervalVector& ua, const IntervalVector& ub, bool wide);

// <u, d> for the unit vectors u from ua counterclockwise to ub. REQUIRES: at most 90 degrees.
Interval projection(const IntervalVector& ua, const IntervalVector& ub, const IntervalVector& d);
// The squared distance of the piece from a point from which its centre is seen at d.
Interval squared_distance(const CirclePiece& piece, const IntervalVector& d);
// The upright box that the piece lies in.
IntervalVector box_of(const CirclePiece& piece);

}  // namespace gonogo::oracle::region
