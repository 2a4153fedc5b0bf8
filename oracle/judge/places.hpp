// SPDX-License-Identifier: GPL-3.0-or-later
//
// R2, R3. Whether two places are one, and whether a motion leads nowhere.
#pragma once

#include "oracle/judge/motion.hpp"
#include "oracle/judge/terms.hpp"

namespace gonogo::oracle {

// Whether two points are one place. A motion of exactly the tolerance is none; as the difference of
// two doubles it comes out longer or shorter by their rounding, so that much more is no difference
// for a subject that computes in doubles, on either side.
bool same_place(const Position& a, const Position& b, const JudgeTerms& terms);

// Whether the motion starts and ends at this place, and does not go round in between.
bool stays_at(const Position& place, const Motion& motion, const JudgeTerms& terms);

}  // namespace gonogo::oracle
