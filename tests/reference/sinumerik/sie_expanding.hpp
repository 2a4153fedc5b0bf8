// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of the SINUMERIK reference share. Lines are those of gsk988ta/expanding.hpp,
// without the M functions: a program and a profile in, text out.
#pragma once

#include "tests/reference/gsk988ta/expanding.hpp"

namespace gonogo::reference::testing::sie {

// The default profile of the dialect with these readings.
Profile sie(std::initializer_list<std::pair<std::string_view, std::string_view>> readings = {});

// All motions and dwells, and an alarm or not-covered at the end; no M functions, no `end`.
Lines path(std::string_view program, const Profile& profile = sie());
// One of its lines, counted from 0.
std::string line(std::string_view program, std::size_t place, const Profile& profile = sie());
// How a block ends where the machine stood at the origin with F100 in force: "end", "not-covered
// TRANS", or the classes and words of its alarms in their order: "arc-radius CR, feed-missing F".
std::string outcome(std::string_view block, const Profile& profile = sie());
// The same for a whole program, with no feed in force.
std::string outcome_of_program(std::string_view program, const Profile& profile = sie());
Lines clauses(std::string_view program, const Profile& profile = sie());
Lines touched(std::string_view program, const Profile& profile = sie());

// The last motion of a program.
Record last_motion(std::string_view program, const Profile& profile = sie());
// "50.000077645,49.999984121": its centre, and its end along p and q, to nine decimals.
std::string centre(const Record& arc);
std::string end_in_plane(const Record& arc);

}  // namespace gonogo::reference::testing::sie
