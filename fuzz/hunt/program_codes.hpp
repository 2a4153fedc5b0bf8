// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a program's codes say of it: which code a block runs under, and which features of its
// dialect the program needs. Read off the text, because a program may alarm before it gets there.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/hunt/program_text.hpp"

namespace gonogo::fuzz {

// Whether the code is one of those that say what a block does: G1, G94, CIP, LCYC75.
bool is_motion_code(std::string_view dialect, std::string_view code);

// Such a code in force in each line, the last one that was written; "" before the first.
std::vector<std::string> codes_in_force(std::string_view dialect,
                                        const std::vector<TextLine>& lines);

// Of the vocabulary of `gonogo spec --features`; "basic" always. Rather a feature too many than one
// too few.
std::set<std::string> features_needed(std::string_view dialect, const std::vector<TextLine>& lines);

}  // namespace gonogo::fuzz
