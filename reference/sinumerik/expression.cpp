// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIE-PAR-01: R parameters, and the arithmetic of values.
#include "reference/sinumerik/expression.hpp"

#include <fmt/format.h>

#include "reference/compared.hpp"
#include "reference/exact/size.hpp"
#include "reference/words.hpp"

namespace gonogo::reference::sinumerik {
namespace {

using grammar::TermKind;

// Beyond them an exact value is no longer kept: parameters that are multiplied with themselves
// double their digits every time.
constexpr std::size_t kLongest = 65'536;  // bits
constexpr std::size_t kDeepest = 1'000;   // operations on a value that is only enclosed

bool fail(NoValue& problem, const grammar::Term& term, std::string message) {
  problem = {term.where, std::move(message), false};
  return false;
}

bool is_kept(const Number& value, const grammar::Term& term, NoValue& problem) {
  const exact::Size size = exact::size_of(value);
  if (size.bits <= kLongest && size.depth <= kDeepest) return true;
  problem = {term.where, "The exact value has more digits than the gauge keeps.", true};
  return false;
}

}  // namespace

bool Calculator::push_parameter(const grammar::Term& term, NoValue& problem) {
  const grammar::Decimal& number = term.number;
  if (number.scale != 0 || !number.long_digits.empty() || number.magnitude >= count_) {
    return fail(problem, term,
                fmt::format("The R parameters are R0 to R{}, and this is number {}.", count_ - 1,
                            to_number(number).text()));
  }
  stack_.push_back(parameter(number.magnitude));
  return true;
}

bool Calculator::apply_function(const grammar::Term& term, NoValue& problem) {
  Number& top = stack_.back();
  switch (term.kind) {
    case TermKind::negate:
      top = -top;
      return true;
    case TermKind::abs:
      top = exact::abs(top);
      return true;
    case TermKind::sqrt:
      if (top.sign() < 0)
        return fail(problem, term, with_values("SQRT of {}, which is below zero.", {top}));
      top = exact::sqrt(top);
      return true;
    case TermKind::sin:
      top = exact::sin_degrees(top);
      return true;
    case TermKind::cos:
      top = exact::cos_degrees(top);
      return true;
    default: {
      const auto [cosine, sine] = exact::cos_sin_degrees(top);
      if (cosine.sign() == 0)
        return fail(problem, term, with_values("TAN of {} degrees, a right angle.", {top}));
      top = sine / cosine;
      return true;
    }
  }
}

bool Calculator::apply(const grammar::Term& term, NoValue& problem) {
  switch (term.kind) {
    case TermKind::number:
      stack_.push_back(to_number(term.number));
      return true;
    case TermKind::parameter:
      return push_parameter(term, problem);
    case TermKind::add:
    case TermKind::subtract:
    case TermKind::multiply:
    case TermKind::divide:
      break;
    default:
      return apply_function(term, problem) && is_kept(stack_.back(), term, problem);
  }
  const Number right = std::move(stack_.back());
  stack_.pop_back();
  Number& left = stack_.back();
  if (term.kind == TermKind::add) {
    left = left + right;
  } else if (term.kind == TermKind::subtract) {
    left = left - right;
  } else if (term.kind == TermKind::multiply) {
    left = left * right;
  } else {
    if (right.sign() == 0)
      return fail(problem, term, with_values("A division of {} by zero.", {left}));
    left = left / right;
  }
  return is_kept(left, term, problem);
}

std::optional<Number> Calculator::value(const grammar::Block& block, const grammar::NamedWord& word,
                                        NoValue& problem) {
  const grammar::Term* const first = block.terms.data() + word.first_term;
  if (word.terms == 1 && first->kind == TermKind::number) return to_number(first->number);
  stack_.clear();
  for (std::uint32_t i = 0; i < word.terms; ++i) {
    if (!apply(first[i], problem)) return std::nullopt;
  }
  return std::move(stack_.back());
}

}  // namespace gonogo::reference::sinumerik
