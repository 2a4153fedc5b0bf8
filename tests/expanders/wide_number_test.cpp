// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and products of 128 bits.
#include <gtest/gtest.h>

#include <string>

#include "expanders/common/product.hpp"

namespace gonogo::expanders {
namespace {

constexpr Wide kQuintillion = 1'000'000'000'000'000'000;

std::string written(Wide value) {
  char text[kTextSize];
  return {text, write_decimal(value, text)};
}

std::string divided(Wide a, Wide b, Wide c) {
  Wide quotient = 0;
  return divide_product(a, b, c, quotient) ? written(quotient * kOne) : "too large";
}

TEST(WideNumber, IsWrittenInFull) {
  EXPECT_EQ(written(kQuintillion * kQuintillion), "1000000000000000000000000000");
  EXPECT_EQ(written(kQuintillion * kQuintillion + 20), "1000000000000000000000000000.00000002");
  EXPECT_EQ(written(-(kQuintillion * 10 + 7)), "-10000000000.000000007");
}

// 2^63 and its neighbour, and the ends of the range: 2^127 =
// 170141183460469231731687303715884105728
TEST(WideNumber, Borders) {
  const Wide half = Wide{1} << 126;
  EXPECT_EQ(written((Wide{1} << 63) - 1), "9223372036.854775807");
  EXPECT_EQ(written(Wide{1} << 63), "9223372036.854775808");
  EXPECT_EQ(written(half - 1 + half), "170141183460469231731687303715.884105727");
  EXPECT_EQ(written(-half - half), "-170141183460469231731687303715.884105728");
}

TEST(WideNumber, ProductDividedToTheNearest) {
  EXPECT_EQ(divided(7, 1, 3), "2");
  EXPECT_EQ(divided(8, 1, 3), "3");
  EXPECT_EQ(divided(1, 1, 2), "1");
  EXPECT_EQ(divided(0, 5, 2), "0");
}

// 10^36 * 6 * 10^30 / (3 * 10^37) = 2 * 10^29, as counts 2 * 10^20 mm.
TEST(WideNumber, ProductsBeyond128Bits) {
  const Wide ten_to_36 = kQuintillion * kQuintillion;
  Wide quotient = 0;
  ASSERT_TRUE(divide_product(ten_to_36, 6 * kQuintillion * (kQuintillion / 1'000'000),
                             30 * ten_to_36, quotient));
  EXPECT_EQ(written(quotient), "200000000000000000000");
  // The rest is not lost: (10^36 + 1)^2 / 10^36 = 10^36 + 2, to the nearest.
  ASSERT_TRUE(divide_product(ten_to_36 + 1, ten_to_36 + 1, ten_to_36, quotient));
  EXPECT_EQ(quotient - ten_to_36, 2);
}

TEST(WideNumber, QuotientsThatDoNotFit) {
  const Wide half = Wide{1} << 126;
  EXPECT_EQ(divided(half, half, half / 2), "too large");
  EXPECT_EQ(divided(half, 2, 1), "too large");
  EXPECT_EQ(divided(half, 4, 2), "too large");
}

}  // namespace
}  // namespace gonogo::expanders
