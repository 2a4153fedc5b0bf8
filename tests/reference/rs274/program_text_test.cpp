// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the documents of LinuxCNC 2.9 say of lines, and of words that nothing uses. Programs and
// alarms are those that LinuxCNC and NIST's interpreter were measured with.
#include <gtest/gtest.h>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

const Profile kNeeded = ngc({{"ngc.program-end", "needed"}});

TEST(NgcProgram, ASecondTapeMarkEndsIt) {
  EXPECT_EQ(path("%\nG0 X1\n%\nX2", kNeeded), Lines{"rapid x1"});
  EXPECT_EQ(path("\n  %  \nG0 X1\n%\ngarbage (", kNeeded), Lines{"rapid x1"});
  EXPECT_EQ(path("%\n(head)\n\nN5\n%\nG0 X1", kNeeded), Lines{});
}

TEST(NgcProgram, ATapeMarkStandsNowhereElse) {
  EXPECT_EQ(ending_of("G0 X1\n%\nX2"), "alarm b2 syntax");
  for (const char* line : {"(text)", ";", "/", "N1", "O1", "/G0 X1"}) {
    EXPECT_EQ(ending_of(std::string(line) + "\n%\n"), "alarm b2 syntax") << line;
  }
  EXPECT_EQ(ending_of("% text"), "alarm b1 syntax");
  Profile skips = ngc();
  skips.block_skip = true;
  EXPECT_EQ(ending_of("/G0 X1\n%\n", skips), "alarm b2 syntax");
}

TEST(NgcProgram, ATextEndsWithItsProgram) {
  EXPECT_EQ(path("G0 X1\nX2", kNeeded), (Lines{"rapid x1", "rapid x2", "alarm b2 program-end"}));
  EXPECT_EQ(ending_of("", kNeeded), "alarm b1 program-end");
  EXPECT_EQ(ending_of("(text)", kNeeded), "alarm b1 program-end");
  EXPECT_EQ(ending_of("%", kNeeded), "alarm b1 program-end");
  EXPECT_EQ(ending_of("%\nG0 X1", kNeeded), "alarm b2 program-end");
  EXPECT_EQ(ending_of("G0 X1\n\n", kNeeded), "alarm b2 program-end");
  EXPECT_EQ(ending_of("G1 X1", kNeeded), "alarm b1 feed-missing");
  EXPECT_EQ(path("G0 X1\nM2\ngarbage here", kNeeded), Lines{"rapid x1"});
  EXPECT_EQ(path("G0 X1\nM30\nG0 X2", kNeeded), Lines{"rapid x1"});
  EXPECT_EQ(path("%\nG0 X1"), Lines{"rapid x1"});
}

TEST(NgcProgram, AnAbortEndsIt) {
  EXPECT_EQ(ending_of("G0 X1\n(abort, no part)\nM2"), "alarm b2 program-end");
  EXPECT_EQ(ending_of("G0 X1\nX2 ( A Bort ,) M2"), "alarm b2 program-end");
  EXPECT_EQ(path("G0 X1\nX2 (abort, no)\nM2"), (Lines{"rapid x1", "alarm b2 program-end"}));
  EXPECT_EQ(ending_of("G0 X1\n(abort, no) ; why\nM2"), "alarm b2 program-end");
  // The last comment in brackets alone is looked at, and a line that does not run has none.
  EXPECT_EQ(path("(abort, no)(note) G0 X1\n(aborts,)\nX2 ;(abort, no)\nM2"),
            (Lines{"rapid x1", "rapid x2"}));
  EXPECT_EQ(path("o1 if [0]\n(abort, no)\no1 endif\nG0 X1\nM2"), Lines{"rapid x1"});
}

TEST(NgcProgram, LineNumbersHaveNoMeaning) {
  const Profile whole = ngc({{"ngc.line-number", "whole"}});
  for (const char* number : {"N10.5", "N10.50", "N999999999", "N100000"}) {
    const std::string block = std::string(number) + " G0 X1";
    EXPECT_EQ(path(block), Lines{"rapid x1"}) << number;
    EXPECT_EQ(ending_of(block, whole), "alarm b1 syntax") << number;
    EXPECT_EQ(touched(block), (Lines{"ngc.line-number", "ngc.program-end"})) << number;
  }
  EXPECT_EQ(path("N99999 G0 X1", whole), Lines{"rapid x1"});
  EXPECT_EQ(touched("N99999 G0 X1\nM2"), Lines{});
  for (const char* block : {"N10. G0 X1", "N10.5.5", "N-10", "N10 N20", "G0 X1 N10"}) {
    EXPECT_EQ(ending_of(block), "alarm b1 syntax") << block;
  }
}

TEST(NgcProgram, OAndANumberAloneAreItsName) {
  const Profile syntax = ngc({{"ngc.o-name", "syntax"}});
  for (const char* line : {"O0002 (TEXT)", "O0002", "o2;"}) {
    const std::string text = "G0 X1\n" + std::string(line) + "\nX2\nM2";
    EXPECT_EQ(path(text), (Lines{"rapid x1", "rapid x2"})) << line;
    EXPECT_EQ(ending_of(text, syntax), "alarm b2 syntax") << line;
    EXPECT_EQ(touched(text), Lines{"ngc.o-name"}) << line;
  }
  EXPECT_EQ(ending_of("O0002 G0 X1"), ending_of("O100 jump"));
}

TEST(NgcWords, BlanksMeanNothing) {
  EXPECT_EQ(path("N 1 0 G 0 X- 5\nX+ 5\nX 1 . 5\nX 1 5"),
            (Lines{"rapid x-5", "rapid x5", "rapid x1.5", "rapid x15"}));
}

TEST(NgcWords, OneThatNothingUsesAlarms) {
  for (const char* word : {"I2", "J2", "K2", "R2", "P2", "Q2", "L2", "D2", "H2", "E2"}) {
    const std::string block = "G0 X1 " + std::string(word);
    EXPECT_EQ(ending_of(block), "alarm b1 unused-word") << word;
    EXPECT_EQ(clauses(block), Lines{"NGC-COM-02"}) << word;
    EXPECT_EQ(ending_of(word), "alarm b1 unused-word") << word;
  }
  for (const char* block : {"S100 I2", "G17 I2", "M3 S100 P2", "G61 P1", "T1 H1", "G40 D1"}) {
    EXPECT_EQ(ending_of(block), "alarm b1 unused-word") << block;
  }
  EXPECT_EQ(ending_of("F9\nG2 X2 I1\nP2"), "alarm b3 unused-word");
  EXPECT_EQ(ending_of("F9\nG2 X2 I1\nR2"), "alarm b3 unused-word");
  EXPECT_EQ(ending_of("F9\nG2 X2 I1 Q2"), "alarm b2 unused-word");
}

// As rs274 of LinuxCNC 2.9 takes and refuses them.
TEST(NgcWords, ThoseOfMFunctionsAreUsed) {
  for (const char* block : {"G64 P0.01 Q0.01", "G64 Q0.1", "M66 P0 L3 Q1", "M66 E0 L0", "M67 E0 Q1",
                            "M68 E0 Q1", "M61 Q0", "M62 P0", "M65 P0", "M50 P0", "M53 P1"}) {
    EXPECT_EQ(touched(std::string(block) + "\nM2"), Lines{}) << block;
  }
  for (const char* block :
       {"M62 P0 Q1", "M50 Q1", "M67 E0 P1 Q1", "M3 P1", "M66 P0 D1", "M62 P0 L1", "M65 P0 E0",
        "M6 P1", "M61 Q0 L0", "M48 P1", "M71 P1", "M68 E0 Q1 L0"}) {
    EXPECT_EQ(ending_of(block), "alarm b1 unused-word") << block;
  }
}

TEST(NgcWords, OneThatNothingUsesMayBeIgnored) {
  const Profile ignored = ngc({{"ngc.unused-words", "ignored"}});
  EXPECT_EQ(path("G0 X1 I2\nR5\nP2", ignored), Lines{"rapid x1"});
  EXPECT_EQ(ending_of("X1 I2", ignored), "alarm b1 missing-word");
}

TEST(NgcWords, AMotionCodeAloneMayNeedAnAxis) {
  const Profile needs = ngc({{"ngc.bare-motion", "missing-word"}});
  for (const char* block : {"G0", "F9 G1", "G1", "G0 G4 P1"}) {
    EXPECT_EQ(ending_of(block, needs), "alarm b1 missing-word") << block;
  }
  EXPECT_EQ(path("G0\nX1\nG1 F9\nX2"), (Lines{"rapid x1", "feed x2 f9"}));
  EXPECT_EQ(ending_of("G1"), "alarm b1 feed-missing");
  EXPECT_EQ(touched("G1 X1 F9\nG4 P1\nS9\nM2"), Lines{});
  EXPECT_EQ(touched("G0\nM2"), Lines{"ngc.bare-motion"});
}

TEST(NgcWords, CentresAloneMayBeAnArc) {
  const Profile unused = ngc({{"ngc.arc-words-alone", "alarm"}});
  EXPECT_EQ(path("F9\nG2 X2 I1\nI1").back(), "arc x2 y0 c3,0 rot-1 f9");
  EXPECT_EQ(ending_of("F9\nG2 X2 I1\nI1", unused), "alarm b3 unused-word");
  EXPECT_EQ(touched("F9\nG2 X2 I1\nX4 I1\nM2"), Lines{});
}

TEST(NgcWords, G80BesideAnotherMotionMayBeForgotten) {
  const Profile ignored = ngc({{"ngc.g80-beside", "ignored"}});
  for (const char* block : {"G80 G0 X1", "G0 G80 X1", "X1 G0 G80"}) {
    const std::string text = std::string(block) + "\nX2\nM2";
    EXPECT_EQ(path(text, ignored), (Lines{"rapid x1", "rapid x2"})) << block;
    EXPECT_EQ(path(text), Lines{"alarm b1 duplicate-word"}) << block;
    EXPECT_EQ(touched(text), Lines{"ngc.g80-beside"}) << block;
  }
  EXPECT_EQ(ending_of("G0 X1\nG80 G80\nX2", ignored), "alarm b3 missing-word");
  EXPECT_EQ(path("G80 G0 G80 X1\nX2", ignored), (Lines{"rapid x1", "rapid x2"}));
  EXPECT_EQ(ending_of("G0 X1\nG0 G1 F9 X2", ignored), "alarm b2 duplicate-word");
  EXPECT_EQ(touched("G80 G0 G1 X1"), Lines{});
  EXPECT_EQ(path("G00 G17 G21 G40 G49 G80 G90\nX1", ignored), Lines{"rapid x1"});
}

// No text says how deep brackets may stand or how long a line may be.
TEST(NgcProgram, WhatTheGaugeAloneDoesNotReadIsNoAlarm) {
  const auto nested = [](std::size_t depth) {
    return "G0 X" + std::string(depth, '[') + "1" + std::string(depth, ']');
  };
  EXPECT_EQ(path(nested(64)), Lines{"rapid x1"});
  EXPECT_EQ(ending_of(nested(65)), "not-covered b1 nested-too-deep");
  EXPECT_EQ(ending_of("G0 X1" + std::string(std::size_t{1} << 20, ' ')),
            "not-covered b1 line-too-long");
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
