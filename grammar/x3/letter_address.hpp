// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the dialects of letter-address programs have in common.
//
//   block      = head comment* (assignment | item* [construct]) [';' text]
//   item       = word | comment
//   word       = address number, the address a letter other than N and O
//   comment    = '(' any bytes but ')' ')'
//   assignment = '#' rest
//
// Blanks may stand between all of these and between an address and its number. A dialect says
// what its head, its keywords and its constructs are, and whether letters are capitals.
//
// The grammar only knows that a maker's macro language is there: from where it begins a line
// need only be free of bytes that no program has and close its comments and brackets.
//
// Its first bytes decide every alternative, so nothing backtracks into the block. The names of
// the rules are the keys that diagnostics.cpp maps to codes.
#pragma once

#include <boost/fusion/include/adapt_struct.hpp>
#include <optional>
#include <string_view>

#include "grammar/diagnostics.hpp"
#include "grammar/x3/lexical.hpp"

BOOST_FUSION_ADAPT_STRUCT(gonogo::grammar::Word, address, value)
BOOST_FUSION_ADAPT_STRUCT(gonogo::grammar::Comment, text, to_end_of_line)

namespace gonogo::grammar::x3 {

using spirit::attr;
using spirit::expect;
using spirit::rule;

// The stable names of the outside constructs that every dialect has.
inline constexpr char kVariable[] = "variable";
inline constexpr char kExpression[] = "expression";
inline constexpr char kControl[] = "control-statement";

inline constexpr ManyOf<kBlank> blanks;
template <Letters letters>
inline constexpr Address<letters> address;
inline constexpr OneOf<kSign> sign;
inline constexpr OneOf<kDigit> digit;
template <Letters letters>
inline constexpr OneOf<kMacro<letters>> macro_byte;
inline constexpr OpenBracket open_bracket;
inline constexpr CloseBracket close_bracket;
template <char byte>
inline constexpr Byte<byte> sole;
template <char capital, Letters letters>
inline constexpr Letter<capital, letters> letter;

// What must follow once a beginning has been read.
inline constexpr auto number = rule<struct NumberId, Decimal>{"number"} =
    Number<NumberForm::decimal>{};
inline constexpr auto whole = rule<struct WholeId, Decimal>{"whole-number"} =
    Number<NumberForm::whole>{};
inline constexpr auto closed_text = rule<struct ClosedTextId, std::string>{"closed-comment"} =
    ClosedText{};
inline constexpr auto closed_brackets = rule<struct ClosedBracketsId>{"closed-brackets"} =
    BracketsClosed{};
inline constexpr auto block_end = rule<struct BlockEndId>{"block-end"} = spirit::eoi;

// clang-format off
inline constexpr auto comment = sole<'('> >> expect[closed_text] >> attr(false);

// GSK-COM-08, HNC-COM-01: after ';' the rest of the line is ignored.
inline constexpr auto line_comment =
    sole<';'> >> -append<&Block::comments>[RestOfLine{} >> attr(true)];

inline constexpr auto leading_comments = *(append<&Block::comments>[comment] >> blanks);

// A value that is no number leaves the word to the outside constructs.
inline constexpr auto macro_value = -sign >> (sole<'#'> | sole<'['>);

// HNC-COM-01, NGC-COM-01: a blank may stand between the letter and its number.
template <Letters letters, typename Macro>
constexpr auto word_but(const Macro& value) {
  return address<letters> >> blanks >> !value >> expect[number];
}
template <const auto& keywords>
inline constexpr auto word =
    !Keyword<keywords, Letters::capital>{} >> word_but<Letters::capital>(macro_value);

template <typename Word>
constexpr auto items(const Word& item) {
  return *((append<&Block::words>[item] | append<&Block::comments>[comment]) >> blanks);
}

template <Letters letters = Letters::capital>
inline constexpr auto macro_rest =
    *(macro_byte<letters> | append<&Block::comments>[comment] | open_bracket | close_bracket)
    >> expect[closed_brackets];

template <Letters letters = Letters::capital>
inline constexpr auto assignment = outside<kVariable>[sole<'#'> >> macro_rest<letters>];

template <const auto& keywords>
inline constexpr auto control_statement =
    outside<kControl>[Keyword<keywords, Letters::capital>{} >> macro_rest<>];

// A word whose value is a variable or an expression.
template <Letters letters = Letters::capital>
inline constexpr auto macro_word =
      outside<kVariable>[address<letters> >> blanks >> -sign >> sole<'#'> >> macro_rest<letters>]
    | outside<kExpression>[address<letters> >> blanks >> -sign >> &sole<'['> >> macro_rest<letters>];

// Parts of heads.
inline constexpr auto skip = flag<&Block::skip>[sole<'/'>] >> blanks;
template <Letters letters = Letters::capital>
inline constexpr auto sequence_number =
    letter<'N', letters> >> blanks >> store<&Block::sequence_number>[expect[whole]];
inline constexpr auto program_number =
    sole<'O'> >> blanks >> store<&Block::program_number>[expect[whole]];
inline constexpr auto numbered_head =
    -(skip >> leading_comments) >> -(sequence_number<> | program_number);

// `rest` is what stands behind the head and the comments that follow it.
template <typename Head, typename Rest>
constexpr auto commented_block(const Head& head, const Rest& rest) {
  return head >> blanks >> leading_comments >> rest >> -line_comment >> expect[block_end];
}
template <const auto& keywords, typename Head, typename Construct>
constexpr auto block(const Head& head, const Construct& construct) {
  return commented_block(head, assignment<> | (items(word<keywords>) >> -construct));
}
// clang-format on

// Reads one line of text into a block that is empty. `line` is the parser of a dialect.
// GSK-COM-02, HNC-COM-01, NGC-COM-01: unreadable text is an error with its column.
template <const ByteSet& program = kProgram<Letters::capital>, typename Line>
std::optional<SyntaxError> read_line(const Line& line, std::string_view text, Block& into) {
  Iterator first = text.data();
  const Iterator last = first + text.size();
  Target target{into, first, 0};
  try {
    spirit::parse(first, last, spirit::with<TargetTag>(target)[line]);
  } catch (const spirit::expectation_failure<Iterator>& failure) {
    return diagnose(text, failure.which(), static_cast<std::size_t>(failure.where() - text.data()),
                    program);
  }
  return std::nullopt;
}

}  // namespace gonogo::grammar::x3
