// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "reference/exact/number.hpp"
#include "tests/reference/exact/exact_testing.hpp"

namespace gonogo::exact {
namespace {

using testing::is_small;

Number parsed(std::string_view text) {
  return Number::parse(text).value();
}

TEST(NumberParse, ReadsDecimals) {
  EXPECT_EQ(parsed("0"), Number(0));
  EXPECT_EQ(parsed("-0"), Number(0));
  EXPECT_EQ(parsed("12.5"), Number::millionths(12'500'000));
  EXPECT_EQ(parsed("+12.5"), Number::millionths(12'500'000));
  EXPECT_EQ(parsed("-0.000001"), Number::millionths(-1));
  EXPECT_EQ(parsed("12."), Number(12));
  EXPECT_EQ(parsed(".5"), Number::millionths(500'000));
  EXPECT_EQ(parsed("007"), Number(7));
  EXPECT_EQ(parsed("1.50000000000000000000000000"), Number::millionths(1'500'000));
}

TEST(NumberParse, ReadsMoreThanSixPlacesExactly) {
  EXPECT_EQ(parsed("0.0000001") * Number(10), Number::millionths(1));
  EXPECT_EQ(parsed("0.12345678901234567890").text(), "0.1234567890123456789");
}

TEST(NumberParse, ReadsExponents) {
  EXPECT_EQ(parsed("1.5e3"), Number(1500));
  EXPECT_EQ(parsed("1.5E+3"), Number(1500));
  EXPECT_EQ(parsed("15e-1"), Number::millionths(1'500'000));
  EXPECT_TRUE(is_small(parsed("12500e-3")));
  EXPECT_EQ(parsed("1e9999") * parsed("1e-9999"), Number(1));
  EXPECT_EQ(parsed("1e0000000003"), Number(1000));
  EXPECT_EQ(parsed("0e9999"), Number(0));
}

TEST(NumberParse, ReadsFractions) {
  EXPECT_EQ(parsed("11/3") * Number(3), Number(11));
  EXPECT_EQ(parsed("-1/2"), Number::millionths(-500'000));
  EXPECT_EQ(parsed("+4/2"), Number(2));
  EXPECT_EQ(parsed("0/5"), Number(0));
}

TEST(NumberParse, ReadsHexFloats) {
  EXPECT_EQ(parsed("0x1.8p+3"), Number(12));
  EXPECT_EQ(parsed("-0x1.8p-1"), Number::millionths(-750'000));
  EXPECT_EQ(parsed("0X1P4"), Number(16));
  EXPECT_EQ(parsed("0xFf"), Number(255));
  EXPECT_EQ(parsed("0x.8"), Number::millionths(500'000));
  EXPECT_EQ(parsed("0x1.p0"), Number(1));
  EXPECT_EQ(parsed("0x0p+0"), Number(0));
  // 0.1 as binary64, as %a prints it
  EXPECT_EQ(parsed("0x1.999999999999ap-4"), Number::binary(0x1999999999999a, -56));
}

TEST(NumberParse, RefusesWhatIsNoNumber) {
  for (const char* text :
       {"",      "+",     "-",        ".",     "-.",    "e5",      ".e5",   "1e",   "1e+",
        "1e5.0", "--1",   "+-1",      " 1",    "1 ",    "1,5",     "1_000", "nan",  "NaN",
        "inf",   "-inf",  "Infinity", "1.2.3", "1/0",   "1/",      "/2",    "1/-2", "1/+2",
        "1.5/2", "1/2.5", "1/2/3",    "1e2/3", "0x",    "0x.",     "0xp1",  "0x1p", "0x1p1.5",
        "0x1pA", "0xg",   "x1",       "1x",    "0x1/2", "\xc2\xbd"}) {
    EXPECT_EQ(Number::parse(text), std::nullopt) << '"' << text << '"';
  }
  EXPECT_EQ(Number::parse(std::string_view("1\0", 2)), std::nullopt);
}

TEST(NumberParse, RefusesExponentsBeyond9999) {
  EXPECT_EQ(Number::parse("1e10000"), std::nullopt);
  EXPECT_EQ(Number::parse("1e-10000"), std::nullopt);
  EXPECT_EQ(Number::parse("0x1p10000"), std::nullopt);
  EXPECT_EQ(Number::parse("1e99999999999999999999"), std::nullopt);
  EXPECT_EQ(parsed("0x1p-9999"), Number::binary(1, -9999));
}

TEST(NumberParse, RefusesMoreThan1000Characters) {
  EXPECT_EQ(parsed(std::string(1000, '9')).text(), std::string(1000, '9'));
  EXPECT_EQ(Number::parse(std::string(1001, '9')), std::nullopt);
  EXPECT_EQ(Number::parse(std::string(1001, '0')), std::nullopt);
}

TEST(NumberParse, ReadsTheEndsOfTheSmallForm) {
  EXPECT_TRUE(is_small(parsed("9223372036854.775807")));
  EXPECT_FALSE(is_small(parsed("9223372036854.775808")));
  EXPECT_TRUE(is_small(parsed("-9223372036854.775808")));
  EXPECT_FALSE(is_small(parsed("-9223372036854.775809")));
  EXPECT_EQ(parsed("-9223372036854.775809").text(), "-9223372036854.775809");
  EXPECT_EQ(parsed("9999999999999999999").text(), "9999999999999999999");    // 19 digits
  EXPECT_EQ(parsed("99999999999999999999").text(), "99999999999999999999");  // 20 digits
}

}  // namespace
}  // namespace gonogo::exact
