// SPDX-License-Identifier: GPL-3.0-or-later
//
// RS274/NGC: values. The terms of a value go to Block::terms in postfix order. Lines come without
// blanks (NGC-COM-04).
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "grammar/x3/letter_address.hpp"
#include "grammar/x3/values.hpp"

namespace gonogo::grammar::rs274 {

using namespace x3;  // the vocabulary of the dialect grammars

// Whether the text goes on with the word, in either case.
inline bool goes_on_with(Iterator first, Iterator last, std::string_view word) {
  return static_cast<std::size_t>(last - first) >= word.size() &&
         std::equal(word.begin(), word.end(), first,
                    [](char wanted, char byte) { return capital_of(byte) == wanted; });
}

struct WordOfTerm {
  std::string_view word;
  TermKind kind;
};

// Takes the first of the words that is there.
template <std::size_t size>
std::optional<TermKind> take_word(Iterator& first, Iterator last, const WordOfTerm (&words)[size]) {
  for (const WordOfTerm& entry : words) {
    if (!goes_on_with(first, last, entry.word)) continue;
    first += entry.word.size();
    return entry.kind;
  }
  return std::nullopt;
}

// NGC-EXP-01: operators from the highest group to the lowest.
inline std::optional<TermKind> read_power(Iterator& first, Iterator last) {
  static constexpr WordOfTerm kWords[] = {{"**", TermKind::power}};
  return take_word(first, last, kWords);
}
inline std::optional<TermKind> read_product(Iterator& first, Iterator last) {
  static constexpr WordOfTerm kWords[] = {
      {"*", TermKind::multiply}, {"/", TermKind::divide}, {"MOD", TermKind::modulo}};
  return take_word(first, last, kWords);
}
inline std::optional<TermKind> read_sum(Iterator& first, Iterator last) {
  static constexpr WordOfTerm kWords[] = {{"+", TermKind::add}, {"-", TermKind::subtract}};
  return take_word(first, last, kWords);
}
inline std::optional<TermKind> read_comparison(Iterator& first, Iterator last) {
  static constexpr WordOfTerm kWords[] = {{"EQ", TermKind::equal},   {"NE", TermKind::not_equal},
                                          {"GT", TermKind::greater}, {"GE", TermKind::not_less},
                                          {"LT", TermKind::less},    {"LE", TermKind::not_greater}};
  return take_word(first, last, kWords);
}
inline std::optional<TermKind> read_logic(Iterator& first, Iterator last) {
  static constexpr WordOfTerm kWords[] = {
      {"AND", TermKind::logic_and}, {"OR", TermKind::logic_or}, {"XOR", TermKind::logic_xor}};
  return take_word(first, last, kWords);
}

// NGC-EXP-03: functions of one value.
inline std::optional<TermKind> read_function(Iterator& first, Iterator last) {
  static constexpr WordOfTerm kWords[] = {
      {"ABS", TermKind::abs}, {"ACOS", TermKind::acos}, {"ASIN", TermKind::asin},
      {"COS", TermKind::cos}, {"EXP", TermKind::exp},   {"FIX", TermKind::fix},
      {"FUP", TermKind::fup}, {"LN", TermKind::ln},     {"ROUND", TermKind::round},
      {"SIN", TermKind::sin}, {"SQRT", TermKind::sqrt}, {"TAN", TermKind::tan}};
  return take_word(first, last, kWords);
}
inline std::optional<TermKind> read_atan(Iterator& first, Iterator last) {
  static constexpr WordOfTerm kWords[] = {{"ATAN", TermKind::atan}};
  return take_word(first, last, kWords);
}
// NGC-EXP-05: a sign before what is no number.
inline std::optional<TermKind> read_sign(Iterator& first, Iterator last) {
  if (last - first < 2 || !kSign.contains(*first)) return std::nullopt;
  if (kDigit.contains(first[1]) || first[1] == '.') return std::nullopt;
  return *first++ == '-' ? TermKind::negate : TermKind::plus;
}
// '#' before a number.
inline std::optional<TermKind> read_hash(Iterator& first, Iterator last) {
  if (last - first < 2 || *first != '#' || first[1] == '<') return std::nullopt;
  ++first;
  return TermKind::numbered;
}

// NGC-PAR-03: <name>, in small letters; empty where there is none.
inline std::string read_name(Iterator& first, Iterator last) {
  if (first == last || *first != '<') return {};
  const Iterator close = std::find(first, last, '>');
  if (close == last) return {};
  std::string name(first + 1, close);
  std::ranges::transform(name, name.begin(), [](char byte) {
    return byte >= 'A' && byte <= 'Z' ? static_cast<char>(byte - 'A' + 'a') : byte;
  });
  if (!name.empty()) first = close + 1;
  return name;
}

// #<name>.
template <TermKind kind>
struct NamedParameter : Silent<NamedParameter<kind>> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    if (last - first < 2 || *first != '#' || first[1] != '<') return false;
    Iterator end = first + 1;
    std::string name = read_name(end, last);
    if (name.empty()) return false;
    Target& into = target(context);
    Term term{kind, {}, into.span(first, end)};
    term.number.magnitude = into.block.names.size();
    into.block.names.push_back(std::move(name));
    into.block.terms.push_back(std::move(term));
    first = end;
    return true;
  }
};

// joined[step]: marks the term of a step that was taken (NGC-EXP-09).
template <typename Subject>
struct Joined : spirit::unary_parser<Subject, Joined<Subject>> {
  using spirit::unary_parser<Subject, Joined>::unary_parser;
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Attribute&) const {
    if (!this->subject.parse(first, last, context, rule, spirit::unused)) return false;
    target(context).block.terms.back().is_joined = true;
    return true;
  }
};
inline constexpr PlainGenerator<Joined> joined{};

inline constexpr auto shallow = rule<struct ShallowId>{"nesting"} = Shallow{};
inline constexpr auto close = rule<struct CloseId>{"closed-brackets"} = sole<']'>;
inline constexpr auto open = rule<struct OpenId>{"bracketed-value"} = &sole<'['>;
inline constexpr auto quotient = rule<struct QuotientId>{"quotient"} = sole<'/'> >> &sole<'['>;
inline constexpr auto exists_name = rule<struct ExistsNameId>{"parameter-name"} =
    NamedParameter<TermKind::exists>{};

inline constexpr rule<struct ValueId> value{"ngc-value"};

// clang-format off
inline constexpr auto power = expect[value] >> *step<read_power>[expect[value]];
inline constexpr auto product = power >> *step<read_product>[power];
inline constexpr auto sum = product >> *step<read_sum>[product];
inline constexpr auto comparison = sum >> *step<read_comparison>[sum];
inline constexpr auto behind_logic =
    product >> *joined[step<read_sum>[product]] >> *step<read_comparison>[sum];
inline constexpr auto logic = comparison >> *step<read_logic>[behind_logic];

inline constexpr auto bracketed =
    sole<'['> >> expect[shallow] >> nest[logic] >> expect[close];

struct ExistsAhead : Silent<ExistsAhead> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    constexpr std::string_view kWord = "EXISTS[";
    if (!goes_on_with(first, last, kWord)) return false;
    first += kWord.size();
    return true;
  }
};

inline constexpr auto function =
      ExistsAhead{} >> expect[exists_name] >> expect[close]
    | step<read_atan>[expect[open] >> bracketed >> expect[quotient] >> bracketed]
    | step<read_function>[expect[open] >> bracketed];

// NGC-PAR-01: '#' before other operators.
inline constexpr auto parameter =
      NamedParameter<TermKind::named>{}
    | step<read_hash>[expect[shallow] >> nest[expect[value]]];

inline constexpr auto value_def =
      Leaf<read_constant>{}
    | &sole<'#'> >> parameter
    | bracketed
    | function
    | step<read_sign>[expect[shallow] >> nest[expect[value]]];
BOOST_SPIRIT_DEFINE(value)
// clang-format on

// The value behind an address: not a number alone.
inline constexpr auto value_ahead = &(-sign >> (sole<'#'> | sole<'['>));

}  // namespace gonogo::grammar::rs274
