// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dialect of RS274/NGC. Letters stand in either case. NGC-COM-04: blanks and tabs mean nothing
// outside comments, so the line is read without them.
//
//   line      = tape-mark | name | block
//   tape-mark = '%'
//   name      = O whole comment* [';' text]
//   block     = ['/'] [N whole ['.' whole]] comment* item* [construct] [';' text]
//   construct = '#' rest | O rest | ('@' | '^' | '$') value rest
//             | address [sign] ('#' | '[' | function) rest
//   value     = [sign] (digit | '.' | '#' | '[' | function)
//
// The rest of the block is that of all letter-address programs.
#include "grammar/x3/rs274.hpp"

#include <algorithm>

#include "grammar/x3/letter_address.hpp"
#include "grammar/x3/squeezed.hpp"

namespace gonogo::grammar::rs274 {
namespace {

using namespace x3;  // the vocabulary of the dialect grammars

constexpr Letters kCase = Letters::any_case;
constexpr char kOWord[] = "o-word";
constexpr char kPolarWord[] = "polar-word";
constexpr char kSpindleWord[] = "spindle-word";
// Functions whose value may stand for a number without brackets round it.
constexpr std::array<std::string_view, 14> kFunctions{"ABS", "ACOS", "ASIN", "ATAN",  "COS",
                                                      "EXP", "FIX",  "FUP",  "LN",    "ROUND",
                                                      "SIN", "SQRT", "TAN",  "EXISTS"};

// NGC-COM-05: digits, or twice digits with a point between.
struct LineNumber : spirit::parser<LineNumber> {
  using attribute_type = Decimal;
  static constexpr bool has_attribute = true;

  template <typename Context, typename RuleContext>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Decimal& value) const {
    Iterator end = digits_end(first, last);
    if (end == first) return false;
    const bool has_second = last - end > 1 && *end == '.' && kDigit.contains(end[1]);
    if (has_second) end = digits_end(end + 1, last);
    first = read_decimal(first, end, value);
    return true;
  }

 private:
  static Iterator digits_end(Iterator first, Iterator last) {
    while (first != last && kDigit.contains(*first)) ++first;
    return first;
  }
};

// NGC-COM-06: O and a number alone name the program; with anything else they are an O word. Takes
// nothing.
struct NameAhead : spirit::parser<NameAhead> {
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    if (first == last || capital_of(*first) != 'O') return false;
    const Iterator number_end =
        std::find_if_not(first + 1, last, [](char byte) { return kDigit.contains(byte); });
    if (number_end == first + 1) return false;
    const Iterator end = behind_comments(number_end, last);
    return end == last || *end == ';';
  }

 private:
  static Iterator behind_comments(Iterator first, Iterator last) {
    while (first != last && *first == '(') {
      const Iterator close = std::find(first, last, ')');
      if (close == last) return first;
      first = close + 1;
    }
    return first;
  }
};

// NGC-COM-07: a line that is ';' alone has no comment and is not blank.
struct Semicolon : spirit::parser<Semicolon> {
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    if (first == last || *first != ';') return false;
    Target& into = target(context);
    into.block.line_comment.span = into.span(first, last);
    ++first;
    return true;
  }
};

constexpr auto line_number = rule<struct LineNumberId, Decimal>{"whole-number"} = LineNumber{};
constexpr auto tape_mark_end = rule<struct TapeMarkEndId>{"tape-mark-end"} = spirit::eoi;

// clang-format off
constexpr auto tape_mark = flag<&Block::tape_mark>[sole<'%'>] >> expect[tape_mark_end];

constexpr auto text_to_end =
    Semicolon{} >> -append<&Block::comments>[RestOfLine{} >> attr(true)];

constexpr auto function_value = -sign >> Keyword<kFunctions, kCase>{};

constexpr auto item = word_but<kCase>(macro_value | function_value);

// A subroutine, a call or a control statement.
constexpr auto o_word = outside<kOWord>[letter<'O', kCase> >> macro_rest<kCase>];

constexpr auto value_ahead =
    &(-sign >> (digit | sole<'.'> | sole<'#'> | sole<'['> | Keyword<kFunctions, kCase>{}));

// NGC-CYC-17: radius and angle of a point.
constexpr auto polar_word =
    outside<kPolarWord>[(sole<'@'> | sole<'^'>) >> value_ahead >> macro_rest<kCase>];

// NGC-G76-13: which of several spindles.
constexpr auto spindle_word =
    outside<kSpindleWord>[sole<'$'> >> value_ahead >> macro_rest<kCase>];

constexpr auto construct =
      assignment<kCase>
    | o_word
    | polar_word
    | spindle_word
    | macro_word<kCase>
    | outside<kExpression>[address<kCase> >> blanks >> function_value >> macro_rest<kCase>];

constexpr auto head =
    -skip >> -(letter<'N', kCase> >> store<&Block::sequence_number>[expect[line_number]]);

constexpr auto name = letter<'O', kCase>
    >> store<&Block::program_number>[expect[whole]] >> leading_comments >> -text_to_end;

constexpr auto block = head >> leading_comments >> items(item) >> -construct >> -text_to_end
    >> expect[block_end];

constexpr auto line = tape_mark | (&NameAhead{} >> name) | block;
// clang-format on

}  // namespace

std::optional<SyntaxError> parse_line(std::string_view text, Block& into) {
  thread_local Squeezed squeezed;  // keeps its memory
  squeezed.take(text);
  std::optional<SyntaxError> error = read_line<kProgram<kCase>>(line, squeezed.text(), into);
  if (error) {
    error->where = squeezed.unsqueezed(error->where);
    return error;
  }
  const auto unsqueeze = [](Span& span) { span = squeezed.unsqueezed(span); };
  if (into.sequence_number || into.program_number) unsqueeze(into.number_place.span);
  if (into.line_comment.span != Span{}) unsqueeze(into.line_comment.span);
  for (Word& word : into.words) unsqueeze(word.where);
  for (Comment& comment : into.comments) unsqueeze(comment.where);
  if (into.outside) unsqueeze(into.outside->where);
  return std::nullopt;
}

}  // namespace gonogo::grammar::rs274
