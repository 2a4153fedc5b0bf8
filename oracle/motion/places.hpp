// SPDX-License-Identifier: GPL-3.0-or-later
//
// R2, R3. Whether two places are one, and whether a motion is negligible.
#pragma once

#include "oracle/motion/motion.hpp"
#include "oracle/motion/tolerances.hpp"

namespace gonogo::oracle {

// Whether two points are one place. A motion of exactly the tolerance is none. As the difference of
// two doubles it comes out longer or shorter by their rounding: for a subject that computes in
// doubles that much is no difference, on either side.
bool same_place(const Position& a, const Position& b, const Tolerances& tolerances);

// Whether the motion starts and ends at this place, and does not go round in between.
bool stays_at(const Position& place, const Motion& motion, const Tolerances& tolerances);

}  // namespace gonogo::oracle
