// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of a dialect's words without regard to their meaning.
#pragma once

#include "fuzz/generator.hpp"

namespace gonogo::fuzz {

// Entries of the dialect's dictionary (fuzz/dictionaries), letters with numbers in any spelling,
// and seldom a byte that no program has. Of the machine it varies the readings alone.
GeneratedProgram raw_program(std::string_view dialect, Choices& choices,
                             const GeneratorSettings& settings);

}  // namespace gonogo::fuzz
