// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oracle/judge/program_input.hpp"
#include "reference/profile.hpp"

namespace gonogo::oracle {

// The profile with the readings under which a program is shown: as they are, where it ends without
// an alarm; else an assignment of the open ones under which it does, if there is one.
reference::Profile profile_to_show(const reference::Profile& profile, const ProgramText& program);

}  // namespace gonogo::oracle
