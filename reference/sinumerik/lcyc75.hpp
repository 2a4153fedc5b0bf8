// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of LCYC75: its rules, its levels, and one path that it admits.
#pragma once

#include <optional>

#include "reference/generator.hpp"
#include "reference/sinumerik/cycle.hpp"

namespace gonogo::reference::sinumerik {

// In lcyc75_rules.cpp. The radius of the tool in force; nothing when a rule is broken.
std::optional<Number> check_pocket(const CycleCall& call);
// SIE-LC75-09: the corner radius, no larger than fits.
Number corner_radius(const CycleCall& call);

// In lcyc75_path.cpp: contour-parallel passes from inside out, a step of the tool's radius apart.
Generator<Item> contour_parallel(PocketMilling pocket);

}  // namespace gonogo::reference::sinumerik
