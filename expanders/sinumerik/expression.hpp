// SPDX-License-Identifier: GPL-3.0-or-later
// Values behind `=`: the controller reckons in the longest real of its processor and puts lengths
// down in counts.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "expanders/common/fixed.hpp"
#include "expanders/sinumerik/real.hpp"

namespace gonogo::expanders::sinumerik {

/// The R parameters, R0 to R999.
using Parameters = std::array<Real, 1000>;

/// Brackets nested deeper are refused.
inline constexpr int kDeepestBrackets = 64;

/// Blanks and tabs.
void skip_blanks(const char*& cursor, const char* end);
bool is_digit(char c);
bool is_letter(char c);
/// Letters, digits and the underscore.
bool is_name_part(char c);
char capital(char c);

enum class Scan {
  kRead,
  kSyntax,
  kOutside  ///< something that the control has and this expander does not
};

/// `value` in counts. One that is no whole number of them is marked as finer.
Decimal to_counts(Real value);

/// Reads one expression: numbers, R parameters, + - * /, brackets, SIN COS TAN SQRT ABS.
class Expression {
 public:
  Expression(const char* cursor, const char* end, std::span<const Real> parameters,
             bool left_to_right)
      : cursor_(cursor), end_(end), parameters_(parameters), left_to_right_(left_to_right) {}

  Scan read();
  const char* cursor() const { return cursor_; }
  Real value() const { return value_; }
  /// Whether it has no value: a division by zero, a root of less than 0, a parameter that is none.
  bool undefined() const { return undefined_; }

 private:
  using Step = Scan;
  Step sum(Real& value);
  Step product(Real& value);
  Step signed_operand(Real& value);
  Step operand(Real& value);
  Step number(Real& value);
  Step parameter(Real& value);
  Step brackets(Real& value);
  Step named(Real& value);
  char next_operator();
  Real apply(char sign, Real left, Real right);

  const char* cursor_;
  const char* end_;
  std::span<const Real> parameters_;  // those that the control has
  bool left_to_right_;
  int depth_ = 0;
  Real value_ = 0;
  bool undefined_ = false;
};

/// Reads a whole number without sign at `cursor`; too large ones become `most`.
bool read_index(const char*& cursor, const char* end, std::size_t most, std::size_t& index);

/// Whether an exponent (`EX3`, `EX-3`) follows.
bool at_exponent(const char* cursor, const char* end);

}  // namespace gonogo::expanders::sinumerik
