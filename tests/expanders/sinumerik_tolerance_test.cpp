// SPDX-License-Identifier: GPL-3.0-or-later
// Alarms of arcs in the expander of sinumerik840d, below, on and above their limits.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

std::string tolerance_alarm(const std::string& block, const char* profile = "{}") {
  const Outcome outcome = run_sinumerik("F9\n" + block + "\n", profile);
  return outcome.alarm + outcome.note;
}

// A quarter circle about (2, 0) from the origin: 0.01 mm counts.
TEST(SinumerikTolerance, SmallCirclesHaveTheConstant) {
  EXPECT_EQ(tolerance_alarm("G2 X2 Y2.01 I2"), "");
  EXPECT_EQ(tolerance_alarm("G2 X2 Y1.99 I2"), "");
  EXPECT_EQ(tolerance_alarm("G2 X2 Y2.011 I2"), "arc-end-point");
  EXPECT_EQ(tolerance_alarm("G2 X2 Y1.989 I2"), "arc-end-point");
}

// About (1000, 0): a thousandth of the radius at the start, 1 mm, counts.
TEST(SinumerikTolerance, LargeCirclesHaveTheFactor) {
  EXPECT_EQ(tolerance_alarm("G2 X1000 Y1001 I1000"), "");
  EXPECT_EQ(tolerance_alarm("G2 X1000 Y999 I1000"), "");
  EXPECT_EQ(tolerance_alarm("G2 X1000 Y1001.001 I1000"), "arc-end-point");
  EXPECT_EQ(tolerance_alarm("G2 X1000 Y998.999 I1000"), "arc-end-point");
}

TEST(SinumerikTolerance, MachineDataSetBoth) {
  const char* profile = R"({"parameters":{"CIRCLE_ERROR_CONST":"0.1","CIRCLE_ERROR_FACTOR":"0"}})";
  EXPECT_EQ(tolerance_alarm("G2 X2 Y2.1 I2", profile), "arc-end-point");  // turned by 0.05 rad
  EXPECT_EQ(tolerance_alarm("G2 X20 Y20.1 I20", profile), "");
  EXPECT_EQ(tolerance_alarm("G2 X20 Y20.101 I20", profile), "arc-end-point");
  EXPECT_EQ(tolerance_alarm("G2 X1000 Y1000.101 I1000", profile), "arc-end-point");
}

// 100 and 99.9 on a diameter: the new centre lies 3.16 off the line, acos(0.9995) = 0.031624 rad,
// and sqrt(0.001) = 0.031623. Nobody turns the programmed centre.
TEST(SinumerikTolerance, TheCentreTurnsByLessThanTheRootOfAThousandth) {
  EXPECT_EQ(tolerance_alarm("G2 X199.9 I100"), "arc-end-point");
  EXPECT_EQ(tolerance_alarm("G2 X199.901 I100"), "");
  EXPECT_EQ(tolerance_alarm("G2 X200.1 I100"), "");
  EXPECT_EQ(tolerance_alarm("G2 X199.9 I100", R"({"readings":{"sie.arc.correct":"programmed"}})"),
            "");
}

// The chord is 200.1: no circle of radius 100 reaches.
TEST(SinumerikTolerance, TooLongAChordHasTheCentreInItsMiddle) {
  const Outcome outcome = run_sinumerik("G2 X200.1 I100 F9\n");
  EXPECT_EQ(outcome.motions(), "arc17 c=100.05,0 rot=-1 x=200.1 y=0 f=9\n");
}

// Radius 100, chord 199.999, centre on the chord: with at most 180 degrees it lies to the right of
// a clockwise arc. sqrt(100^2 - 99.9995^2) = 0.3162274...
TEST(SinumerikTolerance, ACentreOnTheChordTakesTheShorterWay) {
  const Outcome outcome = run_sinumerik("G2 X199.999 I100 F9\nG0 X0\nG3 X199.999 I100\n");
  EXPECT_EQ(outcome.motions().substr(0, 26), "arc17 c=99.9995,-0.3162273");
  EXPECT_NE(outcome.motions().find("arc17 c=99.9995,0.3162273"), std::string::npos);
}

TEST(SinumerikTolerance, AnEqualEndIsAFullCircleAndTheNextOneIsNot) {
  EXPECT_EQ(run_sinumerik("G2 X0 Y0 I2 F9\n").motions(), "arc17 c=2,0 rot=-1 x=0 y=0 f=9\n");
  EXPECT_EQ(tolerance_alarm("G2 X0 Y0 CR=5"), "arc-end-point");
  EXPECT_EQ(tolerance_alarm("G2 X0.001 Y0 CR=5"), "");
  EXPECT_EQ(tolerance_alarm("G2 X0 Y0 AR=5"), "arc-end-point");
  EXPECT_EQ(tolerance_alarm("G2 X0 Y0.001 AR=5"), "");
}

TEST(SinumerikTolerance, ChordOfTwiceTheRadius) {
  EXPECT_EQ(tolerance_alarm("G2 X6 Y8 CR=5"), "");
  EXPECT_EQ(tolerance_alarm("G2 X6 Y8 CR=-5"), "");
  EXPECT_EQ(tolerance_alarm("G2 X6.001 Y8 CR=5"), "arc-radius");
  EXPECT_EQ(tolerance_alarm("G2 X6 Y8 CR=4.999"), "arc-radius");
}

TEST(SinumerikTolerance, ChordTolerance) {
  const char* profile = R"({"readings":{"sie.cr.tolerance":"const"}})";
  EXPECT_EQ(run_sinumerik("G2 X10.01 CR=5 F9\n", profile).motions(),
            "arc17 c=5.005,0 rot=-1 x=10.01 y=0 f=9\n");
  EXPECT_EQ(tolerance_alarm("G2 X10.011 CR=5", profile), "arc-radius");
}

// Half a turn about the pole: rounding must not move the centre, however large the circle.
TEST(SinumerikTolerance, RoundedPointsOnACircleStayOnIt) {
  for (const char* angle : {"20", "33.333", "45", "61"}) {
    const std::string program =
        "R1=" + std::string(angle) + "\nG0 RP=1000 AP=R1\nG3 RP=1000 AP=R1+180 F9\nG2 AP=R1+90\n";
    const std::string motions = run_sinumerik(program).motions();
    EXPECT_NE(motions.find("arc17 c=0,0 rot=1"), std::string::npos) << motions;
    EXPECT_NE(motions.find("arc17 c=0,0 rot=-1"), std::string::npos) << motions;
  }
}

TEST(SinumerikTolerance, RangeOfTheOpeningAngle) {
  const char* const refuses = R"({"readings":{"sie.ar.zero":"alarm"}})";
  for (const char* angle : {"0", "360", "-1", "361"}) {
    EXPECT_EQ(tolerance_alarm("G2 I2 AR=" + std::string(angle), refuses), "value-out-of-range")
        << angle;
    EXPECT_EQ(tolerance_alarm("G2 X2 AR=" + std::string(angle)), "value-out-of-range") << angle;
  }
  EXPECT_EQ(run_sinumerik("F9\nG2 I2 AR=0\nG1 X1\n").motions(), "feed x=1 f=9\n");
  EXPECT_EQ(tolerance_alarm("G2 I2 AR=0.001"), "");
  EXPECT_EQ(tolerance_alarm("G2 X2 AR=359.999"), "");
}

}  // namespace
}  // namespace gonogo::expanders::testing
