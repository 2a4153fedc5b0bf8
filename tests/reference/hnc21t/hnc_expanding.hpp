// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the HNC reference share. Lines are those of gsk988ta/expanding.hpp, without the
// M functions: a program and a profile in, text out.
#pragma once

#include "tests/reference/gsk988ta/expanding.hpp"

namespace gonogo::reference::testing::hnc {

// The default profile of the dialect with these readings.
Profile hnc(std::initializer_list<std::pair<std::string_view, std::string_view>> readings = {});

// All motions and dwells, and an alarm or not-covered at the end; no M functions, no `end`.
Lines path(std::string_view program, const Profile& profile = hnc());
// The same without the first record: what follows the move to the start point.
Lines cycle(const std::string& start, const std::string& blocks, const Profile& profile = hnc());
// The alarm, not-covered or `end` of a program.
std::string ending_of(std::string_view program, const Profile& profile = hnc());
inline const std::string kEndAtOrigin = "end x0 y0 z0 a0 c0";
Lines clauses(std::string_view program, const Profile& profile = hnc());
Lines touched(std::string_view program, const Profile& profile = hnc());

}  // namespace gonogo::reference::testing::hnc
