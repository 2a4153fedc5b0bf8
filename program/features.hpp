// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which features of its dialect a program needs.
#pragma once

#include <set>
#include <string>

#include "program/modes.hpp"

namespace gonogo::program {

// Words of `gonogo spec --features`; "basic" always. Rather a feature too many than one
// too few.
std::set<std::string> features_needed(const ProgramText& program);
// The same of one of its blocks.
std::set<std::string> features_needed(const reference::Descriptor& table, const TextBlock& block);

}  // namespace gonogo::program
