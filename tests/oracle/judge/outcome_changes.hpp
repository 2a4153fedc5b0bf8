// SPDX-License-Identifier: GPL-3.0-or-later
//
// Other records for the same motion: in pieces, joined, rounded, with negligible motions.
#pragma once

#include "tests/oracle/judge/generated_outcomes.hpp"

namespace gonogo::oracle {

// Lines, traverses and threads at fractions of them, arcs and helices at angles: their points are
// written with six decimals. No piece stays within `least` of where it starts;
// arcs stay whole whose ends nearly agree, except whole circles where `least` is 0.
Outcome split(const Outcome& outcome, const Position& start, const Number& least,
              generate::Choices& choices);
// Consecutive motions that go on in the same way become one.
Outcome joined(const Outcome& outcome, const Position& start);
// Every end, centre and intermediate point as a multiple of the resolution; of an arc whose ends
// become the same, the turns that it makes.
Outcome rounded(const Outcome& outcome, const Position& start, const Number& resolution);
// Traverses and cuts to where the subject stands, and dwells of no time.
Outcome with_nothing_added(const Outcome& outcome, const Position& start,
                           generate::Choices& choices);
// Any line numbers.
Outcome renumbered(const Outcome& outcome, generate::Choices& choices);

}  // namespace gonogo::oracle
