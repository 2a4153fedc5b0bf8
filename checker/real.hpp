// SPDX-License-Identifier: GPL-3.0-or-later
//
// A number as the files write it, and questions about it that are answered exactly or not at all.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>

#include "checker/json.hpp"

namespace gonogo::checker {

using Rational = mpq_class;

// `unknown`: the enclosures are too wide to decide.
enum class Truth { no, yes, unknown };
Truth operator&&(Truth x, Truth y);
Truth operator||(Truth x, Truth y);
Truth operator!(Truth x);

// a + b sqrt(c), or somewhere in [low, high]. Sums and products of roots of different fields
// become enclosures, those within one field stay exact.
class Real {
 public:
  Real() = default;
  Real(Rational value) : a_(std::move(value)) {}  // NOLINT: a rational is a real
  Real(long value) : a_(value) {}                 // NOLINT
  static Real root(Rational a, Rational b, Rational c);
  static Real enclosure(Rational low, Rational high);

  bool is_exact() const { return exact_; }
  bool is_rational() const { return exact_ && b_ == 0; }
  // A root is enclosed to about 2^-256.
  Rational low() const;
  Rational high() const;
  std::string text() const;

  friend Real operator+(const Real& x, const Real& y);
  friend Real operator-(const Real& x, const Real& y);
  friend Real operator*(const Real& x, const Real& y);
  Real operator-() const { return Real() - *this; }
  // Nothing when the divisor may be zero.
  std::optional<Real> over(const Real& divisor) const;

  Truth is_zero() const;
  Truth is_negative() const;
  Truth is_positive() const { return (-*this).is_negative(); }

 private:
  int exact_sign() const;
  // `y` with the radicand of `x`; nothing when the fields differ.
  static std::optional<Rational> common_factor(const Real& x, const Real& y);

  bool exact_ = true;
  Rational a_, b_, c_;   // exact: a + b sqrt(c), c no square, b = 0 when rational
  Rational low_, high_;  // not exact
};

inline Truth at_most(const Real& x, const Real& y) {
  return !(x - y).is_positive();
}
inline Truth equal(const Real& x, const Real& y) {
  return (x - y).is_zero();
}
// abs(x - y) <= limit
Truth within(const Real& x, const Real& y, const Real& limit);

// "12.5", "11/3", "-1e-3", "0x1.8p+1"; throws Fault.
Rational parse_rational(std::string_view text);
// Those, {"root":[a,b,c]} and {"enclosure":[low,high]}; throws Fault, for an enclosure wider than
// 1e-15 too.
Real read_real(const Json& value);

}  // namespace gonogo::checker
