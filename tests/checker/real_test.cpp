// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/real.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace gonogo::checker {
namespace {

const Real kRoot2 = Real::root(0, 1, 2);

TEST(CheckerReal, FormsOfANumber) {
  EXPECT_EQ(parse_rational("12.50"), Rational(25, 2));
  EXPECT_EQ(parse_rational("-11/3"), Rational(-11, 3));
  EXPECT_EQ(parse_rational("25e-1"), Rational(5, 2));
  EXPECT_EQ(parse_rational("0x1.8p+1"), Rational(3));
  EXPECT_EQ(parse_rational("-0x.8p0"), Rational(-1, 2));
}

TEST(CheckerReal, WhatIsNoNumberIsRefused) {
  for (const char* text :
       {"", "-", "1.", "1/0", "1/-2", "nan", "inf", "1e", "0x", "1 ", "1.5/2", "1e99999", "--1"}) {
    EXPECT_THROW(parse_rational(text), Fault) << text;
  }
  EXPECT_THROW(parse_rational(std::string(1001, '1')), Fault);
}

TEST(CheckerReal, BareNumbersAreRefused) {
  EXPECT_THROW(read_real(parse_json("1")), Fault);
}

TEST(CheckerReal, EnclosuresMustBeNarrowAndInOrder) {
  EXPECT_THROW(read_real(parse_json(R"({"enclosure":["1","1.1"]})")), Fault);
  EXPECT_THROW(read_real(parse_json(R"({"enclosure":["2","1"]})")), Fault);
  EXPECT_EQ(equal(read_real(parse_json(R"({"enclosure":["1","1.0000000000000001"]})")), 1),
            Truth::unknown);
}

TEST(CheckerReal, RootsOfOneFieldAreExact) {
  // sqrt(8) = 2 sqrt(2); (1 + sqrt 2)(1 - sqrt 2) = -1
  EXPECT_EQ(equal(Real::root(0, 1, 8), Real(2) * kRoot2), Truth::yes);
  EXPECT_EQ(equal(Real::root(1, 1, 2) * Real::root(1, -1, 2), Real(-1)), Truth::yes);
}

TEST(CheckerReal, ARootOfASquareIsRational) {
  EXPECT_TRUE(Real::root(1, 2, Rational(9, 4)).is_rational());
  EXPECT_EQ(equal(Real::root(1, 2, Rational(9, 4)), 4), Truth::yes);
}

TEST(CheckerReal, SignsOfRoots) {
  // sqrt(2) = 1.41421356...: just above and below.
  EXPECT_EQ(Real::root(Rational(-141421356, 100000000), 1, 2).is_positive(), Truth::yes);
  EXPECT_EQ(Real::root(Rational(-141421357, 100000000), 1, 2).is_negative(), Truth::yes);
  EXPECT_EQ(Real::root(Rational(141421357, 100000000), -1, 2).is_positive(), Truth::yes);
}

TEST(CheckerReal, RootsOfTwoFieldsAreEnclosed) {
  // sqrt(2) + sqrt(3) = 3.14626..., and whether it is equal to itself by another way is not told.
  const Real sum = kRoot2 + Real::root(0, 1, 3);
  EXPECT_FALSE(sum.is_exact());
  EXPECT_EQ(at_most(sum, Rational(31463, 10000)), Truth::yes);
  EXPECT_EQ(at_most(sum, Rational(31462, 10000)), Truth::no);
  EXPECT_EQ(equal(sum, Real::root(0, 1, 3) + kRoot2), Truth::unknown);
}

TEST(CheckerReal, DivisionByWhatMayBeZeroIsRefused) {
  EXPECT_FALSE(Real(1).over(Real::enclosure(-1, 1)).has_value());
  EXPECT_FALSE(Real(1).over(0).has_value());
}

TEST(CheckerReal, TheLimitItselfIsWithin) {
  EXPECT_EQ(within(Rational(1001, 1000), 1, Rational(1, 1000)), Truth::yes);
  EXPECT_EQ(within(Rational(1001001, 1000000), 1, Rational(1, 1000)), Truth::no);
}

RC_GTEST_PROP(CheckerReal, DivisionUndoesMultiplication, (short a, short b, short c, short d)) {
  const Real x = Real::root(a, b, 5);
  const Real y = Real::root(c, d, 5);
  RC_PRE(y.is_zero() == Truth::no);
  RC_ASSERT(equal((x * y).over(y).value(), x) == Truth::yes);
}

RC_GTEST_PROP(CheckerReal, EnclosuresHoldWhatTheyEnclose, (short a, short b, short c, short d)) {
  const Real x = Real::root(a, b, 5);
  const Real y = Real::root(c, d, 7);
  const Real product = x * y;
  // (a + b sqrt 5)(c + d sqrt 7) lies between products of bounds that were rounded apart from it.
  const Real rounded = Real::enclosure(x.low(), x.high()) * Real::enclosure(y.low(), y.high());
  RC_ASSERT(rounded.low() <= product.low());
  RC_ASSERT(product.high() <= rounded.high());
}

}  // namespace
}  // namespace gonogo::checker
