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

// Those whose words are a letter and a number.
inline constexpr Dialect kLetterAddress[] = {Dialect::gsk988ta, Dialect::hnc21t, Dialect::rs274};

// The text of a letter-address block.
inline std::string print(const Block& block) {
  return print(Dialect::rs274, block);
}

// For the messages of GoogleTest and RapidCheck.
inline void PrintTo(const Block& block, std::ostream* out) {
  const bool sinumerik = !block.named.empty() || (block.outside && block.outside->name == "string");
  *out << print(sinumerik ? Dialect::sinumerik : Dialect::rs274, block);
}
inline void PrintTo(const SyntaxError& error, std::ostream* out) {
  *out << name(error.code) << " at " << error.where.begin << ": " << message(error);
}
inline std::string_view name(Dialect dialect) {
  constexpr std::string_view kNames[] = {"gsk988ta", "hnc21t", "rs274", "sinumerik"};
  return kNames[static_cast<std::size_t>(dialect)];
}
// Those whose letters are capitals, with program numbers and control statements.
inline constexpr Dialect kLathes[] = {Dialect::gsk988ta, Dialect::hnc21t};

// The tree of a line that is well formed in a dialect.
inline Block parsed(Dialect dialect, std::string_view line) {
  Block block;
  const auto error = parse_block(dialect, line, block);
  EXPECT_FALSE(error) << name(dialect) << " \"" << line << "\": " << (error ? message(*error) : "");
  return block;
}
// The tree of a line that is well formed and the same in every dialect of a list.
template <std::size_t size>
Block parsed(const Dialect (&dialects)[size], std::string_view line) {
  Block block = parsed(dialects[0], line);
  for (const Dialect dialect : dialects) {
    EXPECT_EQ(parsed(dialect, line), block) << name(dialect) << " \"" << line << '"';
  }
  return block;
}
// In every dialect of letters and numbers.
inline Block parsed(std::string_view line) {
  return parsed(kLetterAddress, line);
}

// The error of a line that is not well formed in a dialect.
inline SyntaxError fault(Dialect dialect, std::string_view line) {
  Block block;
  const auto error = parse_block(dialect, line, block);
  EXPECT_TRUE(error) << name(dialect) << " \"" << line << "\" parses";
  return error.value_or(SyntaxError{});
}
// The error of a line that is not well formed, the same one in every dialect of a list.
template <std::size_t size>
SyntaxError fault(const Dialect (&dialects)[size], std::string_view line) {
  SyntaxError error = fault(dialects[0], line);
  for (const Dialect dialect : dialects) {
    EXPECT_EQ(fault(dialect, line), error) << name(dialect) << " \"" << line << '"';
  }
  return error;
}
// In every dialect of letters and numbers.
inline SyntaxError fault(std::string_view line) {
  return fault(kLetterAddress, line);
}

}  // namespace gonogo::grammar
