// SPDX-License-Identifier: GPL-3.0-or-later
//
// The settings of a profile one by one, each of which can go back to its dialect's default.
#pragma once

#include <cstddef>

#include "reference/profile.hpp"

namespace gonogo::fuzz {

std::size_t profile_parts();
// Sets part i of the profile to its default; false where it is there already.
bool reset_part(reference::Profile& profile, std::size_t part);

}  // namespace gonogo::fuzz
