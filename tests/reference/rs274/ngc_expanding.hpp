// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the RS274/NGC reference share. Lines are those of gsk988ta/expanding.hpp,
// without the M functions: a program and a profile in, text out.
#pragma once

#include "tests/reference/gsk988ta/expanding.hpp"

namespace gonogo::reference::testing::ngc {

// The default profile of the dialect with these readings, under which a text need not end the
// program.
Profile ngc(std::initializer_list<std::pair<std::string_view, std::string_view>> readings = {});
// ngc.arc-tolerance = linuxcnc.
Profile linuxcnc();

// All motions and dwells, and an alarm or not-covered at the end; no M functions, no `end`.
Lines path(std::string_view program, const Profile& profile = ngc());
// The alarm, not-covered or `end` of a program.
std::string ending_of(std::string_view program, const Profile& profile = ngc());
Lines clauses(std::string_view program, const Profile& profile = ngc());
Lines touched(std::string_view program, const Profile& profile = ngc());

}  // namespace gonogo::reference::testing::ngc
