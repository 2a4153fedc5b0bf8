// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/number.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <thread>
#include <type_traits>
#include <vector>

#include "tests/reference/exact/exact_testing.hpp"

namespace gonogo::exact {
namespace {

using testing::is_small;
using testing::num;

constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kMin = std::numeric_limits<std::int64_t>::min();

static_assert(sizeof(Number) == 16);
static_assert(!std::is_constructible_v<Number, double>);
static_assert(!std::is_constructible_v<Number, float>);

TEST(Number, StartsAtZero) {
  EXPECT_EQ(Number().text(), "0");
  EXPECT_EQ(Number().sign(), 0);
}

TEST(Number, MillionthsAreCountsOf1e6th) {
  EXPECT_EQ(Number::millionths(12'500'000).text(), "12.5");
  EXPECT_EQ(Number::millionths(-1).text(), "-0.000001");
}

// 9223372036854 is the last integer whose count of millionths stays below 2^63 =
// 9223372036854775808.
TEST(Number, IntegersBeyondTheSmallFormKeepTheirValue) {
  EXPECT_TRUE(is_small(Number(std::int64_t{9223372036854})));
  EXPECT_FALSE(is_small(Number(std::int64_t{9223372036855})));
  EXPECT_EQ(Number(kMax).text(), "9223372036854775807");
  EXPECT_EQ(Number(kMin).text(), "-9223372036854775808");
}

TEST(Number, ASumThatOverflowsIsPromotedAndComesBack) {
  const Number most = Number::millionths(kMax);
  const Number step = Number::millionths(1);
  const Number over = most + step;  // 2^63 millionths
  EXPECT_FALSE(is_small(over));
  EXPECT_EQ(over.text(), "9223372036854.775808");
  EXPECT_GT(over, most);
  EXPECT_TRUE(is_small(over - step));
  EXPECT_EQ(over - step, most);
}

TEST(Number, ADifferenceThatOverflowsIsPromoted) {
  const Number least = Number::millionths(kMin);
  const Number under = least - Number::millionths(1);
  EXPECT_EQ(under.text(), "-9223372036854.775809");
  EXPECT_LT(under, least);
}

TEST(Number, NegatingTheLeastCountIsExact) {
  const Number least = Number::millionths(kMin);
  EXPECT_FALSE(is_small(-least));
  EXPECT_EQ((-least).text(), "9223372036854.775808");
  EXPECT_TRUE(is_small(-(-least)));
  EXPECT_EQ(-(-least), least);
}

TEST(Number, ProductsStaySmallOnlyWhenExact) {
  EXPECT_TRUE(is_small(num("0.5") * num("0.5")));
  EXPECT_EQ((num("0.5") * num("0.5")).text(), "0.25");
  EXPECT_FALSE(is_small(num("0.000001") * num("0.1")));
  EXPECT_EQ((num("0.000001") * num("0.1")).text(), "0.0000001");
}

// 3037000.5 * 3037000.5 = 9223372037000.25 needs 128 bits on the way and is above 2^63 * 1e-6;
// 3000000.5 * 3000000.5 = 9000003000000.25 is below.
TEST(Number, ProductsBeyond64BitsOnTheWay) {
  EXPECT_EQ((num("3037000.5") * num("3037000.5")).text(), "9223372037000.25");
  EXPECT_FALSE(is_small(num("3037000.5") * num("3037000.5")));
  EXPECT_EQ((num("3000000.5") * num("3000000.5")).text(), "9000003000000.25");
  EXPECT_TRUE(is_small(num("3000000.5") * num("3000000.5")));
}

TEST(Number, TheLeastCountTimesMinusOne) {
  EXPECT_EQ((Number::millionths(kMin) * Number(-1)).text(), "9223372036854.775808");
  EXPECT_EQ(Number::millionths(kMin) * Number(1), Number::millionths(kMin));
}

TEST(Number, DividesExactly) {
  EXPECT_EQ(Number(11) / Number(3), num("11/3"));
  EXPECT_TRUE(is_small(Number(1) / Number(8)));
  EXPECT_EQ(Number(1) / Number(8), num("0.125"));
  EXPECT_EQ(Number(11) / Number(3) * Number(3), Number(11));
  EXPECT_TRUE(is_small(Number(11) / Number(3) * Number(3)));
  EXPECT_EQ((Number::millionths(kMin) / Number(-1)).text(), "9223372036854.775808");
}

TEST(Number, DivisionByZeroIsADomainError) {
  EXPECT_THROW(Number(1) / Number(0), std::domain_error);
  EXPECT_THROW(num("1/3") / Number(0), std::domain_error);
  EXPECT_THROW(Number(0) / Number(0), std::domain_error);
}

TEST(Number, ComparesAcrossForms) {
  EXPECT_LT(num("0.333333"), num("1/3"));
  EXPECT_GT(num("0.333334"), num("1/3"));
  EXPECT_EQ(num("2/6"), num("1/3"));
  EXPECT_NE(num("1/3"), num("1/7"));
}

TEST(Number, MovedAndCopiedNumbersKeepTheirValue) {
  Number third = num("1/3");
  Number copy = third;
  Number moved = std::move(third);
  copy = *&copy;
  EXPECT_EQ(copy, num("1/3"));
  EXPECT_EQ(moved, copy);
  moved = Number(2);
  EXPECT_EQ(moved, Number(2));
  EXPECT_EQ(copy, num("1/3"));
}

TEST(Number, CanBeCopiedByManyThreadsAtOnce) {
  const Number shared = cos_sin_degrees(20)[0] + num("1/3");
  const auto copy_often = [&shared] {
    for (int i = 0; i < 10'000; ++i) {
      // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): it is about the copy.
      const Number copy = shared;
      ASSERT_EQ(copy.sign(), 1);
    }
  };
  std::thread other(copy_often);
  copy_often();
  other.join();
  EXPECT_EQ(NumberAccess::node(shared)->count.load(), 1U);
}

TEST(NumberDecimal, ScalesTheMagnitude) {
  EXPECT_EQ(Number::decimal(false, 125, 1).text(), "12.5");
  EXPECT_EQ(Number::decimal(true, 125, 0).text(), "-125");
  EXPECT_EQ(Number::decimal(true, 0, 9), Number(0));
  EXPECT_EQ(Number::decimal(false, 1, 7), num("1/10000000"));
  EXPECT_TRUE(is_small(Number::decimal(false, 1'000, 9)));
  EXPECT_EQ(Number::decimal(false, 18446744073709551615U, 0).text(), "18446744073709551615");
}

// 2^63 = 9223372036854775808 with a minus still is a count, without it is not.
TEST(NumberDecimal, HoldsTheLeastCount) {
  EXPECT_TRUE(is_small(Number::decimal(true, 9223372036854775808U, 6)));
  EXPECT_EQ(Number::decimal(true, 9223372036854775808U, 6), Number::millionths(kMin));
  EXPECT_FALSE(is_small(Number::decimal(false, 9223372036854775808U, 6)));
}

TEST(NumberDecimal, TakesDigitsOfAnyLength) {
  EXPECT_EQ(Number::decimal(true, "00012500", 3).text(), "-12.5");
  const std::string nines(10'000, '9');
  EXPECT_EQ(Number::decimal(false, nines, 0) + Number(1),
            Number::decimal(false, "1" + std::string(10'000, '0'), 0));
  EXPECT_EQ(Number::decimal(false, "1" + std::string(10'000, '0'), 10'000), Number(1));
  EXPECT_THROW(Number::decimal(false, "", 0), std::invalid_argument);
  EXPECT_THROW(Number::decimal(false, "1.2", 0), std::invalid_argument);
}

TEST(NumberBinary, IsTheMantissaTimesAPowerOfTwo) {
  EXPECT_EQ(Number::binary(3, -1).text(), "1.5");
  EXPECT_EQ(Number::binary(-5, 4).text(), "-80");
  EXPECT_EQ(Number::binary(0, 1023), Number(0));
  // 0.1 as binary64 is 3602879701896397 / 2^55: above one tenth.
  const Number tenth = Number::binary(3602879701896397, -55);
  EXPECT_EQ(tenth.text(), "0.1000000000000000055511151231257827021181583404541015625");
  EXPECT_GT(tenth, num("0.1"));
}

TEST(NumberFloor, RoundsDownAndUp) {
  EXPECT_EQ(num("2.5").floor(), Number(2));
  EXPECT_EQ(num("2.5").ceil(), Number(3));
  EXPECT_EQ(num("-2.5").floor(), Number(-3));
  EXPECT_EQ(num("-2.5").ceil(), Number(-2));
  EXPECT_EQ(num("-1/3").floor(), Number(-1));
  EXPECT_EQ(num("-1/3").ceil(), Number(0));
  EXPECT_EQ(Number(7).floor(), Number(7));
  EXPECT_EQ(Number(7).ceil(), Number(7));
  EXPECT_EQ(Number::millionths(kMin).floor().text(), "-9223372036855");
}

TEST(NumberToInt64, IsThereForWholeNumbersThatFit) {
  EXPECT_EQ(Number(-7).to_int64(), -7);
  EXPECT_EQ(Number(kMin).to_int64(), kMin);
  EXPECT_EQ(num("0.5").to_int64(), std::nullopt);
  EXPECT_EQ(num("1/3").to_int64(), std::nullopt);
  EXPECT_EQ((Number(kMax) + Number(1)).to_int64(), std::nullopt);
  EXPECT_EQ(sqrt(Number(2)).to_int64(), std::nullopt);
}

TEST(NumberFraction, IsInLowestTermsWithAPositiveDenominator) {
  EXPECT_EQ(num("-12.5").fraction(), (std::array<std::string, 2>{"-25", "2"}));
  EXPECT_EQ(Number(0).fraction(), (std::array<std::string, 2>{"0", "1"}));
  EXPECT_EQ(num("22/6").fraction(), (std::array<std::string, 2>{"11", "3"}));
  EXPECT_THROW(sqrt(Number(2)).fraction(), std::invalid_argument);
}

TEST(NumberBounds, OfARationalAreTheNumber) {
  const auto [low, high] = num("1/3").bounds(10);
  EXPECT_EQ(low, num("1/3"));
  EXPECT_EQ(high, num("1/3"));
}

TEST(NumberOrder, AbsMinMax) {
  EXPECT_EQ(abs(num("-1/3")), num("1/3"));
  EXPECT_EQ(abs(num("2.5")), num("2.5"));
  EXPECT_EQ(min(Number(2), Number(-3)), Number(-3));
  EXPECT_EQ(max(Number(2), Number(-3)), Number(2));
}

}  // namespace
}  // namespace gonogo::exact
