// SPDX-License-Identifier: GPL-3.0-or-later
//
// R9: motions of a level whose numbers come as enclosures. Rational numbers near them are judged,
// and the level's slack says how far those may be off: only that much is left open.
#pragma once

#include "oracle/motion/motion.hpp"

namespace gonogo::oracle {

region::PlanePoint plane_point_near(const Position& at, const reference::PlaneAxes& axes);
region::LevelMotion level_motion_near(const Motion& motion, const reference::PlaneAxes& axes);

// How far a point of that motion may lie from its true place, mm; 0: the motion has no enclosure in
// the plane.
Number slack_of_enclosures(const Motion& motion, const reference::PlaneAxes& axes);

}  // namespace gonogo::oracle
