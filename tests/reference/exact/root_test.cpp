// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>

#include "reference/exact/number.hpp"
#include "tests/reference/exact/exact_testing.hpp"

namespace gonogo::exact {
namespace {

using testing::enclosed;
using testing::num;
using Form = Number::Form;

TEST(Root, OfASquareIsRational) {
  EXPECT_EQ(sqrt(num("6.25")), num("2.5"));
  EXPECT_EQ(sqrt(num("4/9")), num("2/3"));
  EXPECT_EQ(sqrt(Number(0)), Number(0));
  EXPECT_TRUE(Number::root(1, 2, num("2.25")).is_rational());
  EXPECT_EQ(Number::root(1, 2, num("2.25")), Number(4));
  EXPECT_EQ(Number::root(1, 0, 2), Number(1));
}

TEST(Root, TakesSquaresOutOfTheRadicand) {
  EXPECT_EQ(sqrt(Number(12)).text(), "2*sqrt(3)");
  EXPECT_EQ(sqrt(num("0.5")).text(), "0.5*sqrt(2)");
  EXPECT_EQ(sqrt(num("4/3")).text(), "2/3*sqrt(3)");
  EXPECT_EQ(Number::root(1, -1, 8).text(), "1 - 2*sqrt(2)");
  EXPECT_EQ(sqrt(Number(2 * 1009 * 1009)).text(), "1009*sqrt(2)");
}

TEST(Root, SquaredIsTheRadicand) {
  const Number root = sqrt(num("123.456"));
  EXPECT_EQ(root.form(), Form::root);
  EXPECT_EQ(root * root, num("123.456"));
  EXPECT_TRUE((root * root).is_rational());
}

TEST(Root, OfANegativeNumberIsADomainError) {
  EXPECT_THROW(sqrt(Number(-1)), std::domain_error);
  EXPECT_THROW(Number::root(0, 1, -2), std::domain_error);
  EXPECT_THROW(sqrt(Number(1) - sqrt(Number(2))), std::domain_error);
  EXPECT_THROW(Number::root(sqrt(Number(2)), 1, 3), std::invalid_argument);
}

// (1 + 2 sqrt 3)(3 - sqrt 3) = 3 - sqrt 3 + 6 sqrt 3 - 6 = -3 + 5 sqrt 3
TEST(Root, ArithmeticOfOneRadicandIsClosed) {
  const Number x = Number::root(1, 2, 3);
  const Number y = Number::root(3, -1, 3);
  EXPECT_EQ((x + y).text(), "4 + sqrt(3)");
  EXPECT_EQ((x - y).text(), "-2 + 3*sqrt(3)");
  EXPECT_EQ((x * y).text(), "-3 + 5*sqrt(3)");
  // (1 + 2 sqrt 3)(3 + sqrt 3) / 6 = (9 + 7 sqrt 3) / 6
  EXPECT_EQ((x / y).text(), "1.5 + 7/6*sqrt(3)");
  EXPECT_EQ((-x).text(), "-1 - 2*sqrt(3)");
  EXPECT_EQ(x - x, Number(0));
  EXPECT_EQ((x / num("0.5")).text(), "2 + 4*sqrt(3)");
  EXPECT_EQ((Number(11) / x).text(), "-1 + 2*sqrt(3)");  // 11 (1 - 2 sqrt 3) / (1 - 12)
}

TEST(Root, RadicandsWhoseProductIsASquareAreMerged) {
  // 1000003 is prime: its square is not found by trial division of 1000003^2 * 1000033 * 2.
  const Number prime = Number(1000003);
  const Number product = Number(1000033) * Number(2);
  const Number large = sqrt(prime * prime * product);
  EXPECT_EQ(large, prime * sqrt(product));
  EXPECT_EQ((large + sqrt(product)).form(), Form::root);
  EXPECT_EQ(large - prime * sqrt(product), Number(0));
  EXPECT_EQ(large / sqrt(product), prime);
}

TEST(Root, ProductsOfPureRootsAreRoots) {
  EXPECT_EQ((sqrt(Number(2)) * sqrt(Number(3))).text(), "sqrt(6)");
  EXPECT_EQ((sqrt(Number(6)) / sqrt(Number(2))).text(), "sqrt(3)");
  EXPECT_EQ((sqrt(Number(2)) / sqrt(Number(3))).text(), "1/3*sqrt(6)");
}

TEST(Root, SumsOfTwoRadicandsAreEnclosures) {
  const Number sum = sqrt(Number(2)) + sqrt(Number(3));
  EXPECT_EQ(sum.form(), Form::enclosure);
  // (sqrt 2 + sqrt 3)^2 = 5 + 2 sqrt 6
  EXPECT_TRUE(enclosed(sum * sum, Number::root(5, 2, 6), 300));
}

TEST(Root, SignIsExact) {
  EXPECT_EQ(Number::root(-7, 5, 2).sign(), 1);  // 50 > 49
  EXPECT_EQ(Number::root(7, -5, 2).sign(), -1);
  EXPECT_EQ(Number::root(-3, 2, 2).sign(), -1);  // 8 < 9
  EXPECT_EQ(Number::root(0, -1, 2).sign(), -1);
  EXPECT_EQ(Number::root(1, 1, 2).sign(), 1);
  EXPECT_EQ(Number::root(-1, -1, 2).sign(), -1);
}

// 1 + sqrt 2 = 2.41421..., sqrt 6 = 2.44948..., sqrt 5 + 0.18 = 2.41606...
TEST(Root, ComparesDifferentRadicandsExactly) {
  const Number x = Number::root(1, 1, 2);
  EXPECT_LT(x, sqrt(Number(6)));
  EXPECT_GT(sqrt(Number(6)), x);
  EXPECT_LT(x, Number::root(num("0.18"), 1, 5));
  EXPECT_LT(-sqrt(Number(6)), -x);
  EXPECT_NE(x, sqrt(Number(6)));
}

// Pell: p^2 - 2 q^2 = 1 makes p/q - sqrt 2 about 1/(2 sqrt 2 q^2).
TEST(Root, ComparesWithVeryCloseRationals) {
  Number p = 3;
  Number q = 2;
  for (int i = 0; i < 10; ++i) {
    const Number next = p * p + Number(2) * q * q;
    q = Number(2) * p * q;
    p = next;
  }
  ASSERT_EQ(p * p - Number(2) * q * q, Number(1));
  EXPECT_GT(p / q, sqrt(Number(2)));
  EXPECT_LT(Number(2) * q / p, sqrt(Number(2)));
}

// sqrt(6 + 2 sqrt 5) = 1 + sqrt 5, sqrt(3 - 2 sqrt 2) = sqrt 2 - 1, sqrt(7 - 4 sqrt 3) = 2 -
// sqrt 3.
TEST(Root, RootsOfRootsAreDenestedToOneRoot) {
  EXPECT_EQ(sqrt(Number::root(6, 2, 5)).text(), "1 + sqrt(5)");
  EXPECT_EQ(sqrt(Number::root(3, -2, 2)).text(), "-1 + sqrt(2)");
  EXPECT_EQ(sqrt(Number::root(7, -4, 3)).text(), "2 - sqrt(3)");
}

// sqrt(5 + 2 sqrt 6) = sqrt 2 + sqrt 3 is no single root, nor is the fourth root of 2.
TEST(Root, OtherRootsOfRootsAreEnclosures) {
  const Number nested = sqrt(Number::root(5, 2, 6));
  EXPECT_EQ(nested.form(), Form::enclosure);
  const Number fourth = sqrt(sqrt(Number(2)));
  EXPECT_EQ(fourth.form(), Form::enclosure);
  EXPECT_EQ(fourth * fourth, sqrt(Number(2)));
}

TEST(Root, FloorAndCeilAreExact) {
  EXPECT_EQ(sqrt(Number(2)).floor(), Number(1));
  EXPECT_EQ(sqrt(Number(2)).ceil(), Number(2));
  EXPECT_EQ((-sqrt(Number(2))).floor(), Number(-2));
  EXPECT_EQ((-sqrt(Number(2))).ceil(), Number(-1));
  // (1 - sqrt 5)/2 = -0.618...; (10^12 sqrt 2 = 1414213562373.09...)
  EXPECT_EQ((Number::root(1, -1, 5) / Number(2)).floor(), Number(-1));
  EXPECT_EQ(Number::root(0, std::int64_t{1'000'000'000'000}, 2).floor(),
            Number(std::int64_t{1414213562373}));
}

TEST(Root, BoundsAreAsCloseAsAskedFor) {
  for (const int bits : {0, 1, 64, 1000}) {
    const auto [low, high] = sqrt(Number(2)).bounds(bits);
    EXPECT_LE(high - low, Number::binary(1, -bits));
    EXPECT_LE(low * low, Number(2));
    EXPECT_GE(high * high, Number(2));
  }
}

// Small and large, reduced and not, rational in the end or not: the same number, written the same.
TEST(Root, TwoOfOneRootAreWhatEachIsAlone) {
  const Number huge = num("123456789012345678901234567890");
  const std::array<Number, 6> radicands = {0, 8, 12, num("0.04"), num("1234.567891"), huge};
  for (const Number& c : radicands) {
    for (const Number& d : {Number(1), Number(18), num("0.000007"), huge}) {
      for (const Number& b : {Number(0), num("-2.5"), num("0.000001"), num("1/3"), huge}) {
        const auto both = Number::roots({num("1.5"), -7}, {b, 49}, c, d);
        EXPECT_EQ(both[0].text(), Number::root(num("1.5"), b, c / d).text());
        EXPECT_EQ(both[1].text(), Number::root(-7, 49, c / d).text());
      }
    }
  }
}

// 2^31 - 1 is a prime; the squares of it and of its neighbours but one are at the end of a word.
TEST(Root, SquaresOfLongNumbersAreTakenOut) {
  for (const std::int64_t root : {2'147'483'647LL, 3'037'000'499LL, 94'906'267LL}) {
    const Number square = Number(root) * Number(root);
    EXPECT_EQ(sqrt(square), Number(root));
    EXPECT_EQ(sqrt(square * 101 * 101), Number(root) * 101);
    EXPECT_EQ(Number::root(0, 1, square * 2).text(), Number(root).text() + "*sqrt(2)");
    EXPECT_EQ((Number::root(0, 1, square - 1) * Number::root(0, 1, square - 1)), square - 1);
  }
}

TEST(Root, PartsAreRational) {
  const auto [a, b, c] = Number::root(num("1/3"), -2, 12).root_parts();
  EXPECT_EQ(a, num("1/3"));
  EXPECT_EQ(b * b * c, Number(48));
  EXPECT_LT(b, Number(0));
  EXPECT_THROW(Number(1).root_parts(), std::invalid_argument);
}

}  // namespace
}  // namespace gonogo::exact
