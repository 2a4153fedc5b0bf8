// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which features of its dialect a program needs.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "fuzz/program/modes.hpp"

namespace gonogo::program {

// Words of `gonogo spec --features`. Rather a feature too many than one too few. What moves
// straight and sets modes needs "basic" only where it stands alone: it stands around every cycle
// and path.
std::set<std::string> features_needed(const ProgramText& program);

// Those of some lines or of one block of a program; none where these are plain.
std::set<std::string> features_of_part(const ProgramText& part);
std::set<std::string> features_of_part(const reference::Descriptor& table, const TextBlock& block);

// Those of a case of the corpus: the stated ones, except those of cycles and arcs that the program
// does not have, and what any program may have beside.
std::vector<std::string> features_of_case(const ProgramText& program,
                                          const std::vector<std::string>& stated);

}  // namespace gonogo::program
