// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed intervals whose ends are MPFR numbers, rounded outward. Every operation takes the
// precision in bits of its result and contains every value that its operands allow.
#pragma once

#include <gmpxx.h>
#define MPFR_USE_INTMAX_T
#include <mpfr.h>

#include "reference/exact/root.hpp"

namespace gonogo::exact {

class Interval {
 public:
  explicit Interval(mpfr_prec_t bits);  // ends not yet numbers
  Interval(const Interval& other);
  Interval(Interval&& other) noexcept;
  Interval& operator=(Interval other) noexcept;
  ~Interval();

  mpfr_ptr low() { return low_; }
  mpfr_ptr high() { return high_; }
  mpfr_srcptr low() const { return low_; }
  mpfr_srcptr high() const { return high_; }

  // -1 or 1 when every value has that sign, 0 only when every value is zero, 2 when it is open.
  int sign() const;
  bool bounded() const { return mpfr_number_p(low_) != 0 && mpfr_number_p(high_) != 0; }

 private:
  mpfr_t low_;
  mpfr_t high_;
};

// -1 or 1 when all of a is below or above all of b, 0 when both are one and the same point, 2 when
// they overlap.
int compare(const Interval& a, const Interval& b);
mpq_class rational_end(mpfr_srcptr end);  // REQUIRES: finite

Interval interval_of(const mpq_class& low, const mpq_class& high, mpfr_prec_t bits);
Interval interval_of_millionths(std::int64_t count, mpfr_prec_t bits);
Interval interval_of(const Root& value, mpfr_prec_t bits);

Interval negate(const Interval& x, mpfr_prec_t bits);
Interval add(const Interval& x, const Interval& y, mpfr_prec_t bits);
Interval subtract(const Interval& x, const Interval& y, mpfr_prec_t bits);
Interval multiply(const Interval& x, const Interval& y, mpfr_prec_t bits);
// The whole line where y contains zero.
Interval divide(const Interval& x, const Interval& y, mpfr_prec_t bits);
// The root of the part that is not negative: the value is known to lie there.
Interval sqrt_of(const Interval& x, mpfr_prec_t bits);
// REQUIRES: x is above zero.
Interval root_of(const Interval& x, unsigned long degree, mpfr_prec_t bits);
Interval cos_of_degrees(const Interval& x, mpfr_prec_t bits);
Interval sin_of_degrees(const Interval& x, mpfr_prec_t bits);
Interval atan_in_degrees(const Interval& x, mpfr_prec_t bits);
Interval in_radians(const Interval& x, mpfr_prec_t bits);  // of degrees

}  // namespace gonogo::exact
