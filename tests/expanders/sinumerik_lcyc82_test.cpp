// SPDX-License-Identifier: GPL-3.0-or-later
// LCYC82 in the expander of sinumerik802s.
#include <gtest/gtest.h>

#include "sinumerik_motions.hpp"
#include "sinumerik_outcomes.hpp"

namespace gonogo::expanders::testing {
namespace {

// The first part of the example of the manual, with R103=0: Z2, Z-17.5, 2 s, Z5.
TEST(SinumerikDrilling, TheExampleWithItsReferencePlaneAtZero) {
  const Outcome outcome = run_sinumerik802s(
      "G0 G17 G90 F200 S300 M3 T4 D1\nX60 Y40 Z5\nR101=5 R102=2 R103=0 R104=-17.5 R105=2\n"
      "LCYC82\nX0\n");
  EXPECT_EQ(moving(outcome),
            "rapid x=60 y=40 z=5\nrapid z=2\nfeed z=-17.5 f=200\ndwell 2\nrapid z=5\nrapid x=0\n");
  EXPECT_EQ(outcome.alarms, 0u);
}

// R103=9 puts the clearance at 11, above R101=5.
TEST(SinumerikDrilling, TheExampleAsPrintedIsRefused) {
  EXPECT_EQ(alarm_and_block("F200\nR101=5 R102=2 R103=9 R104=-17.5 R105=2\nLCYC82\n"),
            "reference-plane 3");
}

TEST(SinumerikDrilling, GoesAlongTheThirdAxisInTheFrame) {
  EXPECT_EQ(moving(run_sinumerik802s("F9 G19\nG158 X10 Y1\nR101=3 R104=-1 R102=1\nLCYC82\n")),
            "rapid x=11\nfeed x=9 f=9\nrapid x=13\n");
}

TEST(SinumerikDrilling, PlanesOnTheBorder) {
  EXPECT_EQ(alarm_and_block("F9 R101=1 R102=1 R104=-1\nLCYC82\n"), "");
  EXPECT_EQ(alarm_and_block("F9 R101=0.3 R102=0.1 R103=0.2\nLCYC82\n"), "");
  EXPECT_EQ(alarm_and_block("F9 R101=0.999 R102=1 R104=-1\nLCYC82\n"), "reference-plane 2");
  EXPECT_EQ(alarm_and_block("F9 R101=1 R104=0\nLCYC82\n"), "reference-plane 2");
  EXPECT_EQ(alarm_and_block("F9\nLCYC82\n"), "reference-plane 2");
}

TEST(SinumerikDrilling, RulesOfItsNumbers) {
  EXPECT_EQ(alarm_and_block("F9 R101=1 R104=-1 R105=-1\nLCYC82\n"), "value-sign 2");
  EXPECT_EQ(alarm_and_block("F9 R101=1 R104=-1 R102=-1\nLCYC82\n"), "value-sign 2");
  EXPECT_EQ(alarm_and_block("R101=1 R104=-1\nLCYC82\n"), "feed-missing 2");
  EXPECT_EQ(
      alarm_and_block("F9 R101=1 R104=-1\nLCYC82\n", R"({"readings":{"sie.spindle":"alarm"}})"),
      "spindle-stopped 2");
}

TEST(SinumerikDrilling, StandsAlone) {
  for (const char* block : {"LCYC82 X1", "LCYC82 R105=1", "G0 LCYC82", "LCYC82 M3", "T1 LCYC82",
                            "LCYC82 LCYC82", "LCYC75 LCYC82"}) {
    EXPECT_EQ(alarm_and_block("F9 R101=1 R104=-1\n" + std::string(block) + "\n"),
              "conflicting-words 2")
        << block;
  }
  EXPECT_EQ(alarm_and_block("F9 R101=1 R104=-1\nN20 LCYC82 ; here\n"), "");
  EXPECT_EQ(alarm_and_block("LCYC82=1\n"), "syntax 1");
}

TEST(SinumerikDrilling, LeavesModesAsTheyWere) {
  EXPECT_EQ(moving(run_sinumerik802s("G1 F9 G91\nR101=2 R104=-1\nLCYC82\nX1\n")),
            "feed z=-1 f=9\nrapid z=2\nfeed x=1 f=9\n");
}

TEST(SinumerikDrilling, Only802SHasIt) {
  EXPECT_EQ(run_sinumerik("LCYC82\n").answer, GONOGO_UNSUPPORTED);
  EXPECT_EQ(run_sinumerik("LCYC75 X5\n").answer, GONOGO_UNSUPPORTED);
  EXPECT_EQ(alarm_and_block("LCYC99\n"), "undefined-code 1");
  EXPECT_EQ(run_sinumerik802s("LCYC83\n").answer, GONOGO_UNSUPPORTED);
}

TEST(SinumerikDrilling, ThereAreThreeHundredParameters) {
  EXPECT_EQ(alarm_and_block("R299=1\nG0 X=R299\n"), "");
  EXPECT_EQ(alarm_and_block("R300=1\n"), "value-out-of-range 1");
  EXPECT_EQ(alarm_and_block("G0 X=R300\n"), "value-out-of-range 1");
  EXPECT_EQ(run_sinumerik("R300=1\nG0 X=R300\n").alarms, 0u);
}

}  // namespace
}  // namespace gonogo::expanders::testing
