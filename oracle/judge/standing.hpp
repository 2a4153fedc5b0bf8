// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-CMP-03. What it means to stand still: the one relation by which both sides drop motions.
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

// Whether the subject, which need not drop what the reference did, may stand at this point: where
// the reference stands, `here`, or at a place that `dropped` has led to. `dropped`: null where
// nothing was.
bool may_stand_at(const Position& point, const Position& here, const Dropped* dropped,
                  const JudgeTerms& terms);

// Whether a motion of the subject may be meant as none: it stays where the reference stands, or
// stood before what it dropped, or leads where one of those motions did. It does not go round,
// unless on the circle of an arc that was dropped, and once.
bool may_mean_none(const Motion& motion, const Position& here, const Dropped* dropped,
                   const JudgeTerms& terms);

}  // namespace gonogo::oracle
