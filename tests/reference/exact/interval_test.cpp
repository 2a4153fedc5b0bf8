// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace gonogo::exact {
namespace {

constexpr mpfr_prec_t kBits = 64;

Interval between(int low, int high) {
  return interval_of(mpq_class(low), mpq_class(high), kBits);
}

// Every interval with ends among -2, ..., 2.
std::vector<std::pair<int, int>> small_intervals() {
  std::vector<std::pair<int, int>> all;
  for (int low = -2; low <= 2; ++low) {
    for (int high = low; high <= 2; ++high) all.emplace_back(low, high);
  }
  return all;
}

// The ends of a product are among the products of the ends, for all signs.
TEST(Interval, AProductIsTheHullOfTheProductsOfTheEnds) {
  for (const auto& [a, b] : small_intervals()) {
    for (const auto& [c, d] : small_intervals()) {
      const auto [low, high] = std::minmax({a * c, a * d, b * c, b * d});
      const Interval product = multiply(between(a, b), between(c, d), kBits);
      EXPECT_EQ(rational_end(product.low()), low) << a << b << c << d;
      EXPECT_EQ(rational_end(product.high()), high) << a << b << c << d;
    }
  }
}

// By 1, -1, 2, -2 the quotients have no rounding; by what contains zero nothing is known.
TEST(Interval, AQuotientIsTheHullOfTheQuotientsOfTheEnds) {
  for (const auto& [a, b] : small_intervals()) {
    for (const auto& [c, d] : small_intervals()) {
      const Interval quotient = divide(between(a, b), between(c, d), kBits);
      EXPECT_EQ(quotient.bounded(), c > 0 || d < 0);
      if (!quotient.bounded()) continue;
      const std::initializer_list<mpq_class> ends = {mpq_class(a) / c, mpq_class(a) / d,
                                                     mpq_class(b) / c, mpq_class(b) / d};
      EXPECT_EQ(rational_end(quotient.low()), std::min(ends)) << a << b << c << d;
      EXPECT_EQ(rational_end(quotient.high()), std::max(ends)) << a << b << c << d;
    }
  }
}

TEST(Interval, RoundingIsOutward) {
  const mpq_class third(1, 3);
  for (const int sign : {1, -1}) {
    const Interval quotient = divide(between(sign, sign), between(3, 3), kBits);
    EXPECT_LT(rational_end(quotient.low()), sign * third);
    EXPECT_GT(rational_end(quotient.high()), sign * third);
    const Interval ninth = multiply(quotient, quotient, kBits);
    EXPECT_LT(rational_end(ninth.low()), third * third);
    EXPECT_GT(rational_end(ninth.high()), third * third);
  }
}

TEST(Interval, MillionthsAreTheFraction) {
  for (const std::int64_t count : {std::int64_t{0}, std::int64_t{1}, std::int64_t{-333'333},
                                   std::int64_t{2'500'000}, std::int64_t{-9'999'999'999'999}}) {
    mpq_class fraction(count, 1'000'000);
    fraction.canonicalize();
    const Interval direct = interval_of_millionths(count, kBits);
    const Interval expected = interval_of(fraction, fraction, kBits);
    EXPECT_EQ(rational_end(direct.low()), rational_end(expected.low())) << count;
    EXPECT_EQ(rational_end(direct.high()), rational_end(expected.high())) << count;
  }
}

// 0 times what has no end is no number.
TEST(Interval, AnEndThatIsNoNumberLeavesNothingKnown) {
  const Interval whole_line = divide(between(1, 1), between(-1, 1), kBits);
  EXPECT_FALSE(multiply(between(0, 1), whole_line, kBits).bounded());
  EXPECT_FALSE(multiply(whole_line, between(0, 0), kBits).bounded());
  EXPECT_FALSE(divide(whole_line, between(1, 2), kBits).bounded());
}

}  // namespace
}  // namespace gonogo::exact
