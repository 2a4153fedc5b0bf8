// SPDX-License-Identifier: GPL-3.0-or-later
// Lines, dwells, units, distances, feeds and the order of words of the expander of rs274.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

TEST(NgcLine, RapidAndFeed) {
  EXPECT_EQ(run_ngc("G0 X1 Y2\nG1 Z-3 F100\n").motions(), "rapid x=1 y=2\nfeed z=-3 f=100\n");
}

TEST(NgcLine, AxisWordsRepeatTheMode) {
  EXPECT_EQ(run_ngc("G1 X1 F9\nY2\nG0 Z3\nX4\n").motions(),
            "feed x=1 f=9\nfeed y=2 f=9\nrapid z=3\nrapid x=4\n");
}

TEST(NgcLine, CodeWithoutAxisWordDoesNothing) {
  EXPECT_EQ(run_ngc("F9 G0\nG1\nG1 S9\nG0 X1\n").motions(), "rapid x=1\n");
}

TEST(NgcLine, IncrementsAddUp) {
  EXPECT_EQ(run_ngc("G91 G0 X1 Y1\nX-3\nG90 X5\n").motions(),
            "rapid x=1 y=1\nrapid x=-2\nrapid x=5\n");
}

TEST(NgcLine, InchesAre25Point4Millimetres) {
  // 0.5 in = 12.7 mm; 2 in = 50.8 mm.
  EXPECT_EQ(run_ngc("G20\nG0 X0.5 Z-2\nG21 X1\n").motions(), "rapid x=12.7 z=-50.8\nrapid x=1\n");
}

TEST(NgcLine, RotaryAxesAreDegrees) {
  EXPECT_EQ(run_ngc("G20\nG0 A90 C-45.5\n").motions(), "rapid a=90 c=-45.5\n");
}

TEST(NgcFeed, InchesAMinute) {
  EXPECT_EQ(run_ngc("G20\nG1 X1 F10\n").motions(), "feed x=25.4 f=254\n");
}

// F acts before the units of its block: 10 mm a minute.
TEST(NgcFeed, ActsBeforeTheUnitsOfItsBlock) {
  EXPECT_EQ(run_ngc("G20 G1 X1 F10\n").motions(), "feed x=25.4 f=10\n");
}

TEST(NgcFeed, KeepsItsSpeedWhenTheUnitsChange) {
  EXPECT_EQ(run_ngc("G20\nF10\nG21\nG1 X1\n").motions(), "feed x=1 f=254\n");
}

TEST(NgcFeed, OfARotaryAxisAloneIsAsWritten) {
  EXPECT_EQ(run_ngc("G20\nG1 A90 F10\nX0 C5\nX1 A0\n").motions(),
            "feed a=90 f=10\nfeed x=0 c=5 f=10\nfeed x=25.4 a=0 f=254\n");
}

TEST(NgcFeed, ActsBeforeTheMotionWhereverItStands) {
  EXPECT_EQ(run_ngc("F5\nX1 F9 G1\n").motions(), "feed x=1 f=9\n");
}

TEST(NgcOrder, OfTheLineDoesNotMatter) {
  EXPECT_EQ(run_ngc("G0 X3\nX5 I1 F7 G2 Z2 G18 G91 K0\n").motions(),
            run_ngc("G0 X3\nF7 G18 G91 G2 X5 Z2 I1 K0\n").motions());
  EXPECT_EQ(run_ngc("F8\nI1 X2 G2\n").motions(), run_ngc("F8\nG2 X2 I1\n").motions());
}

TEST(NgcDwell, PIsSeconds) {
  EXPECT_EQ(run_ngc("G4 P1.5\nG4 P0\n").motions(), "dwell 1.5\n");
}

TEST(NgcDwell, LeavesTheMotionCode) {
  EXPECT_EQ(run_ngc("G1 X1 F9\nG4 P2\nX3\n").motions(), "feed x=1 f=9\ndwell 2\nfeed x=3 f=9\n");
}

TEST(NgcDwell, ComesBeforeTheMotionOfItsBlock) {
  EXPECT_EQ(run_ngc("G1 X1 F9\nX2 G4 P3\nG0 X4 G4 P5\n").motions(),
            "feed x=1 f=9\ndwell 3\nfeed x=2 f=9\ndwell 5\nrapid x=4\n");
}

TEST(NgcFunction, StopsComeAfterTheMotion) {
  EXPECT_EQ(run_ngc("G0 X1 M0\nX2 M3 M8\nX3 M5\nX4 M60\n").motions(),
            "rapid x=1\nm 0\nm 3\nm 8\nrapid x=2\nm 5\nrapid x=3\nrapid x=4\nm 60\n");
}

TEST(NgcFunction, TwoEndAProgram) {
  EXPECT_EQ(run_ngc("G0 X1 M2\nX2\n").all(),
            "answer 0\n1 rapid x=1\n1 m 2\n1 end x=1 y=0 z=0 a=0 c=0\n");
  EXPECT_EQ(run_ngc("M30\nG999\n").motions(), "m 30\n");
}

TEST(NgcMode, CodesWithoutEffectAreAccepted) {
  EXPECT_EQ(run_ngc("G17 G21 G40 G49 G54 G64 G90 G91.1 G94 G97 G98 S900 T1 M6\n"
                    "G61\nG61.1\nG99\nG0 X1\n")
                .motions(),
            "m 6\nrapid x=1\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
