// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/real.hpp"

#include <algorithm>

namespace gonogo::checker {
namespace {

constexpr unsigned long kRootBits = 256;

// The square root where it is rational.
std::optional<Rational> exact_root(const Rational& value) {
  const mpz_class& above = value.get_num();
  const mpz_class& below = value.get_den();
  if (mpz_perfect_square_p(above.get_mpz_t()) == 0 ||
      mpz_perfect_square_p(below.get_mpz_t()) == 0) {
    return std::nullopt;
  }
  return Rational(sqrt(above), sqrt(below));
}

// sqrt(n/d) = sqrt(n d)/d, rounded down; `ulp` is added to round up.
Rational root_below(const Rational& value, Rational& ulp) {
  mpz_class scaled = value.get_num() * value.get_den();
  mpz_mul_2exp(scaled.get_mpz_t(), scaled.get_mpz_t(), 2 * kRootBits);
  mpz_class scale = value.get_den();
  mpz_mul_2exp(scale.get_mpz_t(), scale.get_mpz_t(), kRootBits);
  ulp = Rational(1, scale);
  ulp.canonicalize();
  Rational root(sqrt(scaled), scale);
  root.canonicalize();
  return root;
}

int sign(const Rational& value) {
  return sgn(value);
}

}  // namespace

Truth operator&&(Truth x, Truth y) {
  if (x == Truth::no || y == Truth::no) return Truth::no;
  return x == Truth::yes && y == Truth::yes ? Truth::yes : Truth::unknown;
}

Truth operator!(Truth x) {
  if (x == Truth::unknown) return x;
  return x == Truth::yes ? Truth::no : Truth::yes;
}

Truth operator||(Truth x, Truth y) {
  return !(!x && !y);
}

Real Real::root(Rational a, Rational b, Rational c) {
  Real value(std::move(a));
  if (const auto rational = exact_root(c)) {
    value.a_ += b * *rational;
  } else if (b != 0) {
    value.b_ = std::move(b);
    value.c_ = std::move(c);
  }
  return value;
}

Real Real::enclosure(Rational low, Rational high) {
  Real value;
  value.exact_ = low == high;
  value.a_ = low;
  value.low_ = std::move(low);
  value.high_ = std::move(high);
  return value;
}

Rational Real::low() const {
  if (!exact_) return low_;
  if (b_ == 0) return a_;
  Rational ulp;
  Rational root = root_below(c_, ulp);
  if (b_ < 0) root += ulp;
  return a_ + b_ * root;
}

Rational Real::high() const {
  if (!exact_) return high_;
  return b_ == 0 ? a_ : Rational(-(-*this).low());
}

std::string Real::text() const {
  if (!exact_) {
    return "[" + low_.get_str() + ", " + high_.get_str() + "]";
  }
  if (b_ == 0) return a_.get_str();
  return a_.get_str() + " + " + b_.get_str() + "*sqrt(" + c_.get_str() + ")";
}

std::optional<Rational> Real::common_factor(const Real& x, const Real& y) {
  if (!x.exact_ || !y.exact_) return std::nullopt;
  if (y.b_ == 0) return Rational(0);
  if (x.b_ == 0) return y.b_;
  const auto ratio = exact_root(Rational(y.c_ / x.c_));
  if (!ratio) return std::nullopt;
  return Rational(y.b_ * *ratio);
}

Real operator+(const Real& x, const Real& y) {
  const auto factor = Real::common_factor(x, y);
  if (!factor) return Real::enclosure(x.low() + y.low(), x.high() + y.high());
  return Real::root(x.a_ + y.a_, x.b_ + *factor, x.b_ == 0 ? y.c_ : x.c_);
}

Real operator-(const Real& x, const Real& y) {
  const auto factor = Real::common_factor(x, y);
  if (!factor) return Real::enclosure(x.low() - y.high(), x.high() - y.low());
  return Real::root(x.a_ - y.a_, x.b_ - *factor, x.b_ == 0 ? y.c_ : x.c_);
}

Real operator*(const Real& x, const Real& y) {
  if (const auto factor = Real::common_factor(x, y)) {
    const Rational& c = x.b_ == 0 ? y.c_ : x.c_;
    return Real::root(x.a_ * y.a_ + x.b_ * *factor * c, x.a_ * *factor + x.b_ * y.a_, c);
  }
  const Rational corners[] = {x.low() * y.low(), x.low() * y.high(), x.high() * y.low(),
                              x.high() * y.high()};
  const auto [least, most] = std::ranges::minmax(corners);
  return Real::enclosure(least, most);
}

std::optional<Real> Real::over(const Real& divisor) const {
  if (divisor.is_zero() != Truth::no) return std::nullopt;
  if (divisor.exact_) {
    // 1/(a + b sqrt c) = (a - b sqrt c)/(a^2 - b^2 c)
    const Rational norm = divisor.a_ * divisor.a_ - divisor.b_ * divisor.b_ * divisor.c_;
    return *this * root(divisor.a_ / norm, -divisor.b_ / norm, divisor.c_);
  }
  return *this * enclosure(1 / divisor.high_, 1 / divisor.low_);
}

int Real::exact_sign() const {
  if (b_ == 0) return sign(a_);
  if (sign(a_) == 0 || sign(a_) == sign(b_)) return sign(b_);
  // The signs differ: the larger of a^2 and b^2 c decides; they are equal for no c without a root.
  return a_ * a_ > b_ * b_ * c_ ? sign(a_) : sign(b_);
}

Truth Real::is_zero() const {
  if (exact_) return exact_sign() == 0 ? Truth::yes : Truth::no;
  return low_ > 0 || high_ < 0 ? Truth::no : Truth::unknown;
}

Truth Real::is_negative() const {
  if (exact_) return exact_sign() < 0 ? Truth::yes : Truth::no;
  if (high_ < 0) return Truth::yes;
  return low_ >= 0 ? Truth::no : Truth::unknown;
}

Truth within(const Real& x, const Real& y, const Real& limit) {
  const Real difference = x - y;
  return at_most(difference, limit) && at_most(-difference, limit);
}

}  // namespace gonogo::checker
