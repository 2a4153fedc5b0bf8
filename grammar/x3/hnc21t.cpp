// SPDX-License-Identifier: GPL-3.0-or-later
//
// The HNC-21T dialect.
//
//   line      = comment* (tape-mark | block)
//   tape-mark = '%' comment* [';' text]
//   block     = head comment* (assignment | item* [construct]) [';' text]
//   head      = '%' whole | ['/' comment*] [N whole | O whole]
//   construct = control keyword rest | ('RL' | 'RC') '=' rest | address [sign] ('#' | '[') rest
//
// The rest of the block is that of all letter-address programs.
#include "grammar/x3/hnc21t.hpp"

#include "grammar/x3/letter_address.hpp"

namespace gonogo::grammar::hnc21t {
namespace {

using namespace x3;  // the vocabulary of the dialect grammars

// RL= and RC= are no control words; they only keep R from being read as an address.
constexpr std::array<std::string_view, 8> kKeywords{"IF",   "ELSE", "ENDIF", "WHILE",
                                                    "ENDW", "GOTO", "RL",    "RC"};
constexpr std::array<std::string_view, 6> kControlWords{"IF",    "ELSE", "ENDIF",
                                                        "WHILE", "ENDW", "GOTO"};
constexpr std::array<std::string_view, 1> kChamferWord{"RC"};
constexpr std::array<std::string_view, 1> kRoundingWord{"RL"};
constexpr char kChamfer[] = "RC=";
constexpr char kRounding[] = "RL=";

constexpr auto percent_sign_end = rule<struct PercentSignEndId>{"percent-sign-end"} = spirit::eoi;

// clang-format off
// '%' alone is a tape mark; with a number it is the head of a program, as O is.
constexpr auto tape_mark =
    flag<&Block::tape_mark>[sole<'%'> >> blanks >> !digit] >> leading_comments >> -line_comment
    >> expect[percent_sign_end];

constexpr auto percent_head =
    sole<'%'> >> blanks >> store<&Block::program_number>[expect[whole]];

// HNC-WRD-01: the chamfer and the rounding between two motions.
template <const auto& keyword, const char* name>
constexpr auto corner = outside<name>[
    Keyword<keyword, Letters::capital>{} >> blanks >> &sole<'='> >> macro_rest<>];

constexpr auto construct =
      control_statement<kControlWords>
    | corner<kChamferWord, kChamfer>
    | corner<kRoundingWord, kRounding>
    | macro_word<>;

constexpr auto line =
    blanks >> leading_comments
    >> (tape_mark | block<kKeywords>(percent_head | numbered_head, construct));
// clang-format on

}  // namespace

std::optional<SyntaxError> parse_line(std::string_view text, Block& into) {
  return read_line(line, text, into);
}

}  // namespace gonogo::grammar::hnc21t
