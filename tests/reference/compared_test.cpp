// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/compared.hpp"

#include <gtest/gtest.h>

namespace gonogo::reference {
namespace {

using exact::Number;

Number number(const char* text) {
  return Number::parse(text).value();
}

TEST(Compared, DecimalsStandAsTheyAre) {
  EXPECT_EQ(with_values("{} and {}.", {number("22"), number("-0.0125")}), "22 and -0.0125.");
}

// 11/3 = 3.6666..., the root of 2 = 1.41421...
TEST(Compared, OtherNumbersAreRounded) {
  EXPECT_EQ(with_values("{}, {}", {number("11/3"), Number::root(0, 1, 2)}),
            "about 3.6667, about 1.4142");
}

// 2/3 less 1e-7 is 0.66666656...; at four decimals both are 0.6667.
TEST(Compared, ValuesThatDifferHaveTextsThatDiffer) {
  EXPECT_EQ(with_values("{} > {}", {number("2/3"), number("2/3") - number("1e-7")}),
            "about 0.66666667 > about 0.66666657");
  // 2000101/3000000 = 0.66670033...
  EXPECT_EQ(with_values("{} < {}", {number("0.6667"), number("2000101/3000000")}),
            "0.6667 < about 0.66670033");
  // The root of 2 is 1.41421356...; the decimal beside it is rounded to as many places, too.
  EXPECT_EQ(with_values("{} for {}", {number("1.414215"), Number::root(0, 1, 2)}),
            "1.414215 for about 1.41421356");
}

}  // namespace
}  // namespace gonogo::reference
