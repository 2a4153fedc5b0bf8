// SPDX-License-Identifier: GPL-3.0-or-later
//
// What earlier blocks leave in force for one: where a subject forgets it, the block alone does not
// show what it should have known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "reference/profile.hpp"

namespace gonogo::program {

// Bytes: nobody reads a longer program.
inline constexpr std::size_t kLongestShown = 100'000;

// "G81 of line 2 (NGC-MOD-01); R2 Z-5 of line 2 (NGC-CYC-03); G91 of line 1 (NGC-DIS-01)": the code
// that the block repeats, the words of a cycle that it lacks and that hold, the modes that are not
// those of power-on. Empty: none, there is no such line, or the program is longer than a person
// reads.
std::string in_force_text(const reference::Profile& profile, std::string_view program,
                          std::uint64_t line);

}  // namespace gonogo::program
