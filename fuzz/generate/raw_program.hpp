// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of a dialect's words without regard to their meaning.
#pragma once

#include "fuzz/generate/generator.hpp"

namespace gonogo::generate {

// Entries of the dialect's dictionary (fuzz/program/dictionaries), letters with numbers in any spelling,
// and seldom a byte that no program has. It varies only the readings of the machine.
GeneratedProgram raw_program(std::string_view dialect, Choices& choices,
                             const GeneratorSettings& settings);

}  // namespace gonogo::generate
