// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs of the textbooks as they stand, damage and all: how each ends.
#include <gtest/gtest.h>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

// Z30 is a misprint for Z-30: the last pass goes the wrong way, and nothing forbids it.
TEST(Programs, TheTaperOfExample9AsPrinted) {
  const std::string text =
      "%\nO0230\nN1 T0101\nN2 G90 G00 X50 Z4 M03\nN3 G80 X40.5 Z-30I-8.5 F100\nN4 X36 Z-30I-8.5\n"
      "N5 X31.5 Z-30I-8.5\nN6 X27 Z-30I-8.5\nN7 X25 Z30I-8.5 F 40\nN8 G00 X50 Z50\nN9 M05\n"
      "N10 M30\n%";
  EXPECT_EQ(ending_of(text), "end x25 y0 z50 a0 c0");
  EXPECT_EQ(path(text).at(18), "feed x12.5 z30 f40");
}

TEST(Programs, CompoundCyclesAreNotCovered) {
  const std::string head = "%4000\nN1 T0101\nN2 M03 S500\nN3 G00 X80 Z80\nN4 X46 Z3\n";
  EXPECT_EQ(path(head + "N5 G71 U2 R1 P6 Q14 X0.4 Z0.1 F100\nN6 G00 X0"),
            (Lines{"rapid x40 z80", "rapid x23 z3", "not-covered b6 G71"}));
  EXPECT_EQ(ending_of(head + "N4 G72 W1.5 R1 P5 Q14 X0.2 Z0.5 F100"), "not-covered b6 G72");
  EXPECT_EQ(ending_of(head + "N4 G73 U3 W0.9 R3"), "not-covered b6 G73");
  EXPECT_EQ(ending_of(head + "N15 G70 P6 Q14"), "not-covered b6 G70");
}

TEST(Programs, WhatStandsBehindAProgramIsNotRun) {
  EXPECT_EQ(ending_of("%1\nG00 X50\n%\nG00 X40 X30\n"), "end x25 y0 z0 a0 c0");
  EXPECT_EQ(ending_of("%1\nG00 X50\n%2\nG00 X40\n"), "not-covered b3 program-head");
  EXPECT_EQ(ending_of("O1\nG00 X50\nO2\nG00 X40\n"), "not-covered b3 program-head");
}

TEST(Programs, Example16IsReadUpToG76) {
  const Lines got = path(
      "O3338\nN1 T0101\nN2 G90 G00 X100 Z100\nN3 M03 S400\nN4 G00 X90 Z4\n"
      "N5 G80 X61.125 Z-30 I-0.94 F80\nN6 G00 X100 Z100 M05\nN7 T0202\nN8 M03 S300\n"
      "N9 G00 X90 Z4\nN10 G76 P021360 Q100 R0.1");
  EXPECT_EQ(got, (Lines{"rapid x50 z100", "rapid x45 z4", "rapid x29.6225",
                        "feed x30.5625 z-30 f80", "feed x45 f80", "rapid z4", "rapid x50 z100",
                        "rapid x45 z4", "not-covered b11 G76"}));
}

TEST(Programs, AStraightContour) {
  const Lines want = {"rapid x50 z10",  "feed x8 z2 f100",    "feed x13 z-3 f100",
                      "feed z-48 f100", "feed x30 z-58 f100", "feed x40 z-73 f100",
                      "feed x45 f100",  "rapid x50 z10"};
  EXPECT_EQ(path("%1000\nN10 T0101\nN20 M03 S500\nN30 G00 X100 Z10\nN40 G01 X16 Z2 F100\n"
                 "N50 G01 X26 Z-3\nN60 Z-48\nN70 X60 Z-58\nN80 X80 Z-73\nN90 X90\n"
                 "N100 G00 X100 Z10"),
            want);
}

// The printed programs of G90, G91 and G36 feed without an F.
TEST(Programs, FeedsWithoutAnFAreAlarms) {
  EXPECT_EQ(ending_of("%0001\nN1 G92X0Z0\nN2 G01X15Z20\nN3 X45Z40"), "alarm b3 feed-missing");
  EXPECT_EQ(ending_of("%3341\nN1 G92X180Z254\nN2 G36G01X20W-44"), "alarm b3 feed-missing");
}

TEST(Programs, ThoseOfMillsAreNotCovered) {
  EXPECT_EQ(ending_of("G91 G02 X30 Y30 R30 F300"), "not-covered b1 Y");
  EXPECT_EQ(ending_of("%\nO1008\nN10 G92 X-10 Y-10 Z50\nN20 G90 G17"), "not-covered b3 Y");
  EXPECT_EQ(ending_of("%\nO7528\nN10 G00 G54 G90 X40 Y30 Z50 M03 S800;\nN20 G98 G81 X40"),
            "not-covered b3 Y");
}

// The grooving and the dwell of the shaft.
TEST(Programs, AGrooveByHand) {
  EXPECT_EQ(path("N26 M03 S300\nN27 G00 X90\nN28 Z-50\nN29 X54\nN30 G01 X44 F10\nN31 G04 P4000\n"
                 "N32 G01 X90\nN33 G00 X100 Z80\nN34 M05\nN35 M30\nN36 T0200"),
            (Lines{"rapid x45", "rapid z-50", "rapid x27", "feed x22 f10", "dwell 4",
                   "feed x45 f10", "rapid x50 z80"}));
}

// Inputs of the newer manual.
TEST(Programs, ADrillAndAGroove) {
  EXPECT_EQ(path("G01 X0 Z10 F500\nG74 Z-60 R1 Q5 F1000").size(), 29U);
  // 20 of radius in pecks of 5: 4 pecks, 3 withdrawals, out.
  EXPECT_EQ(path("G01 X50 Z50 F500\nG75 X10 R1 Q5 F1000").size(), 9U);
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
