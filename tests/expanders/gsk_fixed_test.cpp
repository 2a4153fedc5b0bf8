// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "expanders/common/fixed.hpp"

namespace gonogo::expanders::gsk {
namespace {

Decimal read(std::string_view text) {
  const char* cursor = text.data();
  Decimal number;
  EXPECT_TRUE(read_decimal(cursor, text.data() + text.size(), number)) << text;
  EXPECT_EQ(cursor, text.data() + text.size()) << text;
  return number;
}

std::string written(Fixed value) {
  char text[kTextSize];
  return {text, write_decimal(value, text)};
}

TEST(Fixed, ReadsWholeCounts) {
  EXPECT_EQ(read("-12.5").value, -12'500'000'000);
  EXPECT_EQ(read("+.000000001").value, 1);
  EXPECT_EQ(read("7.").value, 7 * kOne);
  EXPECT_FALSE(read("1.000000000").finer);
}

TEST(Fixed, RoundsWhatIsFiner) {
  EXPECT_EQ(read("0.0000000014999").value, 1);
  EXPECT_EQ(read("-0.0000000015").value, -2);
  EXPECT_TRUE(read("0.00000000001").finer);
}

TEST(Fixed, RefusesWhatIsTooLarge) {
  EXPECT_FALSE(read("3999999999.999999999").overflow);
  EXPECT_TRUE(read("4000000000").overflow);
}

TEST(Fixed, WritesTheShortestDecimal) {
  EXPECT_EQ(written(-12'500'000'000), "-12.5");
  EXPECT_EQ(written(0), "0");
  EXPECT_EQ(written(1), "0.000000001");
  EXPECT_EQ(written(-kLargest), "-4000000000");
}

TEST(Fixed, ScalesToTheNearestCount) {
  EXPECT_EQ(scaled(1, 254, 10), 25);  // 25.4
  EXPECT_EQ(scaled(5, 1, 2), 3);      // 2.5
  EXPECT_EQ(scaled(-5, 1, 2), -3);
}

}  // namespace
}  // namespace gonogo::expanders::gsk
