// SPDX-License-Identifier: GPL-3.0-or-later
//
// What generated programs reach: their machines, and what the reference makes of them.
#pragma once

#include <string>

#include "fuzz/generate/generator.hpp"

namespace gonogo::generate {

// Adds what the program's machine has ("machine: offset G54"), and what the reference puts out for
// it ("record arc", "arc plane G18", "alarm value-sign", "clause GSK-G94"). For a program of more
// than 10,000 records, these.
void count_program(const GeneratedProgram& program, Distribution& distribution);

// A line a name, with how often it was counted a program.
std::string distribution_text(const Distribution& distribution);

}  // namespace gonogo::generate
