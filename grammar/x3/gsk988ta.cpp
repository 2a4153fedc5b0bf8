// SPDX-License-Identifier: GPL-3.0-or-later
//
// The GSK 988TA dialect.
//
//   line      = blanks (tape-mark | block)
//   tape-mark = '%' blanks
//   block     = ['/'] [N whole | O whole] comment* (assignment | item* [construct]) [';' text]
//   item      = word | comment
//   word      = address number, the address a capital letter other than N and O
//   comment   = '(' any bytes but ')' ')'
//
// Blanks may stand between all of these and between an address and its number.
//
// Of the maker's macro language the grammar only knows that it is there: a value that begins with
// '#' or '[' (also after a sign), a block that begins with '#', a control keyword, P[T123]. From
// there on a line need only be free of bytes that no program has and close its comments and
// brackets.
//
// Every alternative is told by its first bytes, so nothing backtracks into the block. The names of
// the rules are the keys that diagnostics.cpp maps to codes.
#include "grammar/x3/gsk988ta.hpp"

#include <boost/fusion/include/adapt_struct.hpp>

#include "grammar/diagnostics.hpp"
#include "grammar/x3/lexical.hpp"

BOOST_FUSION_ADAPT_STRUCT(gonogo::grammar::Word, address, value)
BOOST_FUSION_ADAPT_STRUCT(gonogo::grammar::Comment, text, to_end_of_line)

namespace gonogo::grammar::gsk988ta {
namespace {

using namespace x3;  // the vocabulary of the dialect grammars
using spirit::attr;
using spirit::expect;
using spirit::rule;

constexpr char kVariable[] = "variable";
constexpr char kExpression[] = "expression";
constexpr char kControl[] = "control-statement";
constexpr char kFileName[] = "file-name";
constexpr std::array<std::string_view, 7> kKeywords{"IF",  "WHILE", "GOTO", "DO",
                                                    "END", "THEN",  "ELSE"};

constexpr ManyOf<kBlank> blanks;
constexpr OneOf<kAddress> address;
constexpr OneOf<kSign> sign;
constexpr OneOf<kDigit> digit;
constexpr OneOf<kMacro> macro_byte;
constexpr Keyword<kKeywords> keyword;
constexpr OpenBracket open_bracket;
constexpr CloseBracket close_bracket;
template <char byte>
constexpr Byte<byte> sole;

// What must follow once a beginning has been read.
constexpr auto number = rule<struct NumberId, Decimal>{"number"} = Number<NumberForm::decimal>{};
constexpr auto whole = rule<struct WholeId, Decimal>{"whole-number"} = Number<NumberForm::whole>{};
constexpr auto closed_text = rule<struct ClosedTextId, std::string>{"closed-comment"} =
    ClosedText{};
constexpr auto closed_brackets = rule<struct ClosedBracketsId>{"closed-brackets"} =
    BracketsClosed{};
constexpr auto block_end = rule<struct BlockEndId>{"block-end"} = spirit::eoi;
constexpr auto tape_mark_end = rule<struct TapeMarkEndId>{"tape-mark-end"} = spirit::eoi;

// clang-format off
constexpr auto comment = sole<'('> >> expect[closed_text] >> attr(false);

// GSK-COM-08: after ';' the rest of the line is ignored.
constexpr auto line_comment = sole<';'> >> -append<&Block::comments>[RestOfLine{} >> attr(true)];

// A value that is no number leaves the word to the outside constructs.
constexpr auto macro_value = -sign >> (sole<'#'> | sole<'['>);

constexpr auto word = !keyword >> address >> blanks >> !macro_value >> expect[number];

constexpr auto macro_rest =
    *(macro_byte | append<&Block::comments>[comment] | open_bracket | close_bracket)
    >> expect[closed_brackets];

constexpr auto assignment = outside<kVariable>[sole<'#'> >> macro_rest];

constexpr auto file_name =
    sole<'P'> >> blanks >> &(sole<'['> >> blanks >> sole<'T'> >> digit);

constexpr auto construct =
      outside<kControl>[keyword >> macro_rest]
    | outside<kFileName>[file_name >> macro_rest]
    | outside<kVariable>[address >> blanks >> -sign >> sole<'#'> >> macro_rest]
    | outside<kExpression>[address >> blanks >> -sign >> &sole<'['> >> macro_rest];

constexpr auto head =
      -(flag<&Block::skip>[sole<'/'>] >> blanks)
    >> -(  (sole<'N'> >> blanks >> store<&Block::sequence_number>[expect[whole]])
         | (sole<'O'> >> blanks >> store<&Block::program_number>[expect[whole]]))
    >> blanks;

constexpr auto leading_comments = *(append<&Block::comments>[comment] >> blanks);

constexpr auto items =
    *((append<&Block::words>[word] | append<&Block::comments>[comment]) >> blanks);

constexpr auto block =
    head >> leading_comments >> (assignment | (items >> -construct)) >> -line_comment
    >> expect[block_end];

constexpr auto tape_mark = flag<&Block::tape_mark>[sole<'%'>] >> blanks >> expect[tape_mark_end];

constexpr auto line = blanks >> (tape_mark | block);
// clang-format on

}  // namespace

// GSK-COM-02: unreadable text is an error with its column.
std::optional<SyntaxError> parse_line(std::string_view text, Block& into) {
  Iterator first = text.data();
  const Iterator last = first + text.size();
  Target target{into, first, 0};
  try {
    spirit::parse(first, last, spirit::with<TargetTag>(target)[line]);
  } catch (const spirit::expectation_failure<Iterator>& failure) {
    return diagnose(text, failure.which(), static_cast<std::size_t>(failure.where() - text.data()));
  }
  return std::nullopt;
}

}  // namespace gonogo::grammar::gsk988ta
