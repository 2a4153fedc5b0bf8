// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight cuts that stand for a curve that is not known beforehand: one straight line in pieces,
// or chords of one arc.
#pragma once

#include <span>

#include "oracle/motion/motion.hpp"

namespace gonogo::oracle {

// Whether the points follow one another along the line from the first to the last: none farther
// from it than the tolerance, none back by more.
bool lie_along_a_line(std::span<const PlaneVector> points, const Number& tolerance);

// Whether the points are the ends of chords of one arc of at most a turn: each agrees with its
// circle within `tolerance`, each chord goes on round it the same way, and no sagitta is above
// `granted`. Three points or more.
bool are_chords_of_an_arc(std::span<const PlaneVector> points, const Number& tolerance,
                          const Number& granted);

}  // namespace gonogo::oracle
