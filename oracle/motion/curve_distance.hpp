// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a place is from where a motion may lead, for the evidence of a departure, mm. Along the
// linear axis where it is farthest, as the tolerance is meant; from a circle, along its radius.
#pragma once

#include "oracle/motion/motion.hpp"

namespace gonogo::oracle {

// From the box between two points.
Number distance_from_box(const Position& from, const Position& to, const Position& point);
// From the line between two points.
Number distance_from_line(const Position& from, const Position& to, const Position& point);

}  // namespace gonogo::oracle
