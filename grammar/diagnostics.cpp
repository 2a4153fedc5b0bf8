// SPDX-License-Identifier: GPL-3.0-or-later
#include "grammar/diagnostics.hpp"

#include <cstdlib>
#include <string>

#include "grammar/byte_set.hpp"
#include "grammar/line_source.hpp"
#include "grammar/lookalike.hpp"
#include "grammar/parser.hpp"
#include "grammar/utf8.hpp"

namespace gonogo::grammar {
namespace {

constexpr std::string_view kWordEnd = "word-end";

// What each rule of the grammars means when it is not met. '@' stands for the address before it.
struct Expectation {
  std::string_view key;
  SyntaxCode code;
  std::string_view phrase;
};

constexpr Expectation kExpectations[] = {
    {"number", SyntaxCode::number_expected, "a number after @"},
    {"whole-number", SyntaxCode::number_expected, "a whole number without a sign after @"},
    {"closed-comment", SyntaxCode::unclosed_comment, "')'"},
    {"closed-brackets", SyntaxCode::unexpected_character, "']'"},
    {"block-end", SyntaxCode::unexpected_character,
     "an address, a comment in '(' and ')' or behind ';', or the end of the block"},
    {"tape-mark-end", SyntaxCode::unexpected_character, "the end of the line after '%'"},
    {"percent-sign-end", SyntaxCode::unexpected_character,
     "a program number or the end of the line after '%'"},
    {"program-name-end", SyntaxCode::unexpected_character,
     "the name of the program or the end of the line after '%'"},
    {"colon-number", SyntaxCode::number_expected, "a whole number without a sign after ':'"},
    {"number-or-equals", SyntaxCode::number_expected, "a number or '=' after @"},
    {"value", SyntaxCode::number_expected, "a number, an R parameter, a function or '('"},
    {"ngc-value", SyntaxCode::number_expected, "a number, a parameter, a function or '['"},
    {"assignment", SyntaxCode::unexpected_character, "'=' after the parameter"},
    {"bracketed-value", SyntaxCode::unexpected_character, "'['"},
    {"quotient", SyntaxCode::unexpected_character, "'/' and a second value of ATAN"},
    {"parameter-name", SyntaxCode::unexpected_character, "a name between '<' and '>'"},
    {"equals", SyntaxCode::unexpected_character, "'=' after @"},
    {"parameter-equals", SyntaxCode::unexpected_character, "'=' after the R parameter"},
    {"open-bracket", SyntaxCode::unexpected_character, "'(' after @"},
    {"close-bracket", SyntaxCode::unexpected_character, "')'"},
    {"close-quote", SyntaxCode::unexpected_character, "'\"' at the end of the string"},
    {"own-value", SyntaxCode::unexpected_character,
     "a value without AC() and IC(), which are only the whole value of an axis, I J K, I1 J1 K1 or "
     "AP"},
    {"nesting", SyntaxCode::nested_too_deep, "a value of at most 64 brackets in each other"},
    {kWordEnd, SyntaxCode::unexpected_character,
     "a word, ';' with a comment behind it, or the end of the block"},
};

// A code, its stable name and its sentence; '@' stands for what was expected.
struct Meaning {
  SyntaxCode code;
  std::string_view name;
  std::string_view sentence;
};

constexpr Meaning kMeanings[] = {
    {SyntaxCode::unexpected_character, "unexpected-character",
     "This cannot stand here; expected is @."},
    {SyntaxCode::number_expected, "number-expected", "A number is missing here; expected is @."},
    {SyntaxCode::unclosed_comment, "unclosed-comment",
     "The comment that begins here is not closed in its line; expected is @."},
    {SyntaxCode::misplaced_number_word, "misplaced-number-word",
     "A sequence or program number stands only at the head of a block; expected is @."},
    {SyntaxCode::line_too_long, "line-too-long",
     "The line is longer than the gauge reads, 1,048,576 bytes; expected is @."},
    {SyntaxCode::nested_too_deep, "nested-too-deep",
     "Brackets stand deeper in each other than the gauge reads; expected is @."},
};

const Expectation& expectation_of(std::string_view key) {
  for (const Expectation& entry : kExpectations) {
    if (entry.key == key) return entry;
  }
  std::abort();
}

const Meaning& meaning_of(SyntaxCode code) {
  for (const Meaning& entry : kMeanings) {
    if (entry.code == code) return entry;
  }
  std::abort();
}

std::string insert(std::string_view pattern, std::string_view what) {
  std::string out(pattern);
  const std::size_t place = out.find('@');
  if (place != std::string::npos) out.replace(place, 1, what);
  return out;
}

Span span(std::size_t begin, std::size_t end) {
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

// The place of the fault within a number: behind the sign and the point that it begins with.
std::size_t behind_number_start(std::string_view line, std::size_t offset) {
  if (offset < line.size() && kSign.contains(line[offset])) ++offset;
  if (offset < line.size() && line[offset] == '.') ++offset;
  return offset;
}

// The address that stands before `offset`, with all its letters.
std::string_view address_before(std::string_view line, std::size_t offset) {
  while (offset > 0 && !kLetter.contains(line[offset - 1])) --offset;
  std::size_t begin = offset;
  while (begin > 0 && kLetter.contains(line[begin - 1])) --begin;
  return line.substr(begin, offset - begin);
}

// N, or ':' in its place with a number.
bool begins_number_word(std::string_view line, std::size_t offset) {
  if (capital_of(line[offset]) == 'N') return true;
  return line[offset] == ':' && offset + 1 < line.size() && kDigit.contains(line[offset + 1]);
}

// A character that has no place in any block, outside comments.
SyntaxError foreign_character(std::string_view line, std::size_t offset, std::string phrase) {
  const Character character = decode_character(line, offset);
  std::string hint = meant_instead(line, offset);
  return {SyntaxCode::unexpected_character, span(offset, offset + character.length),
          hint.empty() ? std::move(phrase) : std::move(hint)};
}

}  // namespace

SyntaxError diagnose(std::string_view line, std::string_view key, std::size_t offset,
                     const ByteSet& program) {
  // '//' behind a value is no quotient, but meant as a comment.
  if (key == "value" && line.substr(0, offset).ends_with('/') &&
      line.substr(offset).starts_with('/')) {
    return diagnose(line, kWordEnd, offset - 1, program);
  }
  const Expectation& expectation = expectation_of(key);
  if (expectation.code == SyntaxCode::unclosed_comment) {
    return {expectation.code, span(offset - 1, line.size()), std::string(expectation.phrase)};
  }
  if (key == "number" || key == "number-or-equals") offset = behind_number_start(line, offset);
  std::string phrase = insert(expectation.phrase, address_before(line, offset));
  if (offset == line.size()) return {expectation.code, span(offset, offset), std::move(phrase)};
  if (key == kWordEnd) {
    // At the head of a block the first '/' leaves it out.
    if (offset == 1 && line.starts_with("//")) offset = 0;
    // What other languages begin a comment with, or a text leaves blocks out by.
    for (const std::string_view sign : {"//", "\xE2\x80\xA6", "..."}) {
      if (!line.substr(offset).starts_with(sign)) continue;
      return {SyntaxCode::unexpected_character, span(offset, offset + sign.size()),
              "';', with which a comment begins; " + std::string(sign) + " begins none"};
    }
  }
  const char byte = line[offset];
  if (!program.contains(byte)) return foreign_character(line, offset, std::move(phrase));
  const char capital = capital_of(byte);
  if (key == "block-end" && (capital == 'N' || capital == 'O')) {
    return {SyntaxCode::misplaced_number_word, span(offset, offset + 1),
            "an address other than N and O"};
  }
  if (key == kWordEnd && begins_number_word(line, offset)) {
    return {SyntaxCode::misplaced_number_word, span(offset, offset + 1), "a word other than N"};
  }
  return {expectation.code, span(offset, offset + 1), std::move(phrase)};
}

SyntaxError line_too_long() {
  return {SyntaxCode::line_too_long, span(kMaximumLine, kMaximumLine), "the end of the line"};
}

bool is_limit_of_gauge(const SyntaxError& error) {
  return error.code == SyntaxCode::line_too_long || error.code == SyntaxCode::nested_too_deep;
}

std::string_view name(SyntaxCode code) {
  return meaning_of(code).name;
}

std::string message(const SyntaxError& error) {
  return insert(meaning_of(error.code).sentence, error.expected);
}

}  // namespace gonogo::grammar
