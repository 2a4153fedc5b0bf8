// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program cut into lines and words as far as that goes without its grammar: enough to make other
// programs out of its parts, in any dialect and also where the program is wrong.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/exact/number.hpp"

namespace gonogo::program {

// "X-12.5", "CR=5.2", "R101=R1+2", "(comment)", "%", with the blanks before it.
struct TextWord {
  std::string gap;
  std::string text;
  friend bool operator==(const TextWord&, const TextWord&) = default;
};

struct TextLine {
  std::vector<TextWord> words;
  std::string rest;  // blanks behind the last word
  std::string end;   // "\n", "\r\n", "\r" or nothing
  friend bool operator==(const TextLine&, const TextLine&) = default;
};

// Lines end as the grammar ends them, so that line n is block n. text_of(lines_of(t)) == t.
std::vector<TextLine> lines_of(std::string_view program);
std::string text_of(const std::vector<TextLine>& lines);
std::string line_text(const TextLine& line);  // with its end

// Blocks that are there to be read: lines with at least one word.
std::size_t count_blocks(std::string_view program);

// The letters that a word begins with, in capitals: "X", "CR"; empty for others.
std::string address_of(const TextWord& word);
// The same with the number that belongs to it: "R105" of R105=2, "I1" of I1=AC(3).
std::string name_of(const TextWord& word);
// Whether it is an address or a code, and not the number of a block or a program, nor a comment.
bool is_word(const TextWord& word);
bool is_comment(const TextWord& word);
// The address of a word with its number where it is a code: "G1" of g01, "G90.1", "M30", "LCYC75",
// "CIP"; else empty.
std::string code_of(const TextWord& word);

// A decimal of at most 15 digits: value / 10^scale.
struct SmallDecimal {
  std::int64_t value = 0;
  int scale = 0;
  std::string text() const;
  friend bool operator==(const SmallDecimal&, const SmallDecimal&) = default;
};

// Where a number stands in a word, with its sign.
struct NumberPlace {
  std::size_t begin = 0;
  std::size_t end = 0;
  SmallDecimal number;
};
// The numbers of a word that are values: not the index of R101=, nothing in comments.
std::vector<NumberPlace> numbers_of(const TextWord& word);
// The first of them.
std::optional<SmallDecimal> value_of(const TextWord& word);
// The value of a word that is one number: 2.5 of X2.5, CR=2.5, X=AC(2.5).
std::optional<exact::Number> exact_value_of(const TextWord& word);
// The word with another value in the place of that. REQUIRES: it has one.
std::string with_value(const TextWord& word, const exact::Number& value);

// Both with the larger scale of the two.
struct SameScale {
  std::int64_t a;
  std::int64_t b;
};
SameScale same_scale(const SmallDecimal& a, const SmallDecimal& b);

}  // namespace gonogo::program
