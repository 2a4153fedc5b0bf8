// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/sinumerik/machine.hpp"

namespace gonogo::expanders::sinumerik {

/// One arc of a plane on its way from the block to the plan. Places are counted from its start.
struct Arc {
  const Plane& plane;
  bool counterclockwise = false;
  Target target{};
  Feed feed{};
  Vector chord{};   ///< none where the end is the start
  Vector centre{};  ///< none: not yet
  int rounds = 1;   ///< how often it goes round, the last of them in part
};

/// The target and the chord to it, whole where they are within rounding.
void take_end(const Machine& machine, const Target& target, Arc& arc);

/// The centre that lies `side` half chords to the left of the middle of the chord. All circles
/// through start and end are of this form.
Vector on_bisector(const Vector& chord, Real side);
/// The side of the centre for a radius: of the two the one not to the right. A radius below half
/// the chord gives the middle.
Real side_of_radius(const Vector& chord, Real radius);

/// I J K, with an end point or for a full circle.
void take_centre(Machine& machine, const Block& block, Arc& arc);
/// I J K with AR: the end is computed.
void take_centre_and_angle(Machine& machine, const Block& block, Real angle, Arc& arc);
/// AP and RP: the pole is the centre.
void take_pole_circle(Machine& machine, const Block& block, Arc& arc);

/// The direction at the end of the arc: the radius there, turned by a quarter in the sense of the
/// arc; the third axis moves in proportion to the angle.
Direction heading_of(const Machine& machine, const Arc& arc);
/// Plans the arc, with `rot` as the tracer takes it and this heading at its end. Complains when the
/// centre is out of reach.
void plan_arc(Machine& machine, const Arc& arc, int rot, const Direction& heading, Plan& plan);

}  // namespace gonogo::expanders::sinumerik
