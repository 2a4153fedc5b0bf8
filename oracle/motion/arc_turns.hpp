// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which turns of an arc record rounding leaves open (J-PATH-06), and arcs that are
// no more than their chords (R3).
#pragma once

#include <array>
#include <vector>

#include "oracle/motion/motion.hpp"
#include "oracle/motion/tolerances.hpp"
#include "oracle/region/level.hpp"

namespace gonogo::oracle {

// How far a number of the arc may lie from its intended value, as its subject declares it; 0: the
// numbers are exact.
Number rounding_of(const Motion& arc, const Tolerances& tolerances);

// The same for arcs in a pocket that lies within `reach` of a centre.
region::OpenTurns open_turns(const std::array<Number, 2>& centre, const Number& reach,
                             const Tolerances& tolerances);

// Whether both ends may lie on one ray from the centre when each number is that far off: then the
// arc's turn, apart from other whole turns, may be meant as nil or as a whole turn.
bool may_be_nil_or_whole(const Motion& arc, const Number& rounding);

// Whether an end may be the centre and so shows no direction.
bool may_end_on_its_centre(const Motion& arc, const Number& rounding);

// Whether all points of an arc lie within the tolerance of its chord in its plane.
bool is_flat_arc(const Motion& arc, const Number& tolerance);
// Whether such an arc makes more than half a turn: its circle is hardly wider than the tolerance.
bool is_narrow_arc(const Motion& arc, const Number& tolerance);
// R3: the same of an arc or a circle in space; rounded, the three points of one may lie in line.
bool agrees_with_chord(const Motion& motion, const Number& tolerance);
// The straight cut between its ends.
Motion chord_of(const Motion& round);
// What is farthest from the chord of an arc that agrees with it, or corners about all of the arc.
std::vector<Position> farthest_of_flat(const Motion& arc, const Number& tolerance);

}  // namespace gonogo::oracle
