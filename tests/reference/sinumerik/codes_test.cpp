// SPDX-License-Identifier: GPL-3.0-or-later
//
// The codes and names of the control: SIE-MOD-01, SIE-MOD-02, SIE-MOD-05.
#include <gtest/gtest.h>

#include <set>

#include "reference/dialect.hpp"
#include "s802_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

TEST(SieCodes, CodesWithoutEffectAreIgnored) {
  EXPECT_EQ(
      path("G9 G40 G53 G54 G60 G500 X1\nG55\nG56\nG57\nG64 G601\nG602 T1 D1 H5=12 S9 M6 X2 G0")
          .size(),
      1U);
  EXPECT_EQ(path("G0 G9 G40 G53 G54 G60 G601 T1 D0 H5=12 S9 M6 X2"), Lines{"rapid x2"});
  EXPECT_EQ(path("G0 SUPA X2"),
            Lines{"rapid x2"});  // no zero offset is read that it could suppress
}

// The spindle stands or turns where it is told to; without a radius compensation a contour has no
// corners to go round and is approached as it stands.
TEST(SieCodes, SpindlePositionsAndCornersLeaveThePath) {
  EXPECT_EQ(path("G500\nSPCON\nG0 X1\nSPCOF\nSPOSA=90\nWAITS\nX2"),
            (Lines{"rapid x1", "rapid x2"}));
  EXPECT_EQ(path("G450 NORM G0 X1\nG451 KONT X2"), (Lines{"rapid x1", "rapid x2"}));
}

TEST(SieCodes, OutsideCodesAreNotCovered) {
  for (const char* code : {"G33",     "G41",  "G75",     "G93",    "G153",   "G331",    "G603",
                           "G505",    "G550", "G599",    "G641",   "G700",   "G962",    "TRANS",
                           "AMIRROR", "RPL",  "POCKET4", "HOLES1", "LCYC60", "LCYC840", "P"}) {
    const std::string value = std::string(code) == "P" ? "1" : "";
    EXPECT_EQ(outcome("X1 " + std::string(code) + value), "not-covered " + std::string(code));
  }
  for (const int code : {5,   7,   58,  59,  140, 141, 142, 143, 335, 336, 460, 461, 462, 621,
                         643, 644, 645, 751, 810, 815, 819, 820, 829, 931, 942, 952, 972, 973}) {
    const std::string name = (code < 10 ? "G0" : "G") + std::to_string(code);
    EXPECT_EQ(outcome("X1 " + name), "not-covered " + name);
    EXPECT_EQ(outcome("X1 " + name, s802()), "not-covered " + name);
  }
  EXPECT_EQ(outcome("G22", s802()), "not-covered G22");
  EXPECT_EQ(outcome("G23 X1", s802()), "not-covered G23");
  EXPECT_EQ(outcome("CYCLE800(1,2)"), "not-covered CYCLE800");
  EXPECT_EQ(outcome("G1 B5"), "not-covered B");
  EXPECT_EQ(outcome("L10"), "not-covered L");
  EXPECT_EQ(outcome("X1=5"), "not-covered X1");
  EXPECT_EQ(outcome("S2=500"), "not-covered S2");
  EXPECT_EQ(outcome("M2=3"), "not-covered M2");
}

TEST(SieCodes, CodesThatTheControlLacksAreAlarms) {
  for (const char* code : {"G6", "G8", "G20", "G21", "G22", "G23", "G52", "G80", "G158", "G258",
                           "G259", "G504", "G600", "G1.5", "G999", "G100000"}) {
    EXPECT_EQ(outcome(code), "undefined-code G") << code;
  }
  EXPECT_EQ(outcome("LCYC99"), "undefined-code LCYC99");
  EXPECT_EQ(clauses("LCYC99"), Lines{"SIE-MOD-02"});
}

TEST(SieCodes, TheCyclesOfThe802SAreNotCoveredOnThe840D) {
  for (const std::string_view name : {"LCYC75", "LCYC82", "LCYC83"}) {
    EXPECT_EQ(outcome(name), "not-covered " + std::string(name));
    EXPECT_EQ(outcome(std::string(name) + " X5"), "not-covered " + std::string(name));
  }
}

// A subprogram or a variable of the machine's owner may have any name, an axis any free letter.
TEST(SieCodes, NamesOfTheOwnerAreNotCovered) {
  for (const std::string_view name : {"CIPX10", "CYCLE", "FOO", "_CALL", "SETAL", "WORKPIECE"}) {
    EXPECT_EQ(outcome(std::string(name)), "not-covered " + std::string(name));
    EXPECT_EQ(outcome("X1 " + std::string(name) + "(1,\"A\")"), "not-covered " + std::string(name));
  }
  EXPECT_EQ(outcome("DEPTH=R1+2"), "not-covered DEPTH");
  EXPECT_EQ(outcome("E5"), "not-covered E");
  EXPECT_EQ(outcome("E=IC(0.25)"), "not-covered E");
  EXPECT_EQ(outcome("I2=5"), "not-covered I2");
  EXPECT_EQ(outcome("L1=5"), "not-covered L1");
}

TEST(SieCodes, WhatIsNotCoveredGoesBeforeWhatIsWrong) {
  EXPECT_EQ(outcome("G1 X1 X2 G6 TRANS"), "not-covered TRANS");
  EXPECT_EQ(outcome("G1 X1 X2 G6 LCYC99"), "undefined-code G, undefined-code LCYC99");
}

TEST(SieCodes, TwoCodesOfAGroupAreAnAlarm) {
  for (const char* codes : {"G0 G1", "G17 G18", "G54 G500", "G60 G64", "G601 G602", "G70 G71",
                            "G90 G91", "G94 G95", "G4 G110", "G110 G111", "G1 G1"}) {
    EXPECT_EQ(outcome(codes).substr(0, 16), "duplicate-word G") << codes;
  }
  EXPECT_EQ(outcome("G1 CIP"), "duplicate-word CIP");
  EXPECT_EQ(outcome("CIP CT"), "duplicate-word CT");
  EXPECT_EQ(outcome("CT G2"), "duplicate-word G");
  EXPECT_EQ(outcome("G9 G60 G601 G53 G54 G40"), "end");
  EXPECT_EQ(clauses("G0 G1"), Lines{"SIE-MOD-05"});
}

TEST(SieCodes, NamesThatAreIgnoredAreWarnedOf) {
  const std::string program = "MSG(\"X5\") G0 X1\nSTOPRE\nLIMS=500 SOFT";
  const Profile profile = sie();
  grammar::MemorySource bytes(program);
  grammar::LineSource source(bytes);
  Expander expander(profile, source, OpenPaths::shown);
  std::vector<std::string> names;
  expander.on_warning([&](const Warning& warning, const grammar::Line& text) {
    names.push_back(std::to_string(text.number) + " " +
                    warning.message.substr(0, warning.message.find(' ')));
  });
  while (expander.next() != nullptr) {
  }
  EXPECT_EQ(names, (std::vector<std::string>{"1 MSG", "2 STOPRE", "3 LIMS", "3 SOFT"}));
}

TEST(SieCodes, ConstructsThatAreNotReadAreNotCovered) {
  EXPECT_EQ(outcome("IF R1==5 GOTOF ENDE"), "not-covered control-statement");
  EXPECT_EQ(outcome("X=POT(2)"), "not-covered expression");
  EXPECT_EQ(outcome("T=\"MILL\""), "not-covered string");
}

TEST(SieCodes, TheHeadAndCommentsOfALineSayNothing) {
  EXPECT_EQ(path("%_N_PART_MPF\n; G5\nN10 START1: G0 X1 ; Y2\n:20 x2"),
            (Lines{"rapid x1", "rapid x2"}));
}

// SIE-LEX-04: behind a block another program begins.
TEST(SieCodes, ALineWithAPercentSignBehindABlockEndsTheProgram) {
  EXPECT_EQ(path("%\n%_N_A_MPF\nN5\n%\nG0 X1\n%_N_B_SPF\nX2"), Lines{"rapid x1"});
  EXPECT_EQ(outcome_of_program("G0 X1\n%\nLCYC99"), "end");
}

// SIE-LEX-01; SIE-LEX-03: that the 802S has them too, is ours.
TEST(SieCodes, AmpersandsAreBlanks) {
  for (const Profile& profile : {sie(), s802()}) {
    EXPECT_EQ(path("G0&X1\n&\nY=&2", profile), (Lines{"rapid x1", "rapid y2"}));
  }
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
