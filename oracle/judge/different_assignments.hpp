// SPDX-License-Identifier: GPL-3.0-or-later
//
// What judge_session.cpp and different_assignments.cpp share.
#pragma once

#include <vector>

#include "oracle/judge/assignment_set.hpp"
#include "oracle/judge/program_input.hpp"

namespace gonogo::oracle {

reference::Profile with_readings(const reference::Profile& profile,
                                 reference::ReadingChoice choice);

// Puts behind the others those of a set that say different things; the first of them is what a run
// of the set itself takes. False: there are too many.
bool add_different(const reference::Profile& profile, const ProgramText& program, AssignmentSet set,
                   std::vector<AssignmentSet>& different);

}  // namespace gonogo::oracle
