// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/json.hpp"

#include <gtest/gtest.h>

namespace gonogo::checker {
namespace {

TEST(CheckerJson, NumbersStayAsTheyAreWritten) {
  EXPECT_EQ(parse_json("[1.50e+2]").items.at(0).text, "1.50e+2");
}

TEST(CheckerJson, EscapesAreCharacters) {
  // U+00E9 and the surrogate pair of U+1F600.
  EXPECT_EQ(parse_json(R"("\n\u00e9\ud83d\ude00")").text, "\n\xC3\xA9\xF0\x9F\x98\x80");
}

TEST(CheckerJson, ValuesKnowWhereTheyStand) {
  const Json object = parse_json(R"({"a": [1, 2]})");
  const Json* list = object.find("a");
  ASSERT_NE(list, nullptr);
  EXPECT_EQ(list->begin, 6U);
  EXPECT_EQ(list->end, 12U);
}

TEST(CheckerJson, AKeyTwiceIsRefused) {
  EXPECT_THROW(parse_json(R"({"a":1,"a":1})"), Fault);
}

TEST(CheckerJson, WhatFollowsTheValueIsRefused) {
  EXPECT_THROW(parse_json("{} {}"), Fault);
}

TEST(CheckerJson, WhatIsNoJsonIsRefused) {
  for (const char* text : {"", "{", "[1,]", "01", "1.", "\"a", "\"\\x\"", "nul", "\"\\ud83d\"",
                           "{\"a\"}", "\"\n\"", "+1", "NaN"}) {
    EXPECT_THROW(parse_json(text), Fault) << text;
  }
}

TEST(CheckerJson, DeepNestingIsRefused) {
  EXPECT_THROW(parse_json(std::string(10'000, '[')), Fault);
}

TEST(CheckerJson, SameValueInAnotherOrder) {
  EXPECT_TRUE(parse_json(R"({"a":1,"b":[2]})").same_as(parse_json(R"({ "b" : [2], "a":1 })")));
  EXPECT_FALSE(parse_json(R"({"a":1})").same_as(parse_json(R"({"a":"1"})")));
}

}  // namespace
}  // namespace gonogo::checker
