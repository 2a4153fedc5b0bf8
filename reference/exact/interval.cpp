// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/interval.hpp"

#include <utility>

namespace gonogo::exact {
namespace {

// MPFR keeps pi per thread and frees it only on request.
struct CacheGuard {
  CacheGuard() = default;
  CacheGuard(const CacheGuard&) = delete;
  CacheGuard& operator=(const CacheGuard&) = delete;
  ~CacheGuard() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
  void touch() {}
};
thread_local CacheGuard cache_guard;

Interval whole_line(mpfr_prec_t bits) {
  Interval line(bits);
  mpfr_set_inf(line.low(), -1);
  mpfr_set_inf(line.high(), 1);
  return line;
}

Interval half_turn_in_radians(mpfr_prec_t bits) {
  cache_guard.touch();
  Interval pi(bits);
  mpfr_const_pi(pi.low(), MPFR_RNDD);
  mpfr_const_pi(pi.high(), MPFR_RNDU);
  return pi;
}

constexpr unsigned long kHalfTurnInDegrees = 180;

using MpfrOperation = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);

// The hull of the operation on the four pairs of ends; the whole line when one of them is no
// number, such as 0 * infinity.
Interval hull_of_ends(MpfrOperation operation, const Interval& x, const Interval& y,
                      mpfr_prec_t bits) {
  Interval hull(bits);
  Interval candidate(bits);
  bool first = true;
  for (mpfr_srcptr a : {x.low(), x.high()}) {
    for (mpfr_srcptr b : {y.low(), y.high()}) {
      operation(candidate.low(), a, b, MPFR_RNDD);
      operation(candidate.high(), a, b, MPFR_RNDU);
      if (mpfr_nan_p(candidate.low()) != 0) return whole_line(bits);
      if (first || mpfr_less_p(candidate.low(), hull.low()) != 0) {
        mpfr_set(hull.low(), candidate.low(), MPFR_RNDD);
      }
      if (first || mpfr_greater_p(candidate.high(), hull.high()) != 0) {
        mpfr_set(hull.high(), candidate.high(), MPFR_RNDU);
      }
      first = false;
    }
  }
  return hull;
}

// The ends are numbers, none of them below zero.
bool is_not_negative(const Interval& x) {
  return x.bounded() && mpfr_sgn(x.low()) >= 0;
}
bool is_not_positive(const Interval& x) {
  return x.bounded() && mpfr_sgn(x.high()) <= 0;
}

// A product or quotient. Where each operand has a sign, one pair of ends gives its low end, another
// the high. `least` and `most` are the ends of y by which a positive x comes out least and most.
Interval combined(MpfrOperation operation, const Interval& x, const Interval& y, mpfr_srcptr least,
                  mpfr_srcptr most, mpfr_prec_t bits) {
  const bool x_up = is_not_negative(x);
  const bool y_up = is_not_negative(y);
  if ((!x_up && !is_not_positive(x)) || (!y_up && !is_not_positive(y))) {
    return hull_of_ends(operation, x, y, bits);
  }
  Interval result(bits);
  operation(result.low(), y_up ? x.low() : x.high(), x_up ? least : most, MPFR_RNDD);
  operation(result.high(), y_up ? x.high() : x.low(), x_up ? most : least, MPFR_RNDU);
  return result;
}

using Function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

// cos and sin change no faster than their argument: f(middle) +- radius, within [-1, 1]. Needs no
// look at the quadrants.
Interval wave_of_degrees(Function wave, const Interval& degrees, mpfr_prec_t bits) {
  Interval result(bits);
  mpfr_set_si(result.low(), -1, MPFR_RNDD);
  mpfr_set_si(result.high(), 1, MPFR_RNDU);
  const Interval angle = in_radians(degrees, bits);
  if (!angle.bounded()) return result;
  Interval work(bits);
  mpfr_ptr middle = work.low();
  mpfr_ptr radius = work.high();
  mpfr_sub(radius, angle.high(), angle.low(), MPFR_RNDU);
  if (mpfr_cmp_ui(radius, 2) >= 0) return result;
  // The low end itself serves as the middle: it is exact, where a computed middle is rounded.
  mpfr_set(middle, angle.low(), MPFR_RNDD);
  Interval value(bits);
  wave(value.low(), middle, MPFR_RNDD);
  mpfr_set(value.high(), value.low(), MPFR_RNDU);  // rounded down, so at most one step below
  mpfr_nextabove(value.high());
  mpfr_sub(value.low(), value.low(), radius, MPFR_RNDD);
  mpfr_add(value.high(), value.high(), radius, MPFR_RNDU);
  mpfr_max(result.low(), result.low(), value.low(), MPFR_RNDD);
  mpfr_min(result.high(), result.high(), value.high(), MPFR_RNDU);
  return result;
}

}  // namespace

Interval::Interval(mpfr_prec_t bits) {
  mpfr_inits2(bits, low_, high_, nullptr);
}

Interval::Interval(const Interval& other) : Interval(mpfr_get_prec(other.low_)) {
  mpfr_set(low_, other.low_, MPFR_RNDD);
  mpfr_set(high_, other.high_, MPFR_RNDU);
}

// A moved-from interval has no digits to free; it may only be destroyed or assigned.
Interval::Interval(Interval&& other) noexcept {
  low_[0] = std::exchange(other.low_[0], {});
  high_[0] = std::exchange(other.high_[0], {});
}

Interval& Interval::operator=(Interval other) noexcept {
  std::swap(low_[0], other.low_[0]);
  std::swap(high_[0], other.high_[0]);
  return *this;
}

Interval::~Interval() {
  if (low_->_mpfr_d != nullptr) mpfr_clears(low_, high_, nullptr);
}

int Interval::sign() const {
  if (mpfr_sgn(low_) > 0) return 1;
  if (mpfr_sgn(high_) < 0) return -1;
  return mpfr_zero_p(low_) != 0 && mpfr_zero_p(high_) != 0 ? 0 : 2;
}

int compare(const Interval& a, const Interval& b) {
  if (mpfr_less_p(a.high(), b.low()) != 0) return -1;
  if (mpfr_greater_p(a.low(), b.high()) != 0) return 1;
  const bool one_point =
      mpfr_equal_p(a.low(), b.high()) != 0 && mpfr_equal_p(a.high(), b.low()) != 0;
  return one_point ? 0 : 2;
}

mpq_class rational_end(mpfr_srcptr end) {
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), end);
  return value;
}

Interval interval_of(const mpq_class& low, const mpq_class& high, mpfr_prec_t bits) {
  Interval result(bits);
  mpfr_set_q(result.low(), low.get_mpq_t(), MPFR_RNDD);
  mpfr_set_q(result.high(), high.get_mpq_t(), MPFR_RNDU);
  return result;
}

Interval interval_of_millionths(std::int64_t count, mpfr_prec_t bits) {
  constexpr auto kUnit = static_cast<unsigned long>(detail::kUnit);
  Interval result(bits);
  mpfr_set_sj(result.low(), count, MPFR_RNDD);
  mpfr_set_sj(result.high(), count, MPFR_RNDU);
  mpfr_div_ui(result.low(), result.low(), kUnit, MPFR_RNDD);
  mpfr_div_ui(result.high(), result.high(), kUnit, MPFR_RNDU);
  return result;
}

Interval interval_of(const Root& value, mpfr_prec_t bits) {
  const Interval a = interval_of(value.a, value.a, bits);
  if (sgn(value.b) == 0) return a;
  const Interval b = interval_of(value.b, value.b, bits);
  Interval root(bits);
  mpfr_set_z(root.low(), value.c.get_mpz_t(), MPFR_RNDD);
  mpfr_set_z(root.high(), value.c.get_mpz_t(), MPFR_RNDU);
  return add(a, multiply(b, sqrt_of(root, bits), bits), bits);
}

Interval negate(const Interval& x, mpfr_prec_t bits) {
  Interval result(bits);
  mpfr_neg(result.low(), x.high(), MPFR_RNDD);
  mpfr_neg(result.high(), x.low(), MPFR_RNDU);
  return result;
}

Interval add(const Interval& x, const Interval& y, mpfr_prec_t bits) {
  Interval result(bits);
  mpfr_add(result.low(), x.low(), y.low(), MPFR_RNDD);
  mpfr_add(result.high(), x.high(), y.high(), MPFR_RNDU);
  return result;
}

Interval subtract(const Interval& x, const Interval& y, mpfr_prec_t bits) {
  Interval result(bits);
  mpfr_sub(result.low(), x.low(), y.high(), MPFR_RNDD);
  mpfr_sub(result.high(), x.high(), y.low(), MPFR_RNDU);
  return result;
}

Interval multiply(const Interval& x, const Interval& y, mpfr_prec_t bits) {
  return combined(mpfr_mul, x, y, y.low(), y.high(), bits);
}

Interval divide(const Interval& x, const Interval& y, mpfr_prec_t bits) {
  if (mpfr_sgn(y.low()) <= 0 && mpfr_sgn(y.high()) >= 0) return whole_line(bits);
  return combined(mpfr_div, x, y, y.high(), y.low(), bits);
}

Interval sqrt_of(const Interval& x, mpfr_prec_t bits) {
  Interval result(bits);
  if (mpfr_sgn(x.low()) > 0) {
    mpfr_sqrt(result.low(), x.low(), MPFR_RNDD);
  } else {
    mpfr_set_zero(result.low(), 1);
  }
  if (mpfr_sgn(x.high()) > 0) {
    mpfr_sqrt(result.high(), x.high(), MPFR_RNDU);
  } else {
    mpfr_set_zero(result.high(), 1);
  }
  return result;
}

Interval root_of(const Interval& x, unsigned long degree, mpfr_prec_t bits) {
  Interval result(bits);
  mpfr_rootn_ui(result.low(), x.low(), degree, MPFR_RNDD);
  mpfr_rootn_ui(result.high(), x.high(), degree, MPFR_RNDU);
  return result;
}

Interval cos_of_degrees(const Interval& x, mpfr_prec_t bits) {
  return wave_of_degrees(mpfr_cos, x, bits);
}

Interval sin_of_degrees(const Interval& x, mpfr_prec_t bits) {
  return wave_of_degrees(mpfr_sin, x, bits);
}

Interval atan_in_degrees(const Interval& x, mpfr_prec_t bits) {
  Interval angle(bits);
  mpfr_atan(angle.low(), x.low(), MPFR_RNDD);
  mpfr_atan(angle.high(), x.high(), MPFR_RNDU);
  mpfr_mul_ui(angle.low(), angle.low(), kHalfTurnInDegrees, MPFR_RNDD);
  mpfr_mul_ui(angle.high(), angle.high(), kHalfTurnInDegrees, MPFR_RNDU);
  return divide(angle, half_turn_in_radians(bits), bits);
}

Interval in_radians(const Interval& x, mpfr_prec_t bits) {
  Interval result = multiply(x, half_turn_in_radians(bits), bits);
  mpfr_div_ui(result.low(), result.low(), kHalfTurnInDegrees, MPFR_RNDD);
  mpfr_div_ui(result.high(), result.high(), kHalfTurnInDegrees, MPFR_RNDU);
  return result;
}

}  // namespace gonogo::exact
