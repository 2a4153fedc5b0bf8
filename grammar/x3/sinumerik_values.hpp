// SPDX-License-Identifier: GPL-3.0-or-later
//
// SINUMERIK: values. The terms of a value go to Block::terms in postfix order.
#pragma once

#include <optional>

#include "grammar/x3/sinumerik_names.hpp"
#include "grammar/x3/values.hpp"

namespace gonogo::grammar::sinumerik {

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

}  // namespace gonogo::grammar::sinumerik
