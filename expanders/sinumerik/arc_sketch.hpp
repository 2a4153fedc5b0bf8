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
  Chord chord;                ///< from start to end
  bool rounded = false;       ///< start or end is only nearly what was asked for
  Vector centre;              ///< from the start
  bool exact_centre = false;  ///< `centre` is in whole counts
};

/// Chord and `rounded`, from the target.
void take_end(const State& state, ArcSketch& sketch);

/// Takes the centre, counted from the start. Complains when it is out of reach.
void put_centre(Machine& machine, const Vector& from_start, ArcSketch& sketch);

/// I J K, with an end point or for a full circle.
void take_centre(Machine& machine, const Block& block, ArcSketch& sketch);
/// I J K with AR, in degrees: the end is reckoned.
void take_centre_and_angle(Machine& machine, const Block& block, double angle, ArcSketch& sketch);
/// AP and RP: the pole is the centre.
void take_pole_circle(Machine& machine, const Block& block, ArcSketch& sketch);

/// The direction at the end of the arc.
Heading heading_of(const Machine& machine, const ArcSketch& sketch);

}  // namespace gonogo::expanders::sinumerik
