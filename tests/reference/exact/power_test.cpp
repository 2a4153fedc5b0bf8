// SPDX-License-Identifier: GPL-3.0-or-later
//
// Powers with rational exponents.
#include <gtest/gtest.h>

#include <stdexcept>

#include "exact_testing.hpp"

namespace gonogo::exact {
namespace {

using namespace testing;

TEST(Power, OfWholeExponentsIsRational) {
  EXPECT_EQ(power(num("3/2"), 4), num("81/16"));
  EXPECT_EQ(power(2, 100), num("1267650600228229401496703205376"));
  EXPECT_EQ(power(num("0.1"), 3), num("0.001"));
  EXPECT_EQ(power(7, 0), Number(1));
}

TEST(Power, OfPerfectPowersIsRational) {
  EXPECT_EQ(power(8, 2, 3), Number(4));
  EXPECT_EQ(power(num("27/8"), 1, 3), num("3/2"));
  EXPECT_EQ(power(1, 5, 9'999), Number(1));
  EXPECT_EQ(power(32, 4, 10), Number(4));
  EXPECT_TRUE(power(num("1.024"), 3, 10).form() == Number::Form::enclosure);
}

TEST(Power, OfHalvesIsARoot) {
  EXPECT_EQ(power(2, 1, 2), Number::root(0, 1, 2));
  EXPECT_EQ(power(2, 3, 2), Number::root(0, 2, 2));
  EXPECT_EQ(power(9, 1, 4), Number::root(0, 1, 3));   // the fourth root of 3^2
  EXPECT_EQ(power(27, 1, 6), Number::root(0, 1, 3));  // the sixth root of 3^3
  EXPECT_EQ(power(num("1/2"), 2, 4), Number::root(0, num("1/2"), 2));
}

// 2^(1/3) to forty places, from its cube: 1.2599210498948731647672106072782283505702 and one more
// unit of the last place have cubes below and above 2.
TEST(Power, OfOthersIsEnclosedAsCloselyAsWanted) {
  const Number low = num("1.2599210498948731647672106072782283505702");
  const Number unit = num("1e-40");
  ASSERT_LT(power(low, 3), Number(2));
  ASSERT_GT(power(low + unit, 3), Number(2));
  const Number root = power(2, 1, 3);
  EXPECT_GT(root, low);
  EXPECT_LT(root, low + unit);
  const auto [below, above] = root.bounds(500);
  EXPECT_LE(power(below, 3), Number(2));
  EXPECT_GE(power(above, 3), Number(2));
  EXPECT_LE(above - below, Number::binary(1, -500));
}

TEST(Power, OfABaseBelowOne) {
  const auto [below, above] = power(num("0.3"), 7, 5).bounds(200);
  EXPECT_LE(power(below, 5), power(num("0.3"), 7));
  EXPECT_GE(power(above, 5), power(num("0.3"), 7));
}

TEST(Power, IsComparedWithARationalHoweverClose) {
  // 10^(1/3) against the fraction above it whose cube is 10 and 1e-30, about.
  const Number near = num("2.154434690031883721759293566519350495259");
  EXPECT_NE(power(10, 1, 3), near);
  EXPECT_EQ(power(10, 1, 3) < near, Number(10) < power(near, 3));
}

TEST(Power, TwoOfOneExpressionAreEqual) {
  EXPECT_EQ(power(5, 2, 3), power(5, 4, 6));
  EXPECT_EQ(power(5, 2, 3) - power(5, 2, 3), Number(0));
}

TEST(Power, OfWhatIsNotAboveZeroIsAnError) {
  EXPECT_THROW(power(0, 1, 3), std::domain_error);
  EXPECT_THROW(power(-8, 1, 3), std::domain_error);
  EXPECT_THROW(power(2, 1, 0), std::domain_error);
  EXPECT_THROW(power(Number::root(0, 1, 2), 1, 3), std::invalid_argument);
}

}  // namespace
}  // namespace gonogo::exact
