// SPDX-License-Identifier: GPL-3.0-or-later
//
// Trees written by hand, for the grammar tests.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>

#include "grammar/parser.hpp"

namespace gonogo::grammar {

inline Decimal decimal(std::int64_t digits, std::uint32_t scale = 0) {
  return {digits < 0, scale, static_cast<std::uint64_t>(digits < 0 ? -digits : digits), {}};
}

inline Word word(char address, std::int64_t digits, std::uint32_t scale = 0) {
  return {address, decimal(digits, scale), {}};
}

inline Comment comment(std::string_view text) {
  return {std::string(text), false, {}};
}
inline Comment line_comment(std::string_view text) {
  return {std::string(text), true, {}};
}

inline Block block_of(std::vector<Word> words) {
  Block block;
  block.words = std::move(words);
  return block;
}

// The tree of a line that is well formed.
inline Block parsed(std::string_view line) {
  Block block;
  const auto error = parse_block(Dialect::gsk988ta, line, block);
  EXPECT_FALSE(error) << '"' << line << "\": " << (error ? message(*error) : "");
  return block;
}

// The error of a line that is not.
inline SyntaxError fault(std::string_view line) {
  Block block;
  const auto error = parse_block(Dialect::gsk988ta, line, block);
  EXPECT_TRUE(error) << '"' << line << "\" parses";
  return error.value_or(SyntaxError{});
}

// For the messages of GoogleTest and RapidCheck.
inline void PrintTo(const Block& block, std::ostream* out) {
  *out << print(block);
}

}  // namespace gonogo::grammar
