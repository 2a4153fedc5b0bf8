// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rationals behind exact::Number: between the small form, GMP and back. The form is canonical: a
// value that is a 64-bit count of 1e-6 never stands in a node.
#pragma once

#include <gmpxx.h>

#include <optional>

#include "reference/exact/number.hpp"
#include "reference/exact/word.hpp"

namespace gonogo::exact {

// The bound of a number in a record, as it is read; what is written keeps to it where it can.
inline constexpr std::size_t kMostCharacters = 1000;
inline constexpr long kMostExponent = 9999;

struct RationalNode final : Node {
  explicit RationalNode(mpq_class its_value)
      : Node(Number::Form::rational), value(std::move(its_value)) {}
  const mpq_class value;  // lowest terms, not of the small form
};

// count * 1e-6.
mpq_class rational_of_millionths(std::int64_t count);
// The value of a rational number; the reference is to the node's, or to `scratch`.
const mpq_class& rational_of(const Number& value, mpq_class& scratch);
// REQUIRES: value.is_rational().
mpq_class rational_of(const Number& value);
// The same for arguments that callers may get wrong: std::invalid_argument when not rational.
mpq_class require_rational(const Number& value);

// REQUIRES: lowest terms.
Number number_of(mpq_class value);
Number number_of(const mpz_class& value);

mpz_class power_of_ten(unsigned long exponent);
mpz_class floor_of(const mpq_class& value);
mpz_class ceil_of(const mpq_class& value);
// The square root where it is rational. REQUIRES: value >= 0.
std::optional<mpq_class> exact_sqrt(const mpq_class& value);

}  // namespace gonogo::exact
