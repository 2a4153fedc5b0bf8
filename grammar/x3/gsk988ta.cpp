// SPDX-License-Identifier: GPL-3.0-or-later
//
// The GSK 988TA dialect.
//
//   line      = comment* (tape-mark | block)
//   tape-mark = '%' comment* [';' text]
//   block     = ['/' comment*] [N whole | O whole] comment* (assignment | item* [construct])
//               [';' text]
//   construct = control keyword rest | P '[' T digit rest | ',' address rest
//             | address [sign] ('#' | '[') rest
//
// The rest of the block is that of all letter-address programs.
#include "grammar/x3/gsk988ta.hpp"

#include "grammar/x3/letter_address.hpp"

namespace gonogo::grammar::gsk988ta {
namespace {

using namespace x3;  // the vocabulary of the dialect grammars

constexpr char kFileName[] = "file-name";
constexpr char kCommaWord[] = "comma-word";
constexpr std::array<std::string_view, 7> kKeywords{"IF",  "WHILE", "GOTO", "DO",
                                                    "END", "THEN",  "ELSE"};

constexpr auto tape_mark_end = rule<struct TapeMarkEndId>{"tape-mark-end"} = spirit::eoi;

// clang-format off
constexpr auto tape_mark =
    flag<&Block::tape_mark>[sole<'%'>] >> blanks >> leading_comments >> -line_comment
    >> expect[tape_mark_end];

// M98 P[T123] calls a program by the name of its file.
constexpr auto file_name =
    sole<'P'> >> blanks >> &(sole<'['> >> blanks >> sole<'T'> >> digit);

// GSK-WRD-01: ,C and ,R between two motions.
constexpr auto comma_word = sole<','> >> blanks >> address<Letters::capital>;

constexpr auto construct =
      control_statement<kKeywords>
    | outside<kCommaWord>[comma_word >> macro_rest<>]
    | outside<kFileName>[file_name >> macro_rest<>]
    | macro_word<>;

constexpr auto line =
    blanks >> leading_comments >> (tape_mark | block<kKeywords>(numbered_head, construct));
// clang-format on

}  // namespace

std::optional<SyntaxError> parse_line(std::string_view text, Block& into) {
  return read_line(line, text, into);
}

}  // namespace gonogo::grammar::gsk988ta
