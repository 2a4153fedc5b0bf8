// SPDX-License-Identifier: GPL-3.0-or-later
//
// HNC-COM-01: words and codes of any block.
#include <gtest/gtest.h>

#include "reference/dialect.hpp"

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

TEST(HncWords, AnAddressStandsOnce) {
  EXPECT_EQ(ending_of("G00 X1 X2"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("M03 M08"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("G80 X1 Z1 I1 I1 F1"), "alarm b1 duplicate-word");
}

TEST(HncWords, AnAxisIsCommandedOnce) {
  EXPECT_EQ(ending_of("G00 X1 U2"), "alarm b1 conflicting-words");
  EXPECT_EQ(ending_of("G00 Z1 W2"), "alarm b1 conflicting-words");
  EXPECT_EQ(path("G00 X2 W2"), Lines{"rapid x1 z2"});
}

TEST(HncWords, OneCodeOfAGroup) {
  for (const char* pair : {"G00 G01", "G32 G80", "G74 G82", "G90 G91", "G20 G21", "G36 G37",
                           "G54 G59", "G94 G95", "G96 G97", "G04 G92", "G80 G80"}) {
    EXPECT_EQ(ending_of(std::string(pair) + " P1 F1").substr(0, 23), "alarm b1 duplicate-word")
        << pair;
  }
  EXPECT_EQ(ending_of("G90 G00 G54 G21 G36 G94 G40 G97 X0"), kEndAtOrigin);
}

TEST(HncWords, ACodeThatTheControlLacksIsTheOnlyAlarm) {
  for (const char* code : {"G05", "G10", "G33", "G60", "G83", "G93", "G100", "G80.5", "G-1"}) {
    EXPECT_EQ(ending_of("G00 X1 X2 F-1 " + std::string(code)), "alarm b1 undefined-code") << code;
  }
  EXPECT_EQ(ending_of("G05 G06"), "alarm b1 undefined-code undefined-code");
}

TEST(HncWords, CodesThatTheGaugeDoesNotReadEndTheProgram) {
  const std::vector<OutsideCode> all = outside_codes(*find_dialect("hnc21t")->descriptor);
  ASSERT_FALSE(all.empty());
  for (const auto& [code, title] : all) {
    EXPECT_EQ(path("Z1\n" + code + " X1 X2 F-1 G05\nZ2"),
              (Lines{"rapid z1", "not-covered b2 " + code}));
  }
  EXPECT_EQ(ending_of("G96 S80\nG46 X400 P900"), "not-covered b2 G46");
  EXPECT_EQ(ending_of("M98 P1234 X1 X2 G05"), "not-covered b1 M98");
  EXPECT_EQ(ending_of("M99"), "not-covered b1 M99");
}

TEST(HncWords, TheMacroLanguageIsNotCovered) {
  EXPECT_EQ(ending_of("Z1\n#1=5"), "not-covered b2 variable");
  EXPECT_EQ(ending_of("Z1\nG00 X[#1]").substr(0, 14), "not-covered b2");
  EXPECT_EQ(ending_of("Z1\nWHILE #1 LT 5"), "not-covered b2 control-statement");
}

TEST(HncWords, CodesWithoutEffectAreIgnored) {
  for (const std::string& code : codes_without_effect(*find_dialect("hnc21t")->descriptor)) {
    if (code.size() == 1) continue;
    EXPECT_EQ(path("G00 X2 " + std::string(code)), Lines{"rapid x1"}) << code;
  }
  EXPECT_EQ(path("G00 X2 S300 T0101"), Lines{"rapid x1"});
}

TEST(HncWords, OnlyThePlaneOfTheLatheIsAllowed) {
  EXPECT_EQ(ending_of("G17 X1"), "alarm b1 plane-not-allowed");
  EXPECT_EQ(ending_of("G19"), "alarm b1 plane-not-allowed");
  EXPECT_EQ(ending_of("G17 G18"), "alarm b1 plane-not-allowed duplicate-word");
  EXPECT_EQ(ending_of("G00 X1 X2 G17"), "alarm b1 duplicate-word plane-not-allowed");
}

TEST(HncWords, UnreadableTextIsOneAlarm) {
  EXPECT_EQ(ending_of("Z1\nG00 X"), "alarm b2 syntax");
}

TEST(HncWords, HeadsAndCommentsDoNothing) {
  EXPECT_EQ(path("%\nO0230\n%1234\n(text)\nN1 ; text\n\nG00 X2 (text)\n%"), Lines{"rapid x1"});
}

TEST(HncWords, ABlankMayStandBetweenLetterAndNumber) {
  EXPECT_EQ(path("G01 X 20 Z-30 F 40"), Lines{"feed x10 z-30 f40"});
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
