// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "fuzz/generate/generator.hpp"

namespace gonogo::hunt {

// A program with the machine that it is for, and the generator's decisions where it has any.
struct Specimen {
  generate::GeneratedProgram program;
  std::vector<std::uint8_t> bytes;  // empty: the text was changed by hand
};

// What a subject is shown: a program, and programs that ran before it in the same process.
struct Reproducer {
  std::vector<generate::GeneratedProgram> before;
  generate::GeneratedProgram program;
};

}  // namespace gonogo::hunt
