// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lines of a program in memory with what ends them, so that they can be put together again.
#pragma once

#include <string_view>
#include <vector>

namespace gonogo::program {

struct ProgramLine {
  std::string_view text;
  std::string_view end;  // LF, CR LF, CR; nothing at the end of the program
};

// Lines end as the grammar ends them, so that line n is block n. They are parts of `program`.
std::vector<ProgramLine> program_lines(std::string_view program);

}  // namespace gonogo::program
