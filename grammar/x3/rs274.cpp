// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dialect of RS274/NGC. Letters stand in either case. NGC-COM-04: blanks and tabs mean nothing
// outside comments, so the line is read without them.
//
//   line       = tape-mark | name | block
//   tape-mark  = '%'
//   name       = O whole comment* [';' text]
//   block      = ['/'] [N whole ['.' whole]] comment* (control | item* [construct]) [';' text]
//   control    = O label keyword ('[' expression ']')* comment*
//   label      = whole | '<' name '>' | parameter | '[' expression ']'
//   item       = address (number | value) | assignment | comment, an address also @ or ^
//   assignment = '#' (value | '<' name '>') '=' value
//   construct  = O rest | '$' value rest
//
// What a value is rs274_values.hpp says. The rest of the block is that of all letter-address
// programs.
#include "grammar/x3/rs274.hpp"

#include <algorithm>

#include "grammar/x3/letter_address.hpp"
#include "grammar/x3/rs274_values.hpp"
#include "grammar/x3/squeezed.hpp"

namespace gonogo::grammar::rs274 {
namespace {

constexpr Letters kCase = Letters::any_case;
// NGC-POL-01: distance and angle of a point.
constexpr ByteSet kPolar{"@^"};
constexpr ByteSet kNgcAddress = kAddress | kPolar;
constexpr ByteSet kNgcProgram = kProgram<kCase> | kPolar;
constexpr char kOWord[] = "o-word";
constexpr char kSpindleWord[] = "spindle-word";
// Functions whose value may stand for a number without brackets round it.
constexpr std::array<std::string_view, 14> kFunctions{"ABS", "ACOS", "ASIN", "ATAN",  "COS",
                                                      "EXP", "FIX",  "FUP",  "LN",    "ROUND",
                                                      "SIN", "SQRT", "TAN",  "EXISTS"};

Iterator digits_end(Iterator first, Iterator last) {
  return std::find_if_not(first, last, [](char byte) { return kDigit.contains(byte); });
}

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
};

Iterator behind_comments(Iterator first, Iterator last) {
  while (first != last && *first == '(') {
    const Iterator close = std::find(first, last, ')');
    if (close == last) return first;
    first = close + 1;
  }
  return first;
}

// NGC-COM-06: O and a number alone name the program; with anything else they are an O word. Takes
// nothing.
struct NameAhead : Silent<NameAhead> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    if (first == last || capital_of(*first) != 'O') return false;
    const Iterator number_end = digits_end(first + 1, last);
    if (number_end == first + 1) return false;
    const Iterator end = behind_comments(number_end, last);
    return end == last || *end == ';';
  }
};

// NGC-COM-07: a line that is ';' alone has no comment and is not blank.
struct Semicolon : Silent<Semicolon> {
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

constexpr auto assignment_sign = rule<struct AssignmentSignId>{"assignment"} = sole<'='>;
constexpr auto label_value = rule<struct LabelValueId>{"ngc-value"} = value;

constexpr auto function_value = -sign >> Keyword<kFunctions, kCase>{};
constexpr auto calculated_ahead = value_ahead | &function_value;

// The terms that the subject pushes.
template <typename Subject, typename Context, typename RuleContext>
TermRange terms_of(const Subject& subject, Iterator& first, const Iterator& last,
                   const Context& context, RuleContext& rule_context) {
  const std::vector<Term>& terms = target(context).block.terms;
  const auto begin = static_cast<std::uint32_t>(terms.size());
  spirit::as_parser(subject).parse(first, last, context, rule_context, spirit::unused);
  return {begin, static_cast<std::uint32_t>(terms.size()) - begin};
}

// X12.5, X[#1+2].
struct ValuedWord : spirit::parser<ValuedWord> {
  using attribute_type = Word;
  static constexpr bool has_attribute = true;

  template <typename Context, typename RuleContext>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Word& word) const {
    if (first == last || !kNgcAddress.contains(capital_of(*first))) return false;
    word.address = capital_of(*first++);
    Iterator ahead = first;
    if (calculated_ahead.parse(ahead, last, context, rule, spirit::unused)) {
      word.terms = terms_of(expect[value], first, last, context, rule);
      return true;
    }
    return (expect[number]).parse(first, last, context, rule, word.value);
  }
};

// NGC-PAR-02: #1=2, #<name>=2.
struct ParameterSetting : spirit::parser<ParameterSetting> {
  using attribute_type = Assignment;
  static constexpr bool has_attribute = true;

  template <typename Context, typename RuleContext>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Assignment& assignment) const {
    if (first == last || *first != '#') return false;
    ++first;
    assignment.name = read_name(first, last);
    if (assignment.name.empty()) {
      assignment.index = terms_of(expect[value], first, last, context, rule);
    }
    (expect[assignment_sign]).parse(first, last, context, rule, spirit::unused);
    assignment.value = terms_of(expect[value], first, last, context, rule);
    return true;
  }
};

struct ControlWord {
  std::string_view word;
  ControlKind kind;
};
constexpr ControlWord kControls[] = {{"SUB", ControlKind::sub},
                                     {"ENDSUB", ControlKind::endsub},
                                     {"RETURN", ControlKind::return_},
                                     {"CALL", ControlKind::call},
                                     {"IF", ControlKind::if_},
                                     {"ELSEIF", ControlKind::elseif},
                                     {"ELSE", ControlKind::else_},
                                     {"ENDIF", ControlKind::endif},
                                     {"WHILE", ControlKind::while_},
                                     {"ENDWHILE", ControlKind::endwhile},
                                     {"DO", ControlKind::do_},
                                     {"REPEAT", ControlKind::repeat},
                                     {"ENDREPEAT", ControlKind::endrepeat},
                                     {"BREAK", ControlKind::break_},
                                     {"CONTINUE", ControlKind::continue_}};

bool needs_value(ControlKind kind) {
  return kind == ControlKind::if_ || kind == ControlKind::elseif || kind == ControlKind::while_ ||
         kind == ControlKind::repeat;
}
std::size_t most_values(ControlKind kind) {
  if (kind == ControlKind::call) return 30;
  const bool may = kind == ControlKind::return_ || kind == ControlKind::endsub;
  return needs_value(kind) || may ? 1 : 0;
}

Iterator letters_end(Iterator first, Iterator last) {
  return std::find_if_not(first, last, [](char byte) { return kLetter.contains(byte); });
}

const ControlWord* control_at(Iterator first, Iterator last) {
  const auto size = static_cast<std::size_t>(letters_end(first, last) - first);
  for (const ControlWord& entry : kControls) {
    if (entry.word.size() == size && goes_on_with(first, last, entry.word)) return &entry;
  }
  return nullptr;
}

// Behind the brackets that open here; null where they do not close.
Iterator brackets_end(Iterator first, Iterator last) {
  std::size_t open_brackets = 0;
  for (; first != last; ++first) {
    if (*first == '[') ++open_brackets;
    if (*first == ']' && --open_brackets == 0) return first + 1;
  }
  return nullptr;
}

// Behind the label of an O word; null where there is none.
Iterator label_end(Iterator first, Iterator last) {
  while (first != last && *first == '#') ++first;
  if (first == last) return nullptr;
  if (*first == '[') return brackets_end(first, last);
  if (*first == '<') {
    const Iterator close = std::find(first, last, '>');
    return close == last || close == first + 1 ? nullptr : close + 1;
  }
  const Iterator end = digits_end(first, last);
  return end == first ? nullptr : end;
}

// NGC-OWD-08: a line with an O word has nothing else. NGC-OWD-12: no text says what a comment among
// the values of a call does. Takes nothing where it is none.
struct ControlLine : Silent<ControlLine> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Attribute&) const {
    if (first == last || capital_of(*first) != 'O') return false;
    const Iterator begin = first;
    const Iterator behind_label = label_end(first + 1, last);
    const ControlWord* const word =
        behind_label == nullptr ? nullptr : control_at(behind_label, last);
    if (word == nullptr) return false;
    Target& into = target(context);
    Control& control = into.block.control.emplace();
    control.kind = word->kind;
    ++first;
    if (*first == '<') {
      control.label = '<' + read_name(first, last) + '>';
    } else if (kDigit.contains(*first)) {
      control.label = digits(first, behind_label);
    } else {
      control.number = terms_of(expect[label_value], first, last, context, rule);
    }
    first = behind_label + word->word.size();
    if (needs_value(word->kind)) (expect[open]).parse(first, last, context, rule, spirit::unused);
    const std::size_t most = most_values(word->kind);
    while (control.values.size() < most && first != last && *first == '[') {
      control.values.push_back(terms_of(bracketed, first, last, context, rule));
    }
    control.where = into.span(begin, first);
    if (const Iterator behind = behind_comments(first, last);
        word->kind == ControlKind::call && behind != first && behind != last && *behind == '[') {
      into.block.outside =
          OutsideConstruct{kOWord, control.where, "a comment between the values of call"};
      first = last;
    }
    return true;
  }

 private:
  // Without zeros before them.
  static std::string digits(Iterator first, Iterator last) {
    first = std::find_if(first, last - 1, [](char byte) { return byte != '0'; });
    return {first, last};
  }
};

// clang-format off
constexpr auto tape_mark = flag<&Block::tape_mark>[sole<'%'>] >> expect[tape_mark_end];

constexpr auto text_to_end =
    Semicolon{} >> -append<&Block::comments>[RestOfLine{} >> attr(true)];

// What else begins with O.
constexpr auto o_word = outside<kOWord>[letter<'O', kCase> >> macro_rest<kCase>];

constexpr auto value_ahead =
    &(-sign >> (digit | sole<'.'> | sole<'#'> | sole<'['> | Keyword<kFunctions, kCase>{}));

// NGC-G76-13: which of several spindles.
constexpr auto spindle_word =
    outside<kSpindleWord>[sole<'$'> >> value_ahead >> macro_rest<kCase>];

constexpr auto construct = o_word | spindle_word;

constexpr auto ngc_items = *(append<&Block::words>[ValuedWord{}]
    | append<&Block::assignments>[ParameterSetting{}]
    | append<&Block::comments>[comment]);

constexpr auto head =
    -skip >> -(letter<'N', kCase> >> store<&Block::sequence_number>[expect[line_number]]);

constexpr auto name = letter<'O', kCase>
    >> store<&Block::program_number>[expect[whole]] >> leading_comments >> -text_to_end;

constexpr auto block = head >> leading_comments
    >> (ControlLine{} >> leading_comments | ngc_items >> -construct) >> -text_to_end
    >> expect[block_end];

constexpr auto line = tape_mark | (&NameAhead{} >> name) | block;
// clang-format on

}  // namespace

std::optional<SyntaxError> parse_line(std::string_view text, Block& into) {
  thread_local Squeezed squeezed;  // keeps its memory
  squeezed.take(text);
  std::optional<SyntaxError> error = read_line<kNgcProgram>(line, squeezed.text(), into);
  if (error) {
    error->where = squeezed.unsqueezed(error->where);
    return error;
  }
  const auto unsqueeze = [](Span& span) { span = squeezed.unsqueezed(span); };
  if (into.sequence_number || into.program_number) unsqueeze(into.number_place.span);
  if (into.line_comment.span != Span{}) unsqueeze(into.line_comment.span);
  for (Word& word : into.words) unsqueeze(word.where);
  for (Term& term : into.terms) unsqueeze(term.where);
  for (Assignment& assignment : into.assignments) unsqueeze(assignment.where);
  if (into.control) unsqueeze(into.control->where);
  for (Comment& comment : into.comments) unsqueeze(comment.where);
  if (into.outside) unsqueeze(into.outside->where);
  return std::nullopt;
}

}  // namespace gonogo::grammar::rs274
