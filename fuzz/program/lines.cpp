// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/lines.hpp"

#include <algorithm>

namespace gonogo::program {

std::vector<ProgramLine> program_lines(std::string_view program) {
  std::vector<ProgramLine> lines;
  while (!program.empty()) {
    const std::size_t stop = std::min(program.find_first_of("\r\n"), program.size());
    const std::string_view rest = program.substr(stop);
    const std::size_t size = rest.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, rest.size());
    lines.push_back({program.substr(0, stop), rest.substr(0, size)});
    program.remove_prefix(stop + size);
  }
  return lines;
}

}  // namespace gonogo::program
