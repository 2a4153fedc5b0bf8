// SPDX-License-Identifier: GPL-3.0-or-later
//
// The frame of a pocket in the base coordinates of its plane. Where the frame is rational the
// motions come into it exactly; else by a rational rotation near the true one, about a rational
// point near the true centre, and with a certified bound of what that moves.
#pragma once

#include "oracle/region/level.hpp"

namespace gonogo::oracle::region {

struct PocketFrame {
  PlanePoint origin;  // in base coordinates
  Number cos;         // of the angle from the base's first axis to the frame's; rational, on the
  Number sin;         // unit circle
  // How far a point may come to lie from where it truly is: `shift`, and `turn` for each
  // millimetre that it is away from the origin. 0 where the frame is exact.
  Number turn;
  Number shift;

  // For points no farther than `extent` from the origin.
  Number slack(const Number& extent) const { return turn * extent + shift; }
};

// `origin`: the pocket's centre. `cos`, `sin`: of the angle, of any form.
// REQUIRES: cos^2 + sin^2 = 1. Throws std::domain_error when they are too far from that.
PocketFrame make_frame(const PlanePoint& origin, const Number& cos, const Number& sin);

// From base coordinates into the frame, and back.
PlanePoint into(const PocketFrame& frame, const PlanePoint& point);
LevelMotion into(const PocketFrame& frame, const LevelMotion& motion);
PlanePoint out_of(const PocketFrame& frame, const PlanePoint& point);

// The slack of a level whose area is the given one. A motion that leaves the area by more than
// that is outside it, turned or not: the distance from the origin is not changed by turning.
Number slack_of(const PocketFrame& frame, const RoundedRectangle& area);

}  // namespace gonogo::oracle::region
