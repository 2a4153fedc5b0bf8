// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/parser.hpp"

#include "grammar/line_source.hpp"
#include "grammar/plain_block.hpp"
#include "grammar/x3/gsk988ta.hpp"
#include "grammar/x3/hnc21t.hpp"
#include "grammar/x3/rs274.hpp"
#include "grammar/x3/sinumerik.hpp"

namespace gonogo::grammar {

std::optional<SyntaxError> parse_block(Dialect dialect, std::string_view line, Block& block) {
  block.clear();
  if (line.size() > kMaximumLine) return line_too_long();
  if (read_plain_block(dialect, line, block)) return std::nullopt;
  switch (dialect) {
    case Dialect::gsk988ta:
      return gsk988ta::parse_line(line, block);
    case Dialect::hnc21t:
      return hnc21t::parse_line(line, block);
    case Dialect::rs274:
      return rs274::parse_line(line, block);
    case Dialect::sinumerik:
      return sinumerik::parse_line(line, block);
  }
  __builtin_unreachable();
}

}  // namespace gonogo::grammar
