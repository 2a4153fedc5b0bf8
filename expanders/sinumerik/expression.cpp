// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/expression.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace gonogo::expanders::sinumerik {

Decimal to_counts(Real value) {
  Decimal number;
  constexpr Fixed kMostWhole = kLargest / kOne;
  constexpr auto kMostAsReal = static_cast<Real>(kMostWhole);
  if (!(std::fabs(value) <= kMostAsReal)) {
    number.overflow = true;
    return number;
  }
  const Real counts = value * static_cast<Real>(kOne);
  number.value = std::llround(counts);
  const Real rest = std::fabs(counts - static_cast<Real>(number.value));
  number.finer = rest > 1e-3L + 1e-18L * std::fabs(counts);
  return number;
}

// The operator that follows, or 0.
char Expression::next_operator() {
  skip_blanks(cursor_, end_);
  if (cursor_ == end_) return 0;
  const char c = *cursor_;
  return c == '+' || c == '-' || c == '*' || c == '/' ? c : '\0';
}

Real Expression::apply(char sign, Real left, Real right) {
  calculated_ = true;
  switch (sign) {
    case '+':
      return left + right;
    case '-':
      return left - right;
    case '*':
      return left * right;
    default:
      if (right != 0) return left / right;
      undefined_ = true;
      return 0;
  }
}

// Sums of products; fault: all operators bind alike.
Scan Expression::chain(Real& value, bool of_products) {
  const auto operand = [&](Real& one) {
    return of_products && !left_to_right_ ? chain(one, false) : signed_operand(one);
  };
  Scan scan = operand(value);
  while (scan == Scan::kRead) {
    const char sign = next_operator();
    const bool adds = sign == '+' || sign == '-';
    if (sign == 0 || (!left_to_right_ && adds != of_products)) break;
    ++cursor_;
    Real right = 0;
    scan = operand(right);
    if (scan == Scan::kRead) value = apply(sign, value, right);
  }
  return scan;
}

Scan Expression::signed_operand(Real& value) {
  skip_blanks(cursor_, end_);
  const bool negative = cursor_ != end_ && *cursor_ == '-';
  if (negative || (cursor_ != end_ && *cursor_ == '+')) ++cursor_;
  skip_blanks(cursor_, end_);
  const Scan step = operand(value);
  if (negative) value = -value;
  return step;
}

Scan Expression::operand(Real& value) {
  if (cursor_ == end_) return Scan::kSyntax;
  const char c = *cursor_;
  if (is_digit(c) || c == '.') return number(value);
  if (c == '(') return brackets(value);
  if (c == '$' || c == '"') return Scan::kOutside;
  return is_letter(c) ? named(value) : Scan::kSyntax;
}

Scan Expression::number(Real& value) {
  const char* first = cursor_;
  Decimal unused;
  if (!read_decimal(cursor_, end_, unused)) return Scan::kSyntax;
  if (at_exponent(cursor_, end_)) return Scan::kOutside;
  // A number that is beyond all reals has no digits that matter.
  if (std::from_chars(first, cursor_, value, std::chars_format::fixed).ec != std::errc{}) {
    value = unused.overflow ? std::numeric_limits<Real>::infinity() : 0;
  }
  return Scan::kRead;
}

Scan Expression::brackets(Real& value) {
  constexpr int kDeepest = 64;
  if (++depth_ > kDeepest) return Scan::kSyntax;
  ++cursor_;
  const Scan step = chain(value, true);
  --depth_;
  if (step != Scan::kRead) return step;
  skip_blanks(cursor_, end_);
  if (cursor_ == end_ || *cursor_ != ')') return Scan::kSyntax;
  ++cursor_;
  return Scan::kRead;
}

// R parameters.
Scan Expression::parameter(Real& value) {
  ++cursor_;
  skip_blanks(cursor_, end_);
  if (cursor_ != end_ && (*cursor_ == '[' || *cursor_ == '=')) return Scan::kOutside;
  std::size_t index = 0;
  if (!read_index(cursor_, end_, parameters_.size(), index)) return Scan::kSyntax;
  if (index == parameters_.size()) {
    undefined_ = true;
  } else {
    value = parameters_[index];
    calculated_ = true;  // where it was set
  }
  return Scan::kRead;
}

Real Expression::called(std::string_view name, Real value) {
  calculated_ = true;
  if (name == "ABS") return std::fabs(value);
  if (name == "SQRT") {
    undefined_ = undefined_ || value < 0;
    return value < 0 ? 0 : std::sqrt(value);
  }
  constexpr Real kNothing = 1e-15L;
  const Vector direction = direction_of(value);
  if (name == "SIN") return direction.q;
  if (name == "COS") return direction.p;
  return apply('/', direction.q, std::fabs(direction.p) < kNothing ? 0 : direction.p);
}

Scan Expression::named(Real& value) {
  const char* stop = cursor_;
  char name[5] = {};
  std::size_t size = 0;
  for (; stop != end_ && is_letter(*stop); ++stop) {
    if (size < sizeof name) name[size++] = capital(*stop);
  }
  const std::string_view text(name, size);
  if (text == "R") return parameter(value);
  if (text == "AC" || text == "IC") return Scan::kSyntax;
  const bool known =
      text == "SIN" || text == "COS" || text == "TAN" || text == "SQRT" || text == "ABS";
  if (!known || (stop != end_ && is_name_part(*stop))) return Scan::kOutside;
  cursor_ = stop;
  skip_blanks(cursor_, end_);
  if (cursor_ == end_ || *cursor_ != '(') return Scan::kSyntax;
  const Scan step = brackets(value);
  if (step != Scan::kRead) return step;
  value = called(text, value);
  return step;
}

}  // namespace gonogo::expanders::sinumerik
