// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <vector>

#include "reference/exact/number.hpp"
#include "tests/reference/exact/exact_testing.hpp"

namespace gonogo::exact {
namespace {

using testing::enclosed;
using testing::num;
using Form = Number::Form;

Number two_roots() {
  return sqrt(Number(2)) + sqrt(Number(3));
}  // 3.14626436994197...

TEST(Enclosure, SignAndOrderShowByRefinement) {
  EXPECT_EQ(two_roots().sign(), 1);
  EXPECT_EQ((-two_roots()).sign(), -1);
  EXPECT_LT(two_roots(), num("3.1462643699419724"));
  EXPECT_GT(two_roots(), num("3.1462643699419723"));
}

// 10^-300 apart: about 1000 bits are needed.
TEST(Enclosure, RefinesFarBeyondTheFirstPrecision) {
  const Number nearly = two_roots() + Number::decimal(false, 1, 300);
  EXPECT_GT(nearly, two_roots());
  EXPECT_EQ((nearly - two_roots()).sign(), 1);
}

// Points on the ray of one degree about (20, 20): their differences are multiples of one direction.
TEST(Enclosure, MultiplesOfOneExpressionAreSeen) {
  const auto [c, s] = cos_sin_degrees(1);
  const Number pole = 20;
  const Number dp = (pole + num("1.001") * c) - (pole + c);
  const Number dq = (pole + num("1.001") * s) - (pole + s);
  EXPECT_EQ(dp, num("0.001") * c);
  EXPECT_EQ((dp * s - dq * c).sign(), 0);
  EXPECT_EQ(dp * (c * -3) - c * (c * num("-0.003")), Number(0));
  EXPECT_EQ((pole + c) * 2 - c - (pole + c), pole);
}

TEST(Enclosure, AProductIsOneInAnyOrder) {
  const auto [c, s] = cos_sin_degrees(7);
  EXPECT_EQ((c * 2) * (s * 3) - s * (c * 6), Number(0));
  EXPECT_EQ(-(c * s) + s * c, Number(0));
}

// A sum of two is no sum of one: the difference stays.
TEST(Enclosure, DifferentExpressionsStayDifferent) {
  const auto [c, s] = cos_sin_degrees(7);
  EXPECT_GT((c + s) - s * 2, Number(0));
  EXPECT_LT(c * c + s * s - num("1.0000000001"), Number(0));
}

// sqrt(5 + 2 sqrt 6) = sqrt 2 + sqrt 3, which no interval can show.
TEST(Enclosure, EqualityOfDifferentExpressionsIsUndecided) {
  const Number nested = sqrt(Number::root(5, 2, 6));
  EXPECT_THROW((void)(nested == two_roots()), Undecided);
  EXPECT_THROW((nested - two_roots()).sign(), Undecided);
}

TEST(Enclosure, TheMagnitudeOfWhatMayBeZeroIsNoLargerThanItsWidth) {
  const Number around = Number::between(Number::millionths(-2), Number::millionths(3));
  EXPECT_LT(abs(around), Number::millionths(4));
  EXPECT_GT(abs(around), Number::millionths(-1));
  const Number below = Number::between(Number::millionths(-3), Number::millionths(-2));
  EXPECT_GT(abs(below), Number::millionths(1));
}

TEST(Enclosure, EqualExpressionsAreEqual) {
  EXPECT_EQ(two_roots(), two_roots());
  EXPECT_EQ(two_roots() - two_roots(), Number(0));
  EXPECT_EQ(two_roots() / two_roots(), Number(1));
  EXPECT_EQ(-(-two_roots()), two_roots());
}

TEST(Enclosure, NeutralOperandsLeaveItAsItIs) {
  EXPECT_TRUE((two_roots() * Number(0)).is_rational());
  EXPECT_TRUE((Number(0) / two_roots()).is_rational());
  EXPECT_EQ(two_roots() + Number(0), two_roots());
  EXPECT_EQ(Number(0) - two_roots(), -two_roots());
  EXPECT_EQ(two_roots() * Number(-1), -two_roots());
  EXPECT_EQ(two_roots() / Number(1), two_roots());
}

// x = sqrt 2 + sqrt 3: x^2 = 5 + 2 sqrt 6, 1/x = sqrt 3 - sqrt 2, x - 1/x = 2 sqrt 2.
TEST(Enclosure, ArithmeticEnclosesTheKnownResults) {
  const Number x = two_roots();
  EXPECT_TRUE(enclosed(x * x, Number::root(5, 2, 6), 500));
  EXPECT_TRUE(enclosed(x - Number(1) / x, Number::root(0, 2, 2), 500));
  EXPECT_TRUE(enclosed(x + Number(1) / x, Number::root(0, 2, 3), 500));
  EXPECT_TRUE(enclosed(x / (x + x), num("0.5"), 500));
  EXPECT_TRUE(enclosed(sqrt(x * x * x * x), Number::root(5, 2, 6), 500));
  EXPECT_TRUE(enclosed(-x * x, Number::root(-5, -2, 6), 500));
}

TEST(Enclosure, FloorAndCeilAreThoseOfTheValue) {
  EXPECT_EQ(two_roots().floor(), Number(3));
  EXPECT_EQ(two_roots().ceil(), Number(4));
  EXPECT_EQ((-two_roots()).floor(), Number(-4));
  EXPECT_EQ(two_roots().to_int64(), std::nullopt);
}

// (sqrt 2 + sqrt 3)(sqrt 3 - sqrt 2) = 1
TEST(Enclosure, FloorOfAHiddenIntegerIsUndecided) {
  const Number one = two_roots() * (sqrt(Number(3)) - sqrt(Number(2)));
  EXPECT_THROW((void)one.floor(), Undecided);
  EXPECT_THROW((void)one.to_int64(), Undecided);
  EXPECT_TRUE(enclosed(one, Number(1), 200));
}

// sqrt 2 + sqrt 3 - sqrt(5 + 2 sqrt 6) = 0, and its intervals reach below zero.
TEST(Enclosure, RootOfAHiddenZeroIsNotAnError) {
  const Number zero = two_roots() - sqrt(Number::root(5, 2, 6));
  EXPECT_TRUE(enclosed(sqrt(zero), Number(0), 100));
  EXPECT_THROW(Number(1) / zero, Undecided);
  EXPECT_THROW(sqrt(-two_roots()), std::domain_error);
}

TEST(Enclosure, BoundsOfLargeAndSmallValuesAreAsCloseAsAskedFor) {
  const Number large = two_roots() * num("1e3000");
  const auto [low, high] = large.bounds(100);
  EXPECT_LE(high - low, Number::binary(1, -100));
  EXPECT_TRUE(enclosed(two_roots() * two_roots() * num("1e-3000"),
                       Number::root(5, 2, 6) * num("1e-3000"), 11'000));
}

TEST(Enclosure, LongChainsNeedNoStack) {
  Number sum = two_roots();
  const int count = 20'000;
  for (int i = 0; i < count; ++i) sum += sqrt(Number(2));
  EXPECT_GT(sum.bounds(140)[0], Number(28'287));  // 20001 sqrt 2 + sqrt 3 = 28287.418...
  EXPECT_LT(sum.bounds(140)[1], Number(28'288));
  sum = Number();  // frees 20,000 nodes one after the other
}

// Each step doubles the number of paths: 2^200 of them, 200 nodes.
TEST(Enclosure, SharedOperandsAreEvaluatedOnce) {
  Number x = two_roots();
  Number y = two_roots();
  for (int i = 0; i < 200; ++i) {
    x += x;
    y += y;
  }
  EXPECT_EQ(x, y);
  EXPECT_TRUE(enclosed(x * x, Number::root(5, 2, 6) * Number::binary(1, 400), 300));
}

TEST(Between, IsRationalOnlyWhenItsEndsAgree) {
  EXPECT_EQ(Number::between(num("0.5"), num("0.5")), num("0.5"));
  EXPECT_TRUE(Number::between(2, 2).is_rational());
  EXPECT_EQ(Number::between(1, 2).form(), Form::enclosure);
  EXPECT_THROW(Number::between(2, 1), std::invalid_argument);
  EXPECT_THROW(Number::between(1, sqrt(Number(2))), std::invalid_argument);
}

TEST(Between, DecidesOutsideItsEndsOnly) {
  const Number x = Number::between(1, num("1.5"));
  EXPECT_EQ(x.sign(), 1);
  EXPECT_LT(x, Number(2));
  EXPECT_GT(x, num("0.999"));
  EXPECT_THROW((void)(x < Number(1)), Undecided);
  EXPECT_THROW((void)(x == num("1.25")), Undecided);
  EXPECT_THROW((void)(x < num("1.5")), Undecided);
  EXPECT_THROW(Number::between(0, 1).sign(), Undecided);
}

TEST(Between, TwoOfOneIntervalAreNotEqual) {
  const Number x = Number::between(1, 2);
  EXPECT_THROW((void)(x == Number::between(1, 2)), Undecided);
  // It is about the copy: NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
  const Number copy = x;
  EXPECT_EQ(x, copy);
}

TEST(Between, FloorIsDecidedInsideOneUnit) {
  EXPECT_EQ(Number::between(1, num("1.5")).floor(), Number(1));
  EXPECT_THROW((void)Number::between(1, num("1.5")).ceil(), Undecided);
  EXPECT_THROW((void)Number::between(num("0.5"), num("1.5")).floor(), Undecided);
}

TEST(Between, BoundsAreItsEnds) {
  const auto [low, high] = Number::between(num("1/3"), num("2/3")).bounds(50);
  EXPECT_EQ(low, num("1/3"));
  EXPECT_EQ(high, num("2/3"));
}

// [1, 2] * [-3, 5] = [-6, 10]; [1, 2] / [4, 8] = [1/8, 1/2]; sqrt [4, 9] = [2, 3].
TEST(Between, ArithmeticIsThatOfIntervals) {
  const auto expect = [](const Number& value, const Number& low, const Number& high) {
    const auto bounds = value.bounds(30);
    EXPECT_EQ(bounds[0], low);
    EXPECT_EQ(bounds[1], high);
  };
  const Number x = Number::between(1, 2);
  expect(x * Number::between(-3, 5), -6, 10);
  expect(x / Number::between(4, 8), num("0.125"), num("0.5"));
  expect(sqrt(Number::between(4, 9)), 2, 3);
  expect(x + Number::between(-3, 5), -2, 7);
  expect(x - Number::between(-3, 5), -4, 5);
  expect(-x, -2, -1);
}

}  // namespace
}  // namespace gonogo::exact
