// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/sinumerik/circles.hpp"
#include "expanders/sinumerik/plan.hpp"

namespace gonogo::expanders::sinumerik {

/// One arc on its way from the block to the plan.
struct ArcSketch {
  ArcSketch(const Plane& its_plane, bool turns_counterclockwise, bool has_end_word)
      : plane(its_plane), counterclockwise(turns_counterclockwise), to_plane_axis(has_end_word) {}

  const Plane& plane;
  bool counterclockwise;
  bool to_plane_axis;  ///< the block has a word of the plane's axes
  Arc arc;
  Chord chord;                ///< from start to end, in whole counts
  bool rounded = false;       ///< `chord` is only nearly what was asked for
  bool known = true;          ///< `way` is right to far less than a count
  Real farthest = 0;          ///< coordinate of start and end in the plane
  Vector way;                 ///< the chord with what rounding took from its ends
  Vector centre;              ///< from the start, as `way`
  bool exact_centre = false;  ///< `centre` is in whole counts
  Real centre_doubt = 0;      ///< what `centre` may be beside, from what the ends may be
  bool unclear = false;       ///< whether the arc is allowed hangs on rounding

  /// What start and end may be beside.
  Real doubt() const { return known ? 0 : coarse_rounding(farthest); }
};

/// Chord, way and `rounded`, from the target.
void take_end(const State& state, ArcSketch& sketch);

/// What the centre of a circle of this radius may be beside, for `side` as in on_bisector, where
/// ends or radius may be `beside`: they turn the bisector, and near half a circle move the centre
/// far along it.
Real doubt_on_bisector(const ArcSketch& sketch, Real side, Real beside, Real radius);

/// No centre is farther, in counts: below 2^126.
inline constexpr Real kFarthest = 8e37L;

/// Takes the centre, counted from the start. Complains when it is out of reach.
void put_centre(Machine& machine, const Vector& from_start, ArcSketch& sketch);

/// I J K, with an end point or for a full circle.
void take_centre(Machine& machine, const Block& block, ArcSketch& sketch);
/// I J K with AR: the end is reckoned.
void take_centre_and_angle(Machine& machine, const Block& block, Fixed angle, ArcSketch& sketch);
/// AP and RP: the pole is the centre.
void take_pole_circle(Machine& machine, const Block& block, ArcSketch& sketch);

/// The direction at the end of the arc, which goes round `turns` times, the last of them in part.
Heading heading_of(const Machine& machine, const ArcSketch& sketch, int turns);

}  // namespace gonogo::expanders::sinumerik
