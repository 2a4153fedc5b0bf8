// SPDX-License-Identifier: GPL-3.0-or-later
//
// What it means to stand still: the one relation by which both sides drop motions.
#pragma once

#include <span>

#include "oracle/judge/motion.hpp"
#include "oracle/judge/terms.hpp"

namespace gonogo::oracle {

// Whether two points are one place. A motion of exactly the tolerance is none; as the difference of
// two doubles it comes out longer or shorter by their rounding, so that much more is no difference
// for a subject that computes in doubles, on either side.
bool same_place(const Position& a, const Position& b, const JudgeTerms& terms);

// Whether the motion starts and ends at this place, and does not go round in between.
bool stays_at(const Position& place, const Motion& motion, const JudgeTerms& terms);

// Whether a motion whose ends agree may be meant as none: all but an arc that goes round, unless it
// is one turn at most on the circle of an arc that the reference dropped there.
bool may_mean_none(const Motion& motion, const Number& tolerance,
                   std::span<const Record> dropped_arcs);

}  // namespace gonogo::oracle
