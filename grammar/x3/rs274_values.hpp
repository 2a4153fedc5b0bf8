// SPDX-License-Identifier: GPL-3.0-or-later
//
// RS274/NGC: values. The terms of a value go to Block::terms in postfix order. Lines come without
// blanks (NGC-COM-04).
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "grammar/rs274_words.hpp"
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

// Takes the first of the words that is there.
template <const auto& words>
std::optional<TermKind> read_word(Iterator& first, Iterator last) {
  for (const WordOfTerm& entry : words) {
    if (!goes_on_with(first, last, entry.word)) continue;
    first += entry.word.size();
    return entry.kind;
  }
  return std::nullopt;
}
inline constexpr auto kAtan = std::to_array<WordOfTerm>({{"ATAN", TermKind::atan}});

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
inline constexpr auto power = expect[value] >> *step<read_word<kPowers>>[expect[value]];
inline constexpr auto product = power >> *step<read_word<kProducts>>[power];
inline constexpr auto sum = product >> *step<read_word<kSums>>[product];
inline constexpr auto comparison = sum >> *step<read_word<kComparisons>>[sum];
inline constexpr auto behind_logic =
    product >> *joined[step<read_word<kSums>>[product]] >> *step<read_word<kComparisons>>[sum];
inline constexpr auto logic = comparison >> *step<read_word<kLogic>>[behind_logic];

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
    | step<read_word<kAtan>>[expect[open] >> bracketed >> expect[quotient] >> bracketed]
    | step<read_word<kFunctionsOfOne>>[expect[open] >> bracketed];

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
