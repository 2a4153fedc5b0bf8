// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference and a recorded outcome side by side, for people: how long the program takes, and
// how its numbers are rounded.
#pragma once

#include <string>

#include "cli/recorded_trace.hpp"
#include "oracle/motion/tolerances.hpp"
#include "reference/profile.hpp"

namespace gonogo::cli {

// A table of feed time, turns of the spindle, dwells and the length of traverses; behind what is
// off by a factor between units stands that factor. It decides nothing.
std::string times_text(const reference::Profile& profile, const ProgramFile& program,
                       RecordedTrace& trace);

// How the coordinates of an outcome that is not GO are rounded, as far as its motions are those of
// the reference one by one.
std::string rounding_text(const reference::Profile& profile, const ProgramFile& program,
                          RecordedTrace& trace, const oracle::Tolerances& tolerances);

}  // namespace gonogo::cli
