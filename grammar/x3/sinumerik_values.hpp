// SPDX-License-Identifier: GPL-3.0-or-later
//
// SINUMERIK: values. The terms of a value go to Block::terms in postfix order.
#pragma once

#include <optional>

#include "grammar/x3/sinumerik_names.hpp"

namespace gonogo::grammar::sinumerik {

// Brackets within each other in a value; it bounds the recursion of the grammar.
inline constexpr std::size_t kDeepestNesting = 64;

// AC or IC before its bracket.
inline std::optional<Dimension> dimension_at(Iterator& first, Iterator last) {
  const std::string_view name = name_at(first, last);
  if (name.empty()) return std::nullopt;
  const std::size_t place = place_of(name, kDimensions);
  if (place == kDimensions.size()) return std::nullopt;
  first += name.size();
  return place == 0 ? Dimension::absolute : Dimension::incremental;
}

// The letters that a machine may give to an axis: all that have no other meaning.
inline constexpr ByteSet kAxisLetters{"ABCEOQUVWXYZ"};

// AC and IC belong to end points, centres, intermediate points and the polar angle.
inline bool takes_dimension(const NamedWord& word) {
  if (word.name == "AP") return true;
  if (word.name.size() != 1) return false;
  const char letter = word.name[0];
  const bool centre = letter == 'I' || letter == 'J' || letter == 'K';
  if (word.index) return centre || kAxisLetters.contains(letter);
  return centre || kAxisLetters.contains(letter);
}

// AC or IC where they may stand.
struct OwnDimension : Silent<OwnDimension> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    if (!takes_dimension(current(context))) return false;
    const std::optional<Dimension> dimension = dimension_at(first, last);
    if (!dimension) return false;
    current(context).dimension = *dimension;
    return true;
  }
};

// A number with its sign, if any, and an R parameter: terms that `read` takes from the text. It
// returns the end of the term, or null when there is none.
using ReadTerm = Iterator (*)(Iterator first, Iterator last, Term& term);

template <ReadTerm read>
struct Leaf : Silent<Leaf<read>> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext&,
             Attribute&) const {
    Term term;
    const Iterator end = read(first, last, term);
    if (end == nullptr) return false;
    term.where = target(context).span(first, end);
    target(context).block.terms.push_back(std::move(term));
    first = end;
    return true;
  }
};

// As it follows an address: the sign stands at its digits.
inline Iterator read_constant(Iterator first, Iterator last, Term& term) {
  return read_decimal(first, last, term.number);
}

// As an operand: the sign may stand apart.
inline Iterator read_signed(Iterator first, Iterator last, Term& term) {
  bool negative = false;
  if (first != last && kSign.contains(*first)) {
    negative = *first == '-';
    first = skip_blanks(first + 1, last);
  }
  if (first == last || kSign.contains(*first)) return nullptr;
  const Iterator end = read_decimal(first, last, term.number);
  term.number.negative = negative;
  return end;
}

inline Iterator read_parameter(Iterator first, Iterator last, Term& term) {
  if (first == last || capital_of(*first) != 'R') return nullptr;
  term.kind = TermKind::parameter;
  return read_whole(skip_blanks(first + 1, last), last, term.number);
}

// The exponent that stands at a number: EX5, EX-5.
struct ExponentAhead : Silent<ExponentAhead> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context&, RuleContext&,
             Attribute&) const {
    if (last - first < 3 || capital_of(first[0]) != 'E' || capital_of(first[1]) != 'X') {
      return false;
    }
    const Iterator digits = first + (kSign.contains(first[2]) ? 3 : 2);
    return digits != last && kDigit.contains(*digits);
  }
};

// step<read>[operand]: an operator or a function and its operand, in postfix order. `read` takes
// the operator and says which step it is; the operand is expected.
using ReadStep = std::optional<TermKind> (*)(Iterator& first, Iterator last);

template <typename Subject, auto read>
struct Step : spirit::unary_parser<Subject, Step<Subject, read>> {
  using spirit::unary_parser<Subject, Step>::unary_parser;
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Attribute&) const {
    Target& into = target(context);
    const Iterator begin = first;
    const std::optional<TermKind> kind = read(first, last);
    if (!kind) return false;
    const Span where = into.span(begin, first);
    first = skip_blanks(first, last);
    if (!this->subject.parse(first, last, context, rule, spirit::unused)) {
      first = begin;
      return false;
    }
    into.block.terms.push_back({*kind, {}, where});
    return true;
  }
};

template <ReadStep read>
inline constexpr DirectiveGenerator<Step, read> step{};

inline std::optional<TermKind> read_either(Iterator& first, Iterator last, char one,
                                           TermKind of_one, char other, TermKind of_other) {
  if (first == last || (*first != one && *first != other)) return std::nullopt;
  return *first++ == one ? of_one : of_other;
}
inline std::optional<TermKind> read_sum(Iterator& first, Iterator last) {
  return read_either(first, last, '+', TermKind::add, '-', TermKind::subtract);
}
inline std::optional<TermKind> read_product(Iterator& first, Iterator last) {
  return read_either(first, last, '*', TermKind::multiply, '/', TermKind::divide);
}
inline std::optional<TermKind> read_minus(Iterator& first, Iterator last) {
  return read_either(first, last, '-', TermKind::negate, '-', TermKind::negate);
}
inline std::optional<TermKind> read_function(Iterator& first, Iterator last) {
  constexpr std::array<TermKind, kFunctions.size()> kKinds{
      TermKind::sin, TermKind::cos, TermKind::tan, TermKind::sqrt, TermKind::abs};
  const std::string_view name = name_at(first, last);
  if (name.empty()) return std::nullopt;
  const std::size_t place = place_of(name, kFunctions);
  if (place == kFunctions.size()) return std::nullopt;
  first += name.size();
  return kKinds[place];
}

// Whether there is still room for a bracket, which nest[] counts.
struct Shallow : Silent<Shallow> {
  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator&, const Iterator&, const Context& context, RuleContext&, Attribute&) const {
    return target(context).brackets < kDeepestNesting;
  }
};

// nest[subject]: counts the brackets that are open.
template <typename Subject>
struct Nest : spirit::unary_parser<Subject, Nest<Subject>> {
  using spirit::unary_parser<Subject, Nest>::unary_parser;
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;

  template <typename Context, typename RuleContext, typename Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule,
             Attribute&) const {
    ++target(context).brackets;
    const bool met = this->subject.parse(first, last, context, rule, spirit::unused);
    --target(context).brackets;
    return met;
  }
};

template <template <typename> typename Directive>
struct PlainGenerator {
  template <typename Subject>
  constexpr auto operator[](const Subject& subject) const {
    using Parser = typename spirit::extension::as_parser<Subject>::value_type;
    return Directive<Parser>(spirit::as_parser(subject));
  }
};

inline constexpr PlainGenerator<Nest> nest{};

}  // namespace gonogo::grammar::sinumerik
