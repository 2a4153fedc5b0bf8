// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "reference/exact/number.hpp"
#include "tests/reference/exact/exact_testing.hpp"

namespace gonogo::exact {
namespace {

using testing::json;
using testing::num;

TEST(NumberJson, WritesTerminatingDecimals) {
  EXPECT_EQ(json(Number(0)), "\"0\"");
  EXPECT_EQ(json(-Number(0)), "\"0\"");
  EXPECT_EQ(json(num("-12.5")), "\"-12.5\"");
  EXPECT_EQ(json(num("-0.5")), "\"-0.5\"");
  EXPECT_EQ(json(num("100")), "\"100\"");
  EXPECT_EQ(json(num("0.000001")), "\"0.000001\"");
  EXPECT_EQ(json(num("1e-9")), "\"0.000000001\"");
  EXPECT_EQ(json(num("-1/128")), "\"-0.0078125\"");
  EXPECT_EQ(json(num("1e20")), "\"100000000000000000000\"");
  EXPECT_EQ(json(num("3/20000000")), "\"0.00000015\"");
}

TEST(NumberJson, WritesTheEndsOfTheSmallForm) {
  EXPECT_EQ(json(Number::millionths(std::numeric_limits<std::int64_t>::max())),
            "\"9223372036854.775807\"");
  EXPECT_EQ(json(Number::millionths(std::numeric_limits<std::int64_t>::min())),
            "\"-9223372036854.775808\"");
}

TEST(NumberJson, WritesOtherRationalsAsFractions) {
  EXPECT_EQ(json(num("11/3")), "\"11/3\"");
  EXPECT_EQ(json(num("-2/14")), "\"-1/7\"");
}

// 2^-1074 has 1074 decimals; its fraction has 1 + 1 + 324 characters (2^1074 = 2.02e323).
TEST(NumberJson, WritesAFractionWhereADecimalIsTooLongForARecord) {
  const std::string text = json(Number::binary(1, -1074));
  EXPECT_EQ(text.substr(0, 4), "\"1/2");
  EXPECT_EQ(text.size(), 2U + 2U + 324U);
  EXPECT_EQ(num(text.substr(1, text.size() - 2)), Number::binary(1, -1074));
}

// What is read from a record is at most 1,000 characters long, and so is what is written of it.
TEST(NumberJson, WritesWhatCanBeReadBack) {
  const std::string nines(990, '9');
  for (const std::string& text :
       {std::string("1e1000"), std::string("-1e1000"), std::string("1e-1000"),
        std::string("1.5e9999"), std::string("-1e-9999"), "0." + nines + "e-9999", nines + "0e9999",
        std::string("0x1p9999"), std::string("0x1p-9999"), std::string("-0x1.8p-9999"),
        std::string("0x0.000000000000000000001p-9999"), "0x" + nines + "p9999",
        "1/" + nines + "7"}) {
    const std::string written = json(num(text));
    EXPECT_LE(written.size(), 1002U) << text;
    EXPECT_EQ(num(written.substr(1, written.size() - 2)), num(text)) << text;
  }
}

TEST(NumberJson, WritesAnExponentWhereNothingElseIsShortEnough) {
  EXPECT_EQ(json(num("1e999")), '"' + ('1' + std::string(999, '0')) + '"');
  EXPECT_EQ(json(num("1e1000")), "\"1e1000\"");
  EXPECT_EQ(json(num("-250e-1002")), "\"-25e-1001\"");
  EXPECT_EQ(json(num("100e9999")), "\"100e9999\"");
  EXPECT_EQ(json(num("0x3p9000")), "\"0x3p9000\"");
}

TEST(NumberJson, WritesRootsByTheirParts) {
  EXPECT_EQ(json(Number::root(1, 2, 3)), "{\"root\":[\"1\",\"2\",\"3\"]}");
  EXPECT_EQ(json(Number::root(num("1/3"), num("-0.5"), 2)), "{\"root\":[\"1/3\",\"-0.5\",\"2\"]}");
}

TEST(NumberJson, AppendsToWhatIsThere) {
  std::string out = "x:";
  Number(1).append_json(out);
  EXPECT_EQ(out, "x:\"1\"");
}

// The two decimals of {"enclosure":["lo","hi"]}.
std::array<Number, 2> written_ends(const Number& value) {
  const std::string text = json(value);
  const std::string head = "{\"enclosure\":[\"";
  EXPECT_EQ(text.substr(0, head.size()), head);
  const std::size_t low_end = text.find('"', head.size());
  const std::size_t high = low_end + 3;
  const std::size_t high_end = text.find('"', high);
  EXPECT_EQ(text.substr(high_end), "\"]}");
  return {num(text.substr(head.size(), low_end - head.size())),
          num(text.substr(high, high_end - high))};
}

// cos 36 = (1 + sqrt 5)/4
TEST(NumberJson, WritesEnclosuresOfAtMost1e15th) {
  const Number golden = Number::root(num("0.25"), num("0.25"), 5);
  const Number scale = num("123456.789");
  for (const Number& factor : {Number(1), Number(-1), scale, -scale}) {
    const auto [low, high] = written_ends(cos_sin_degrees(36)[0] * factor);
    EXPECT_LE(low, golden * factor);
    EXPECT_GE(high, golden * factor);
    EXPECT_LE(high - low, num("1e-15"));
  }
}

TEST(NumberJson, WritesTheEndsOfABetweenAsTheyCame) {
  EXPECT_EQ(json(Number::between(num("1.25"), num("1.2500000000000000000000001"))),
            "{\"enclosure\":[\"1.25\",\"1.2500000000000000000000001\"]}");
  const auto [low, high] = written_ends(Number::between(num("1/3"), num("2/3")));
  EXPECT_EQ(low, num("0.33333333333333333333"));
  EXPECT_EQ(high, num("0.66666666666666666667"));
}

// 3^2200 has 1,050 digits, and a number has 1,000 characters at most: 1 + 3^-2200 lies between 1
// and 1 + 1e-20.
TEST(NumberJson, EnclosesWhatIsTooLongToBeReadBack) {
  Number tiny(1);
  for (int i = 0; i < 2'200; ++i) tiny = tiny / Number(3);
  const Number close = Number(1) + tiny;
  EXPECT_EQ(written_ends(close), (std::array<Number, 2>{1, num("1.00000000000000000001")}));
  const auto [low, high] = written_ends(Number::root(close, 1, 2));
  EXPECT_LT(low, Number::root(1, 1, 2));
  EXPECT_GT(high, Number::root(1, 1, 2));
  EXPECT_LE(high - low, num("1e-15"));
}

TEST(NumberText, IsForPeople) {
  EXPECT_EQ(num("12.5").text(), "12.5");
  EXPECT_EQ(num("11/3").text(), "11/3");
  EXPECT_EQ(Number::root(1, 2, 3).text(), "1 + 2*sqrt(3)");
  EXPECT_EQ(Number::root(1, -2, 3).text(), "1 - 2*sqrt(3)");
  EXPECT_EQ(Number::root(0, -1, 3).text(), "-sqrt(3)");
  EXPECT_EQ(Number::between(num("1.25"), num("1.26")).text(), "[1.25, 1.26]");
}

TEST(NumberDecimalText, RoundsToNearestWithTiesAwayFromZero) {
  EXPECT_EQ(num("0.125").decimal_text(2), "0.13");
  EXPECT_EQ(num("-0.125").decimal_text(2), "-0.13");
  EXPECT_EQ(num("0.1249999").decimal_text(2), "0.12");
  EXPECT_EQ(num("2/3").decimal_text(4), "0.6667");
  EXPECT_EQ(num("-2/3").decimal_text(4), "-0.6667");
  EXPECT_EQ(num("12.5").decimal_text(0), "13");
  EXPECT_EQ(num("12.5").decimal_text(3), "12.500");
  EXPECT_EQ(num("-0.001").decimal_text(2), "0.00");
  EXPECT_THROW(Number(1).decimal_text(-1), std::invalid_argument);
}

// sqrt 2 = 1.41421356..., cos 20 degrees = 0.93969262..., from tables.
TEST(NumberDecimalText, OfRootsAndEnclosures) {
  EXPECT_EQ(sqrt(Number(2)).decimal_text(6), "1.414214");
  EXPECT_EQ((-sqrt(Number(2))).decimal_text(6), "-1.414214");
  EXPECT_EQ(cos_sin_degrees(20)[0].decimal_text(6), "0.939693");
  EXPECT_EQ(cos_sin_degrees(160)[0].decimal_text(6), "-0.939693");
  EXPECT_EQ(Number::between(1, 2).decimal_text(1), "1.5");
}

}  // namespace
}  // namespace gonogo::exact
