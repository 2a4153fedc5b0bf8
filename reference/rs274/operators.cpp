// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operators and functions of values.
#include <fmt/format.h>

#include <cstdlib>
#include <utility>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/exact/size.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/expression.hpp"
#include "reference/rs274/whole.hpp"

namespace gonogo::reference::rs274 {
namespace {

using grammar::TermKind;

constexpr std::int64_t kMostOfExponent = 1'000;

// NGC-EXP-02: values that differ by less are equal.
const Number kMillionth = Number::millionths(1);
const Number kTenThousandth = Number::millionths(100);

// NGC-EXP-04: the angle of (x, y), from above -180 to 180.
Number signed_angle(const Number& x, const Number& y) {
  Number angle = exact::angle_degrees(x, y);
  return y.sign() < 0 ? angle - Number(360) : angle;
}

// NGC-EXP-04: halves away from zero.
Number rounded(const Number& value) {
  const Number half = Number::millionths(500'000);
  return value.sign() < 0 ? (value - half).ceil() : (value + half).floor();
}

Number raised(Number base, std::int64_t exponent) {
  Number power = 1;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 != 0) power = power * base;
    base = base * base;
  }
  return power;
}

// NGC-EXP-08: 2^32, the inverse of how much calculations with doubles may have rounded, which is
// far more than some ten thousand of them do.
const Number kFarBeyondRounding = std::int64_t{1} << 32;

bool are_near(const Number& left, const Number& right) {
  const Number size = max(max(exact::abs(left), exact::abs(right)), Number(1));
  return exact::abs(left - right) * kFarBeyondRounding <= size;
}

bool is_near_whole(const Number& value) {
  return are_near(value, rounded(value));
}

Number other_leg(const Number& value) {
  return exact::sqrt(Number(1) - value * value);
}

}  // namespace

// NGC-EXP-02
bool Calculator::are_equal(const Number& left, const Number& right) const {
  const Number apart = exact::abs(left - right);
  if (apart < kMillionth) return true;
  if (apart >= kTenThousandth) return false;
  return readings_.is("ngc.equal=ten-thousandth"_reading);
}

bool is_double(const Number& number) {
  constexpr std::int64_t kParts = std::int64_t{1} << 20;  // decimals beyond these count as rounded
  constexpr std::int64_t kMost = std::int64_t{1} << 53;
  if (!number.is_rational()) return false;
  const std::optional<std::int64_t> parts = (number * Number(kParts)).to_int64();
  return parts && std::abs(*parts) <= kMost;
}

// NGC-EXP-08
bool Calculator::is_doubtful(TermKind kind, const Value& left, const Value& right) const {
  if (!left.is_rounded && !right.is_rounded) return false;
  switch (kind) {
    case TermKind::equal:
    case TermKind::not_equal: {
      const Number apart = exact::abs(left.number - right.number);
      return are_near(apart, kMillionth) || are_near(apart, kTenThousandth);
    }
    case TermKind::greater:
    case TermKind::not_less:
    case TermKind::less:
    case TermKind::not_greater:
      return are_near(left.number, right.number);
    case TermKind::logic_and:
    case TermKind::logic_or:
    case TermKind::logic_xor:
      return (left.is_rounded && are_near(left.number, 0)) ||
             (right.is_rounded && are_near(right.number, 0));
    case TermKind::divide:
      return right.is_rounded && are_near(right.number, 0);
    case TermKind::modulo:
      return right.number.sign() != 0 && is_near_whole(left.number / right.number);
    default:
      return false;
  }
}

// NGC-EXP-08
bool Calculator::is_doubtful(TermKind kind, const Value& value) const {
  if (!value.is_rounded) return false;
  switch (kind) {
    case TermKind::fix:
    case TermKind::fup:
      return is_near_whole(value.number);
    case TermKind::round:
      return is_near_whole(value.number + Number::millionths(500'000));
    case TermKind::sqrt:
      return are_near(value.number, 0);
    case TermKind::acos:
    case TermKind::asin:
      return are_near(exact::abs(value.number), 1);
    default:
      return false;
  }
}

bool Calculator::leave_to_doubles(const grammar::Span& where) {
  return leave_out("expression", where,
                   "A control that calculates with doubles may decide otherwise here than the "
                   "exact value does.");
}

// NGC-EXP-02
std::optional<bool> Calculator::is_true(const grammar::Block& block,
                                        const grammar::TermRange& range) {
  const std::optional<Value> condition = calculated(block, range);
  if (!condition) return std::nullopt;
  if (condition->is_rounded && are_near(condition->number, 0)) {
    leave_to_doubles(block.control ? block.control->where : grammar::Span{});
    return std::nullopt;
  }
  return condition->number.sign() != 0;
}

// NGC-EXP-01
bool Calculator::apply_power(const grammar::Term& term, Number& left, const Number& right) {
  const std::optional<std::int64_t> exponent =
      right.is_rational() ? right.to_int64() : std::nullopt;
  if (!exponent || std::abs(*exponent) > kMostOfExponent) {
    return leave_out("**", term.where,
                     "The gauge reads powers with whole exponents, not above a thousand.");
  }
  if (*exponent < 0 && left.sign() == 0) {
    return fail(AlarmClass::value_out_of_range, "NGC-EXP-06"_clause, term.where,
                with_values("The power {} of zero is not defined.", {right}));
  }
  const std::size_t bits = exact::size_of(left).bits;
  const auto times = static_cast<std::size_t>(std::abs(*exponent));
  if (bits * times > 4 * kLongest) {
    return leave_out("expression", term.where,
                     "The exact value has more digits than the gauge keeps.");
  }
  Number power = raised(left, std::abs(*exponent));
  left = *exponent < 0 ? Number(1) / power : std::move(power);
  return true;
}

// Operators of two values.
bool Calculator::apply_two(const grammar::Term& term) {
  const ClauseId clause = "NGC-EXP-06"_clause;
  const Value by = std::move(stack_.back());
  stack_.pop_back();
  if (is_doubtful(term.kind, stack_.back(), by)) return leave_to_doubles(term.where);
  Value& value = stack_.back();
  Number& left = value.number;
  const Number& right = by.number;
  bool is_rounded = value.is_rounded || by.is_rounded;
  switch (term.kind) {
    case TermKind::add:
      left = left + right;
      break;
    case TermKind::subtract:
      left = left - right;
      break;
    case TermKind::multiply:
      left = left * right;
      break;
    case TermKind::divide:
      if (right.sign() == 0) {
        return fail(AlarmClass::value_out_of_range, clause, term.where,
                    with_values("A division of {} by zero.", {left}));
      }
      left = left / right;
      break;
    case TermKind::power:
      if (!apply_power(term, left, right)) return false;
      break;
    case TermKind::modulo: {
      if (right.sign() == 0) return leave_out("MOD", term.where, "No text says what MOD 0 is.");
      // NGC-EXP-04: what is left is not below zero.
      const Number step = exact::abs(right);
      left = left - (left / step).floor() * step;
      break;
    }
    case TermKind::atan:
      if (left.sign() == 0 && right.sign() == 0) {
        return leave_out("ATAN", term.where, "No text says what ATAN[0]/[0] is.");
      }
      left = signed_angle(right, left);
      is_rounded = true;
      break;
    default:
      value = {truth(holds(term.kind, left, right))};
      return true;
  }
  value.is_rounded = is_rounded || !is_double(left);
  return true;
}

// Comparisons and logic: 1 where it holds, else 0.
bool Calculator::holds(TermKind kind, const Number& left, const Number& right) const {
  switch (kind) {
    case TermKind::equal:
      return are_equal(left, right);
    case TermKind::not_equal:
      return !are_equal(left, right);
    case TermKind::greater:
      return left > right;
    case TermKind::not_less:
      return left >= right;
    case TermKind::less:
      return left < right;
    case TermKind::not_greater:
      return left <= right;
    case TermKind::logic_and:
      return left.sign() != 0 && right.sign() != 0;
    case TermKind::logic_or:
      return left.sign() != 0 || right.sign() != 0;
    default:
      return (left.sign() != 0) != (right.sign() != 0);
  }
}

bool Calculator::take_root(const grammar::Term& term) {
  Value& value = stack_.back();
  if (value.number.sign() < 0) {
    fail(AlarmClass::value_out_of_range, "NGC-EXP-06"_clause, term.where,
         with_values("SQRT of {}, which is below zero.", {value.number}));
    alarm->also.add(AlarmClass::value_sign);
    return false;
  }
  value.number = exact::sqrt(value.number);
  value.is_rounded = value.is_rounded || !is_double(value.number);
  return true;
}

// NGC-EXP-03: functions and signs.
bool Calculator::apply_one(const grammar::Term& term) {
  Value& value = stack_.back();
  Number& top = value.number;
  if (is_doubtful(term.kind, value)) return leave_to_doubles(term.where);
  switch (term.kind) {
    case TermKind::negate:
    case TermKind::plus:
      if (readings_.is("ngc.sign-of-value=syntax"_reading)) {
        return fail(AlarmClass::syntax, "NGC-EXP-05"_clause, term.where,
                    "A sign stands before digits alone.");
      }
      if (term.kind == TermKind::negate) top = -top;
      return true;
    case TermKind::abs:
      top = exact::abs(top);
      return true;
    case TermKind::fix:
      value = {top.floor()};
      return true;
    case TermKind::fup:
      value = {top.ceil()};
      return true;
    case TermKind::round:
      value = {rounded(top)};
      return true;
    case TermKind::sqrt:
      return take_root(term);
    case TermKind::sin:
    case TermKind::cos:
      value = {term.kind == TermKind::sin ? exact::sin_degrees(top) : exact::cos_degrees(top),
               true};
      return true;
    case TermKind::tan: {
      const auto [cosine, sine] = exact::cos_sin_degrees(top);
      if (cosine.sign() == 0) {
        return leave_out("TAN", term.where, "No text says what TAN of a right angle is.");
      }
      value = {sine / cosine, true};
      return true;
    }
    case TermKind::acos:
    case TermKind::asin:
      if (exact::abs(top) > Number(1)) {
        return fail(AlarmClass::value_out_of_range, "NGC-EXP-06"_clause, term.where,
                    with_values("No angle has the sine or cosine {}.", {top}));
      }
      value = {term.kind == TermKind::acos ? exact::angle_degrees(top, other_leg(top))
                                           : signed_angle(other_leg(top), top),
               true};
      return true;
    default:
      return leave_out(term.kind == TermKind::ln ? "LN" : "EXP", term.where,
                       "The gauge does not read this function.");
  }
}

}  // namespace gonogo::reference::rs274
