// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIE-ARC-07 and SIE-ARC-08 at their limits.
#include <gtest/gtest.h>

#include "sie_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

Profile limits(std::string_view most, std::string_view part) {
  Profile profile = sie();
  profile.parameters["CIRCLE_ERROR_CONST"] = num(most);
  profile.parameters["CIRCLE_ERROR_FACTOR"] = num(part);
  return profile;
}

// A quarter about (5,0): the end is (5,r), and the radius at the start 5.
TEST(SieArcCorrection, SmallRadiiMayDifferByAHundredth) {
  EXPECT_EQ(outcome("G2 X5 Y5.01 I5"), "end");
  EXPECT_EQ(outcome("G2 X5 Y5.011 I5"), "arc-end-point I");
  EXPECT_EQ(outcome("G2 X5 Y4.99 I5"), "end");
  EXPECT_EQ(outcome("G2 X5 Y4.989 I5"), "arc-end-point I");
  EXPECT_EQ(clauses("F9\nG2 X5 Y4.989 I5"), Lines{"SIE-ARC-07"});
}

TEST(SieArcCorrection, LargeRadiiMayDifferByAThousandth) {
  EXPECT_EQ(outcome("G2 X100 Y100.1 I100"), "end");
  EXPECT_EQ(outcome("G2 X100 Y100.101 I100"), "arc-end-point I");
  EXPECT_EQ(outcome("G2 X100 Y99.9 I100"), "end");
  EXPECT_EQ(outcome("G2 X100 Y99.899 I100"), "arc-end-point I");
}

// Radii 70.710678 and 7.0710678, with ends at (10,r) and (1,r) from the centre's foot.
TEST(SieArcCorrection, RootsAreDecidedWithoutThem) {
  EXPECT_EQ(outcome("G3 X140.781 Y10 I70 J10"), "end");              // 0.070322 of 0.0707107
  EXPECT_EQ(outcome("G3 X140.782 Y10 I70 J10"), "arc-end-point I");  // 0.071322
  EXPECT_EQ(outcome("G3 X14.081 Y1 I7 J1"), "end");                  // 0.009932 of 0.01
  EXPECT_EQ(outcome("G3 X14.082 Y1 I7 J1"), "arc-end-point I");      // 0.010932
}

TEST(SieArcCorrection, TheLimitsAreParametersOfTheMachine) {
  EXPECT_EQ(outcome("G2 X5 Y5.02 I5", limits("0.02", "0.001")), "end");
  EXPECT_EQ(outcome("G2 X5 Y5.021 I5", limits("0.02", "0.001")), "arc-end-point I");
  EXPECT_EQ(outcome("G2 X5 Y5.001 I5", limits("0", "0")), "arc-end-point I");
  EXPECT_EQ(outcome("G2 X5 Y5 I5", limits("0", "0")), "end");
  EXPECT_EQ(outcome("G2 X5 Y5.05 I5", limits("0", "0.01")), "end");
}

// Radii 5 and 5.004 on one line: the chord 10.004 is above twice 5.
TEST(SieArcCorrection, AChordAboveTwiceTheRadiusHasItsCentreInTheMiddle) {
  const std::string program = "G2 X10.004 I5 F9";
  EXPECT_EQ(line(program, 0), "arc x10.004 y0 c5.002,0 rot-1 f9");
  EXPECT_EQ(line(program, 0, sie({{"sie.arc.correct", "project"}})),
            "arc x10.004 y0 c5.002,0 rot-1 f9");
  EXPECT_EQ(line(program, 0, sie({{"sie.arc.correct", "programmed"}})),
            "arc x10.004 y0 c5,0 rot-1 f9");
  EXPECT_EQ(clauses(program), Lines{"SIE-ARC-08"});
}

// Half the chord is 4.998, and 25 - 4.998^2 = 0.019996, whose root is 0.141407213...
TEST(SieArcCorrection, ACentreOnTheChordGoesToTheShorterArc) {
  EXPECT_EQ(centre(last_motion("G3 X9.996 I5 F9")), "4.998000000,0.141407213");
  EXPECT_EQ(centre(last_motion("G2 X9.996 I5 F9")), "4.998000000,-0.141407213");
}

// (3,4) and the end (6.004,0): 5 at the start, sqrt(25.024016) = 5.0024 at the end; the middle is
// (3.002,0), and 25 - 3.002^2 = 15.987996, whose root is 3.9984992...: above, as the centre is.
TEST(SieArcCorrection, TheCentreStaysOnItsSide) {
  EXPECT_EQ(centre(last_motion("G2 X6.004 I3 J4 F9")), "3.002000000,3.998499218");
  EXPECT_EQ(centre(last_motion("G3 X6.004 I3 J4 F9")), "3.002000000,3.998499218");
  EXPECT_EQ(centre(last_motion("G3 X6.004 I3 J-4 F9")), "3.002000000,-3.998499218");
  EXPECT_EQ(line("G2 X6.004 I3 J4 F9", 0, sie({{"sie.arc.correct", "project"}})),
            "arc x6.004 y0 c3.002,4 rot-1 f9");
}

// The end is 10 - 2 e on the line of the centre at 5: the angle at the start is acos(1 - e/5), and
// at most the root of 0.001 where e <= 5 (1 - cos 0.0316227766) = 0.00249979167..., so that
// X >= 9.99500041665...
TEST(SieArcCorrection, TheCentreMovesByAnAngleOfTheRootOfAThousandth) {
  EXPECT_EQ(outcome("G2 X9.995000417 I5"), "end");
  EXPECT_EQ(outcome("G2 X9.995000416 I5"), "arc-end-point I");
  EXPECT_EQ(clauses("F9\nG2 X9.995 I5"), Lines{"SIE-ARC-08"});
  EXPECT_EQ(outcome("G2 X9.995 I5", sie({{"sie.arc.correct", "project"}})), "end");
  EXPECT_EQ(outcome("G2 X9.995 I5", sie({{"sie.arc.correct", "programmed"}})), "end");
}

TEST(SieArcCorrection, TheReadingMattersOnlyWhereTheRadiiDiffer) {
  EXPECT_EQ(touched("F9 S1 M3\nG2 X10 I5\nG2 I5"), Lines{});
  EXPECT_EQ(touched("F9 S1 M3\nG2 X10.001 I5"), Lines{"sie.arc.correct"});
  EXPECT_EQ(touched("F9 S1 M3\nG2 X10.1 I5"), Lines{});
}

// From SINUMERIK ONE: 14.99967 at the start, 15 at the end, two more turns.
TEST(SieArcCorrection, AHelixIsCorrectedToo) {
  const Record helix =
      last_motion("G0 X27.5 Y32.99 Z-5\nG3 X20 Y5 Z-20 I=AC(20) J=AC(20) TURN=2 F9");
  EXPECT_EQ(helix.rot, 3);
  const Number p = helix.centre[0] - num("27.5");
  const Number q = helix.centre[1] - num("32.99");
  EXPECT_EQ(p * p + q * q, num("224.9901"));
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
