// SPDX-License-Identifier: GPL-3.0-or-later
//
// Codes that the language has and lacks, and words that stand twice.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

TEST(NgcCodes, ThoseWithoutEffectAreIgnored) {
  EXPECT_EQ(path("G8 G40 G49 G54 G64 G94 G97 G98\nG99\nG61\nG61.1\nT1 M6\nS500\nG0 X1"),
            Lines{"rapid x1"});
}

TEST(NgcCodes, ThoseOfOtherPartsOfTheLanguageAreNotCovered) {
  for (const char* code :
       {"G17.1", "G38.2", "G38.5", "G41", "G42", "G41.1", "G42.1", "G50", "G51", "G87", "G88"}) {
    EXPECT_EQ(ending_of(std::string("G0 X1\nX2 ") + code), std::string("not-covered b2 ") + code);
    EXPECT_EQ(path(std::string("G0 X1\nX2 ") + code).size(), 2U) << code;
  }
  EXPECT_EQ(ending_of("G5 X1"), "not-covered b1 G05");
  EXPECT_EQ(ending_of("G71.1 Q1"), "not-covered b1 G71.1");
  EXPECT_EQ(ending_of("M19 R90"), "not-covered b1 M19");
}

TEST(NgcCodes, AnyOtherCodeIsUndefined) {
  for (const char* code : {"G6", "G11", "G22", "G34", "G44", "G60", "G62", "G77", "G79", "G100",
                           "G0.1", "G64.1", "G59.4", "G-1", "G1.05"}) {
    EXPECT_EQ(ending_of(std::string("G1 X1 F1\n") + code), "alarm b2 undefined-code") << code;
  }
}

TEST(NgcCodes, ZerosAtTheEndOfACodeAreNone) {
  EXPECT_EQ(ending_of("G91.100000000000000000000"), "end x0 y0 z0 a0 c0");
  EXPECT_EQ(ending_of("G91.100000000000000000001"), "alarm b1 undefined-code");
  EXPECT_EQ(ending_of("G10000000000000000000000.0"), "alarm b1 undefined-code");
}

// What depends on the code is not: an arc lacks its centre, and nothing uses Q.
TEST(NgcCodes, ABlockWithAnUndefinedCodeIsCheckedWordByWord) {
  EXPECT_EQ(ending_of("G77 X1 X2 F-1 G2 G3 M10 Q1"),
            "alarm b1 undefined-code duplicate-word value-sign duplicate-word undefined-code");
  EXPECT_EQ(ending_of("G77 G2 X1 Q1"), "alarm b1 undefined-code");
}

TEST(NgcCodes, WhatIsNotCoveredGoesBeforeWhatIsWrong) {
  EXPECT_EQ(ending_of("G77 G87"), "not-covered b1 G87");
  EXPECT_EQ(ending_of("G77 B1"), "not-covered b1 B");
  EXPECT_EQ(ending_of("X1 X2 F-1 M19"), "not-covered b1 M19");
}

TEST(NgcCodes, TwoCodesOfAGroupAreADuplicate) {
  EXPECT_EQ(ending_of("G0 G1 X1 F1"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("F9 G1 G80"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("G17 G18"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("G20 G21"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("G90 G91"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("G90.1 G91.1"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("G61 G64"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("G4 G4 P1"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("G90 G91.1 G17 G21 G0 G4 P1"), "end x0 y0 z0 a0 c0");
}

TEST(NgcCodes, AnyLetterButGAndMTwiceIsADuplicate) {
  EXPECT_EQ(ending_of("G0 X1 X1"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("G0 X1 x2"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("S1 S2"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("F1 F2"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("G4 P1 P2"), "alarm b1 duplicate-word");
  EXPECT_EQ(ending_of("M3 M8"), "end x0 y0 z0 a0 c0");
}

TEST(NgcCodes, SpeedsAndToolsAreNotBelowZero) {
  EXPECT_EQ(ending_of("S-1"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("T-2"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G0 X1\nT1.5 X2"), "alarm b2 not-an-integer");
  EXPECT_EQ(path("S100.5 T0 M3\nG0 X1"), Lines{"rapid x1"});
}

// LinuxCNC 2.9 as measured alarms where these do; of P0 L1 Q0 it says "zero timeout".
TEST(NgcCodes, MFunctionsOfSignalsNeedTheirWords) {
  const std::pair<const char*, const char*> alarms[] = {
      {"M61", "missing-word"},
      {"M61 Q-1", "value-sign missing-word"},
      {"M62", "missing-word"},
      {"M65", "missing-word"},
      {"M66", "missing-word"},
      {"M66 L0", "missing-word"},
      {"M66 P0 E0", "conflicting-words"},
      {"M66 P-1", "value-sign missing-word"},
      {"M66 P0 L-1", "value-sign"},
      {"M66 P0 L0.5", "not-an-integer"},
      {"M66 P0 L1", "missing-word"},
      {"M66 P0 L1 Q0", "value-sign value-out-of-range"},
      {"M66 E0 L3 Q1", "conflicting-words value-out-of-range"},
      {"M67 Q1", "missing-word"},
      {"M68 E-1 Q1", "value-sign missing-word"}};
  for (const auto& [block, alarm] : alarms) {
    EXPECT_EQ(ending_of(block), fmt::format("alarm b1 {}", alarm)) << block;
  }
  for (const char* block : {"M62 P-1", "M62 P1.5", "M66 P0", "M66 P0 L5 Q1", "M67 E0", "M61 Q0"}) {
    EXPECT_EQ(ending_of(std::string(block) + "\nM2").substr(0, 3), "end") << block;
  }
}

TEST(NgcCodes, MFunctionsAreKnownOrNot) {
  for (int m : {0, 1, 3, 4, 5, 6, 7, 8, 9, 48, 49, 50, 53, 60, 70, 71, 73}) {
    EXPECT_EQ(lines("M" + std::to_string(m), ngc()), Lines{"m" + std::to_string(m)});
  }
  for (int m : {10, 29, 31, 47, 54, 59, 69, 74, 97, 200, 99999}) {
    EXPECT_EQ(ending_of("M" + std::to_string(m)), "alarm b1 undefined-code") << m;
  }
  for (int m : {99, 100, 199}) {
    EXPECT_EQ(ending_of("M" + std::to_string(m)), "not-covered b1 M" + std::to_string(m));
  }
  EXPECT_EQ(ending_of("M3.5"), "alarm b1 not-an-integer");
}

TEST(NgcCodes, OtherFormsOfTheLanguageAreNotCovered) {
  EXPECT_EQ(ending_of("o100 jump"), "not-covered b1 o-word");
  EXPECT_EQ(ending_of("M3 G33 Z-1 K1 $1"), "not-covered b1 spindle-word");
}

TEST(NgcCodes, ALineThatCannotBeReadIsASyntaxAlarm) {
  EXPECT_EQ(ending_of("G1 X"), "alarm b1 syntax");
  EXPECT_EQ(clauses("G1 X"), Lines{"NGC-COM-01"});
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
