// SPDX-License-Identifier: GPL-3.0-or-later
//
// The modes in force at power-on, as codes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/code.hpp"
#include "reference/profile.hpp"

namespace gonogo::reference {

// The codes that put in force what the machine comes up with, in the order of the table: written
// before a program they change nothing, but that a Kind::off ends the motion in force.
std::vector<const Code*> power_on_codes(const Profile& profile);

// The same for people: "G18 G21 G90 and G00; X is a diameter; no feed, every axis at 0".
std::string power_on_text(std::string_view dialect);

}  // namespace gonogo::reference
