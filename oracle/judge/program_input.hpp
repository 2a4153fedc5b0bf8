// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "grammar/line_source.hpp"

namespace gonogo::oracle {

// A program in memory as lines.
struct ProgramInput {
  explicit ProgramInput(std::string_view program) : bytes(program), lines(bytes) {}
  grammar::MemorySource bytes;
  grammar::LineSource lines;
};

}  // namespace gonogo::oracle
