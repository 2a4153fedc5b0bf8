// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dialect of RS274/NGC. Letters stand in either case.
//
//   line      = blanks (tape-mark | block)
//   tape-mark = '%' blanks
//   block     = ['/'] [N whole] comment* item* [construct] [';' text]
//   construct = '#' rest | O rest | address [sign] ('#' | '[' | function) rest
//
// The rest of the block is that of all letter-address programs.
#include "grammar/x3/rs274.hpp"

#include "grammar/x3/letter_address.hpp"

namespace gonogo::grammar::rs274 {
namespace {

using namespace x3;  // the vocabulary of the dialect grammars

constexpr Letters kCase = Letters::any_case;
constexpr char kOWord[] = "o-word";
// Functions whose value may stand for a number without brackets round it.
constexpr std::array<std::string_view, 14> kFunctions{"ABS", "ACOS", "ASIN", "ATAN",  "COS",
                                                      "EXP", "FIX",  "FUP",  "LN",    "ROUND",
                                                      "SIN", "SQRT", "TAN",  "EXISTS"};

constexpr auto tape_mark_end = rule<struct TapeMarkEndId>{"tape-mark-end"} = spirit::eoi;

// clang-format off
constexpr auto tape_mark = flag<&Block::tape_mark>[sole<'%'>] >> blanks >> expect[tape_mark_end];

constexpr auto function_value = -sign >> Keyword<kFunctions, kCase>{};

constexpr auto item = word_but<kCase>(macro_value | function_value);

// A subroutine, a call or a control statement.
constexpr auto o_word = outside<kOWord>[letter<'O', kCase> >> macro_rest<kCase>];

constexpr auto construct =
      assignment<kCase>
    | o_word
    | macro_word<kCase>
    | outside<kExpression>[address<kCase> >> blanks >> function_value >> macro_rest<kCase>];

constexpr auto head = -skip >> -sequence_number<kCase>;

constexpr auto line =
    blanks >> (tape_mark | commented_block(head, items(item) >> -construct));
// clang-format on

}  // namespace

std::optional<SyntaxError> parse_line(std::string_view text, Block& into) {
  return read_line<kProgram<kCase>>(line, text, into);
}

}  // namespace gonogo::grammar::rs274
