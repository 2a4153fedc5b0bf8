// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/rational.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace gonogo::exact {

namespace {

// The count of 1e-6 where the value is one.
std::optional<std::int64_t> small_form(const mpq_class& value) {
  const auto parts = int64_of(value.get_den());
  const auto numerator = int64_of(value.get_num());
  std::int64_t count = 0;
  if (!parts || !numerator || *parts > detail::kUnit || detail::kUnit % *parts != 0 ||
      __builtin_mul_overflow(*numerator, detail::kUnit / *parts, &count)) {
    return std::nullopt;
  }
  return count;
}

Number scaled(mpz_class magnitude, bool negative, std::uint32_t scale) {
  if (negative) mpz_neg(magnitude.get_mpz_t(), magnitude.get_mpz_t());
  mpq_class value(magnitude, power_of_ten(scale));
  value.canonicalize();
  return number_of(std::move(value));
}

}  // namespace

mpq_class rational_of_millionths(std::int64_t count) {
  const std::int64_t common = std::gcd(count % detail::kUnit, detail::kUnit);
  mpq_class value;
  assign(mpq_numref(value.get_mpq_t()), magnitude_of(count / common), count < 0);
  assign(mpq_denref(value.get_mpq_t()), magnitude_of(detail::kUnit / common));
  return value;
}

const mpq_class& rational_of(const Number& value, mpq_class& scratch) {
  if (const Node* node = NumberAccess::node(value)) {
    return static_cast<const RationalNode*>(node)->value;
  }
  scratch = rational_of_millionths(NumberAccess::millionths(value));
  return scratch;
}

mpq_class rational_of(const Number& value) {
  mpq_class scratch;
  return rational_of(value, scratch);
}

mpq_class require_rational(const Number& value) {
  if (!value.is_rational()) throw std::invalid_argument("exact: a rational is required");
  return rational_of(value);
}

Number number_of(mpq_class value) {
  if (const auto count = small_form(value)) return Number::millionths(*count);
  return NumberAccess::adopt(new RationalNode(std::move(value)));
}

Number number_of(const mpz_class& value) {
  return number_of(mpq_class(value));
}

mpz_class power_of_ten(unsigned long exponent) {
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, exponent);
  return power;
}

mpz_class floor_of(const mpq_class& value) {
  mpz_class quotient;
  mpz_fdiv_q(quotient.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return quotient;
}

mpz_class ceil_of(const mpq_class& value) {
  mpz_class quotient;
  mpz_cdiv_q(quotient.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
  return quotient;
}

std::optional<mpq_class> exact_sqrt(const mpq_class& value) {
  // In lowest terms a fraction is a square only when both its terms are.
  if (mpz_perfect_square_p(value.get_num_mpz_t()) == 0 ||
      mpz_perfect_square_p(value.get_den_mpz_t()) == 0) {
    return std::nullopt;
  }
  mpq_class root;
  mpz_sqrt(mpq_numref(root.get_mpq_t()), value.get_num_mpz_t());
  mpz_sqrt(mpq_denref(root.get_mpq_t()), value.get_den_mpz_t());
  return root;
}

Number Number::decimal(bool negative, std::uint64_t magnitude, std::uint32_t scale) {
  while (scale > 6 && magnitude % 10 == 0) {
    if (magnitude == 0) return Number();
    magnitude /= 10;
    --scale;
  }
  std::int64_t count = 0;
  if (scale <= 6) {
    constexpr std::int64_t kToMillionths[] = {1'000'000, 100'000, 10'000, 1'000, 100, 10, 1};
    if (!__builtin_mul_overflow(magnitude, kToMillionths[scale], &count)) {
      return millionths(negative ? -count : count);
    }
  }
  return scaled(integer_of(magnitude), negative, scale);
}

Number Number::decimal(bool negative, std::string_view digits, std::uint32_t scale) {
  const bool only_digits =
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (digits.empty() || !only_digits) throw std::invalid_argument("exact: digits are required");
  return scaled(mpz_class(std::string(digits), 10), negative, scale);
}

Number Number::binary(std::int64_t mantissa, int exponent) {
  mpq_class value(integer_of(mantissa));
  const auto shift = static_cast<mp_bitcnt_t>(std::abs(static_cast<std::int64_t>(exponent)));
  if (exponent >= 0) {
    mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), shift);
  } else {
    mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), shift);
  }
  return number_of(std::move(value));
}

}  // namespace gonogo::exact
