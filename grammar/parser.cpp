// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/parser.hpp"

#include "grammar/line_source.hpp"
#include "grammar/x3/gsk988ta.hpp"

namespace gonogo::grammar {

std::optional<SyntaxError> parse_block(Dialect dialect, std::string_view line, Block& block) {
  block.clear();
  if (line.size() > kMaximumLine) return line_too_long();
  switch (dialect) {
    case Dialect::gsk988ta:
      return gsk988ta::parse_line(line, block);
  }
  __builtin_unreachable();
}

}  // namespace gonogo::grammar
