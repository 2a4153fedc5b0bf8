// SPDX-License-Identifier: GPL-3.0-or-later
//
// Powers with rational exponents.
#include <gmpxx.h>

#include <numeric>
#include <stdexcept>

#include "reference/exact/enclosure.hpp"
#include "reference/exact/rational.hpp"

namespace gonogo::exact {
namespace {

// The root of that degree where it is rational. REQUIRES: value > 0, in lowest terms.
std::optional<mpq_class> exact_root(const mpq_class& value, unsigned long degree) {
  mpq_class root;
  if (mpz_root(root.get_num_mpz_t(), value.get_num_mpz_t(), degree) == 0 ||
      mpz_root(root.get_den_mpz_t(), value.get_den_mpz_t(), degree) == 0) {
    return std::nullopt;
  }
  return root;
}

mpq_class raised(const mpq_class& value, unsigned long exponent) {
  mpq_class power;
  mpz_pow_ui(power.get_num_mpz_t(), value.get_num_mpz_t(), exponent);
  mpz_pow_ui(power.get_den_mpz_t(), value.get_den_mpz_t(), exponent);
  return power;
}

// Takes roots of `base` for factors of `degree` as long as they are rational.
void take_roots(mpq_class& base, unsigned long& degree) {
  for (unsigned long factor = 2; factor <= degree; ++factor) {
    while (degree % factor == 0) {
      auto root = exact_root(base, factor);
      if (!root) break;
      base = *std::move(root);
      degree /= factor;
    }
  }
}

}  // namespace

Number power(const Number& base, unsigned long numerator, unsigned long denominator) {
  mpq_class value = require_rational(base);
  if (sgn(value) <= 0 || denominator == 0) {
    throw std::domain_error("exact: a power of what is not above zero");
  }
  const unsigned long common = std::gcd(numerator, denominator);
  unsigned long degree = denominator / common;
  take_roots(value, degree);
  Number radicand = number_of(raised(value, numerator / common));
  if (degree == 1) return radicand;
  if (degree == 2) return sqrt(radicand);
  return enclosure(Operation::root, radicand, number_of(mpz_class(degree)));
}

}  // namespace gonogo::exact
