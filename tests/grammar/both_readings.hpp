// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line through the facade of the grammar, which may take the filter for plain blocks, and through
// the Spirit grammar of the dialect, which is the definition.
#pragma once

#include <gtest/gtest.h>

#include "grammar/parser.hpp"
#include "grammar/x3/gsk988ta.hpp"
#include "grammar/x3/hnc21t.hpp"
#include "grammar/x3/rs274.hpp"
#include "grammar/x3/sinumerik.hpp"

namespace gonogo::grammar {

inline std::optional<SyntaxError> parse_by_definition(Dialect dialect, std::string_view line,
                                                      Block& block) {
  block.clear();
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

template <typename Node>
std::vector<Span> places_of(const std::vector<Node>& nodes) {
  std::vector<Span> places;
  for (const Node& node : nodes) places.push_back(node.where);
  return places;
}

// The same error, or the same tree with the same places.
inline void expect_both_read_alike(Dialect dialect, std::string_view line) {
  Block got;
  Block want;
  const std::optional<SyntaxError> error = parse_block(dialect, line, got);
  ASSERT_EQ(error, parse_by_definition(dialect, line, want)) << line;
  if (error) return;
  ASSERT_EQ(got, want) << line;
  ASSERT_EQ(got.number_place.span, want.number_place.span) << line;
  if (dialect == Dialect::rs274) {
    ASSERT_EQ(got.line_comment.span, want.line_comment.span) << line;
  }
  ASSERT_EQ(places_of(got.words), places_of(want.words)) << line;
  ASSERT_EQ(places_of(got.named), places_of(want.named)) << line;
  ASSERT_EQ(places_of(got.terms), places_of(want.terms)) << line;
  ASSERT_EQ(places_of(got.comments), places_of(want.comments)) << line;
  ASSERT_EQ(got.outside.has_value(), want.outside.has_value()) << line;
  if (got.outside) {
    ASSERT_EQ(got.outside->where, want.outside->where) << line;
  }
}

}  // namespace gonogo::grammar
