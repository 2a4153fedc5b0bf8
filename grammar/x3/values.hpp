// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the dialects with calculated values (SINUMERIK, RS274/NGC) have in common: the terms of a
// value go to Block::terms in postfix order, operands before what is done with them.
#pragma once

#include <optional>
#include <utility>

#include "grammar/x3/letter_address.hpp"

namespace gonogo::grammar::x3 {

// Brackets, and signs of rs274, within each other in a value; it bounds the recursion of the
// grammar.
inline constexpr std::size_t kDeepestNesting = 64;

// Parsers without an attribute.
template <typename Self>
struct Silent : spirit::parser<Self> {
  using attribute_type = spirit::unused_type;
  static constexpr bool has_attribute = false;
};

inline Iterator skip_blanks(Iterator first, Iterator last) {
  while (first != last && kBlank.contains(*first)) ++first;
  return first;
}

// Leaf<read>: a term that `read` takes from the text, such as a number or an R parameter. It
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

// A number as it follows an address: the sign stands at its digits.
inline Iterator read_constant(Iterator first, Iterator last, Term& term) {
  return read_decimal(first, last, term.number);
}

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

}  // namespace gonogo::grammar::x3
