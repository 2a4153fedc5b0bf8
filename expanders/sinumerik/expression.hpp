// SPDX-License-Identifier: GPL-3.0-or-later
// Values behind `=`: the controller computes in the longest real of its processor and puts lengths
// down in counts.
#pragma once

#include <array>
#include <span>

#include "expanders/sinumerik/geometry.hpp"
#include "expanders/sinumerik/scan.hpp"

namespace gonogo::expanders::sinumerik {

/// The R parameters, R0 to R999.
using Parameters = std::array<Real, 1000>;

/// `value` in counts. One that is no whole number of them is marked as finer.
Decimal to_counts(Real value);

/// Reads one expression: numbers, R parameters, + - * /, brackets, SIN COS TAN SQRT ABS.
class Expression {
 public:
  /// `parameters`: those that the control has. `left_to_right`: all operators bind alike.
  Expression(const char*& cursor, const char* end, std::span<const Real> parameters,
             bool left_to_right)
      : cursor_(cursor), end_(end), parameters_(parameters), left_to_right_(left_to_right) {}

  Scan read() { return chain(value_, true); }
  Real value() const { return value_; }
  /// Whether it has no value: a division by zero, a root of less than 0, a parameter that is none.
  bool undefined() const { return undefined_; }
  /// Whether it is more than a number that is written there: rounding may have left something.
  bool calculated() const { return calculated_; }

 private:
  Scan chain(Real& value, bool of_products);
  Scan signed_operand(Real& value);
  Scan operand(Real& value);
  Scan number(Real& value);
  Scan parameter(Real& value);
  Scan brackets(Real& value);
  Scan named(Real& value);
  char next_operator();
  Real apply(char sign, Real left, Real right);
  Real called(std::string_view name, Real value);

  const char*& cursor_;
  const char* end_;
  std::span<const Real> parameters_;
  bool left_to_right_;
  int depth_ = 0;
  Real value_ = 0;
  bool undefined_ = false;
  bool calculated_ = false;
};

}  // namespace gonogo::expanders::sinumerik
