// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dialects of SINUMERIK, which differ in their codes and not in their text. Letters stand in
// either case.
//
//   line      = blanks (tape-mark | head item*) [';' text]
//   tape-mark = '%' name of the program
//   head      = ['/' [digit]] [N whole | ':' whole] [name ':']
//   item      = letter number | letter [whole] '=' value | L whole '=' value | R whole '=' value
//             | name | name '=' value | name '(' arguments ')' | construct
//   value     = sum | (AC | IC) '(' sum ')'
//   sum       = product (('+' | '-') product)*
//   product   = operand (('*' | '/') operand)*
//   operand   = [sign] (number | R whole | '(' sum ')' | function '(' sum ')')
//   construct = control word rest | '$' rest | name '[' rest | ...
//
// A name has two letters at least and goes on as far as it can: CIPX10 is one, but X10Y20 are two
// items. Blanks may stand behind a letter and round '=', operators and brackets; so may '&' and
// what is not printed, which count as blanks outside of strings and comments.
//
// The grammar only knows that what the gauge does not read is there. From where it begins a
// line need only be free of bytes that no program has and close its strings. Its word is not kept.
#include "grammar/x3/sinumerik.hpp"

#include <algorithm>
#include <string>

#include "grammar/x3/sinumerik_words.hpp"

namespace gonogo::grammar::sinumerik {
namespace {

constexpr auto program_name_end = rule<struct ProgramNameEndId>{"program-name-end"} = spirit::eoi;
constexpr auto word_end = rule<struct WordEndId>{"word-end"} = spirit::eoi;
constexpr auto colon_number = rule<struct ColonNumberId, Decimal>{"colon-number"} =
    Number<NumberForm::whole>{};
constexpr auto code_number = rule<struct CodeNumberId>{"number"} = Leaf<read_constant>{};
constexpr auto constant = rule<struct ConstantId>{"number-or-equals"} = Leaf<read_constant>{};
constexpr auto index = rule<struct IndexId>{"whole-number"} = Index{};
constexpr auto digits = rule<struct DigitsId>{"whole-number"} = &digit;
constexpr auto equals = rule<struct EqualsId>{"equals"} = Equals{};
constexpr auto parameter_equals = rule<struct ParameterEqualsId>{"parameter-equals"} = Equals{};
constexpr auto open = rule<struct OpenId>{"open-bracket"} = &sole<'('>;
constexpr auto shallow = rule<struct ShallowId>{"nesting"} = Shallow{};
constexpr auto close_quote = rule<struct CloseQuoteId>{"close-quote"} = sole<'"'>;
// Behind an outside construct there is nothing left to close.
constexpr auto close = rule<struct CloseId>{"close-bracket"} = sole<')'> | Noted{};

// clang-format off
constexpr auto string = sole<'"'> >> ManyOf<kNoQuote>{} >> expect[close_quote];
constexpr auto rest = *(SomeOf<kRest>{} | string);

constexpr auto exponent = outside<kExpression>[ExponentAhead{} >> rest];

constexpr rule<struct SumId> sum{"sum"};

constexpr auto nested =
    &sole<'('> >> expect[shallow] >> nest[sole<'('> >> blanks >> sum >> expect[close]];

// AC and IC are the whole of a value or out of place.
constexpr auto own_value = rule<struct OwnValueId>{"own-value"} = !NameOf<kDimensions>{};

// Strings, variables and functions of the language that are not read.
constexpr auto outside_operand =
      outside<kString>[&sole<'"'> >> rest]
    | outside<kVariable>[sole<'$'> >> rest]
    | outside<kExpression>[sole<'\''> >> rest]
    | outside<kExpression>[letter<'R', Letters::any_case> >> blanks >> sole<'['> >> rest]
    | outside<kExpression>[SomeName{} >> blanks >> sole<'('> >> rest]
    | outside<kVariable>[SomeName{} >> rest];

constexpr auto function = step<read_function>[expect[open] >> nested];

constexpr auto primary =
      Leaf<read_parameter>{}
    | nested
    | function
    | expect[own_value] >> outside_operand
    | letter<'R', Letters::any_case> >> blanks >> expect[digits];

constexpr auto unsigned_operand = rule<struct UnsignedOperandId>{"value"} = primary;

constexpr auto signed_operand =
      Leaf<read_signed>{} >> -exponent
    | step<read_minus>[expect[unsigned_operand]]
    | sole<'+'> >> blanks >> expect[unsigned_operand]
    | primary;

constexpr auto operand = rule<struct OperandId>{"value"} = signed_operand;

constexpr auto product =
    expect[operand] >> blanks >> *(step<read_product>[expect[operand] >> blanks]);

// Comparisons and the operators with names.
constexpr auto outside_operator = outside<kExpression>[
    (sole<'<'> | sole<'>'> | sole<'='> >> sole<'='> | NameOf<kOperators>{}) >> rest];

constexpr auto sum_def = product >> *(step<read_sum>[product]) >> -outside_operator;
BOOST_SPIRIT_DEFINE(sum)

// SIE-LEX-01: '=' before an expression.
constexpr auto value = blanks >> (OwnDimension{} >> blanks >> expect[open] >> nested | sum);

constexpr auto element = outside<kVariable>[sole<'['> >> rest];

// G1, L10: no '=', but L1=5 is an address of the machine.
constexpr auto code =
    LetterName<kCode>{} >> blanks >>
    (element
     | NumberedLAhead{} >> Index{} >> blanks >> Equals{} >> value
     | expect[code_number] >> -exponent);

constexpr auto plain =
    LetterName<kPlainAddress>{} >> blanks >>
    (IndexAhead{} >> Index{} >> blanks >> Equals{} >> value
     | Equals{} >> value
     | element
     | expect[constant] >> -exponent);

// SIE-LEX-01: an R parameter outside a value is assigned to.
constexpr auto parameter =
    LetterName<kParameter>{} >> blanks >>
    (outside<kExpression>[(sole<'['> | sole<'='>) >> rest]
     | expect[index] >> blanks >> expect[parameter_equals] >> value);

// SIE-LEX-01: '=' behind an address of several letters.
constexpr auto named_address =
    NamedAddress<kNamedAddresses>{} >> blanks >> expect[equals] >> value;

// RPL45 is left to a reading of the 802S.
constexpr auto rotation =
    NamedAddress<kRotations>{} >> blanks >> -(Equals{} >> value | Leaf<read_constant>{} >> -exponent);

constexpr auto control = outside<kControl>[NameOf<kControlWords>{} >> rest];

constexpr auto call =
    Call{} >> *(Arguments{} | string) >> expect[close];

constexpr auto name = AnyName{} >> blanks >> -(Equals{} >> value | call | element);

constexpr auto item = word_item[
      plain | code | parameter
    | control | named_address | rotation | name
    | outside<kVariable>[sole<'$'> >> rest]];

constexpr auto tape_mark =
    flag<&Block::tape_mark>[sole<'%'>] >> ManyOf<kProgramName>{} >> -line_comment
    >> expect[program_name_end];

constexpr auto number_word =
      sequence_number<Letters::any_case>
    | sole<':'> >> blanks >> store<&Block::sequence_number>[expect[colon_number]];

constexpr auto head =
    -(flag<&Block::skip>[sole<'/'>] >> -digit >> blanks) >> -(NumberAhead{} >> number_word >> blanks)
    >> -(SomeName{} >> sole<':'> >> blanks);

constexpr auto line =
    blanks >> (tape_mark | head >> *(item >> blanks) >> -line_comment >> expect[word_end]);
// clang-format on

bool is_other_blank(char byte) {
  return kOtherBlank.contains(byte);
}

// SIE-LEX-01: the same line with blanks in their place.
std::string with_blanks(std::string_view text, Block& into) {
  std::string blanked(text);
  bool in_string = false;
  for (std::size_t i = 0; i < text.size() && (in_string || text[i] != ';'); ++i) {
    if (text[i] == '"') in_string = !in_string;
    if (in_string || !is_other_blank(text[i])) continue;
    blanked[i] = ' ';
    const auto at = static_cast<std::uint32_t>(i);
    if (into.other_blank.span.end == 0) into.other_blank.span = {at, at + 1};
  }
  return blanked;
}

}  // namespace

std::optional<SyntaxError> parse_line(std::string_view text, Block& into) {
  if (std::ranges::none_of(text, is_other_blank)) {
    return read_line<kSinumerikProgram>(line, text, into);
  }
  return read_line<kSinumerikProgram>(line, with_blanks(text, into), into);
}

}  // namespace gonogo::grammar::sinumerik
