// SPDX-License-Identifier: GPL-3.0-or-later
//
// G02 and G03 (GSK-COM-05): the centre by R or by I J K, what is refused, full circles, helices.
// I, J, K and R are true lengths; X and U words are diameters.
#include <gtest/gtest.h>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

// The second record of a program: its arc.
Record arc_of(std::string_view program, const Profile& profile = {}) {
  const std::vector<Item> items = expand(program, profile);
  if (items.size() < 2 || !std::holds_alternative<Record>(items[1]) ||
      std::get<Record>(items[1]).kind != RecordKind::arc) {
    ADD_FAILURE() << program << ": " << line_of(items.back());
    return {};
  }
  return std::get<Record>(items[1]);
}

TEST(Arc, InG18CounterclockwiseIsSeenWithZRightAndXUp) {
  // R15 from (Z0, X0) to (Z-24, X12 true): with the centre (Z-15, X0) the end lies at
  // (-9)^2 + 12^2 = 15^2 and the short way round turns from 0 to 126.87 degrees.
  const Lines want = {"rapid x0 z0", "arc x12 z-24 c-15,0 rot1 f100"};
  EXPECT_EQ(lines("G0 X0 Z0\nG3 U24 W-24 R15 F100"), want);
  EXPECT_EQ(arc_of("G0 X0 Z0\nG3 U24 W-24 R15 F100").plane, Plane::g18);
}

TEST(Arc, TheSameEndClockwiseHasItsCentreOnTheOtherSide) {
  // The mirror image of (-15, 0) in the chord from (0, 0) to (-24, 12), whose direction is
  // (-2, 1)/sqrt(5): 2 (c.u) u - c = 2 x 6 x (-2, 1) - (-15, 0) = (-9, 12).
  const Lines want = {"rapid x0 z0", "arc x12 z-24 c-9,12 rot-1 f100"};
  EXPECT_EQ(lines("G0 X0 Z0\nG2 U24 W-24 R15 F100"), want);
}

TEST(Arc, InG17TheFirstAxisIsX) {
  // A quarter counterclockwise about the origin from (10, 0) to (0, 10).
  const Lines want = {"rapid x10 y0", "arc x0 y10 c0,0 rot1 f100"};
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 X0 Y10 R10 F100"), want);
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 X0 Y10 I-10 J0 F100"), want);
  EXPECT_EQ(arc_of("G17 G0 X20 Y0\nG3 X0 Y10 R10 F100").plane, Plane::g17);
}

TEST(Arc, InG19TheFirstAxisIsY) {
  const Lines want = {"rapid y10 z0", "arc y0 z10 c0,0 rot1 f100"};
  EXPECT_EQ(lines("G19 G0 Y10 Z0\nG3 Y0 Z10 R10 F100"), want);
  EXPECT_EQ(lines("G19 G0 Y10 Z0\nG3 Y0 Z10 J-10 K0 F100"), want);
  EXPECT_EQ(arc_of("G19 G0 Y10 Z0\nG3 Y0 Z10 R10 F100").plane, Plane::g19);
}

TEST(Arc, InG18KGoesWithZAndIWithX) {
  // From (Z10, X0) a quarter counterclockwise about (Z0, X0) to (Z0, X10 true).
  const Lines want = {"rapid x0 z10", "arc x10 z0 c0,0 rot1 f100"};
  EXPECT_EQ(lines("G0 X0 Z10\nG3 X20 Z0 K-10 I0 F100"), want);
}

TEST(Arc, AnOffsetThatIsLeftOutIsZero) {
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 X0 Y10 I-10 F100"),
            lines("G17 G0 X20 Y0\nG3 X0 Y10 I-10 J0 F100"));
  EXPECT_EQ(lines("G17 G0 X0 Y-10\nG3 X20 Y0 J10 F100"),
            lines("G17 G0 X0 Y-10\nG3 X20 Y0 I0 J10 F100"));
}

TEST(Arc, IIsNoDiameter) {
  // X20 is a radius of 10, I-10 leads to the axis.
  EXPECT_EQ(arc_of("G17 G0 X20 Y0\nG2 I-10 F100").centre[0], num("0"));
  EXPECT_EQ(arc_of("G0 X20 Z0\nG2 I-10 F100").centre[1], num("0"));
}

TEST(Arc, RBeatsIJK) {
  // The centre (99, 99) of the offsets would be refused.
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 X0 Y10 I89 J99 R10 F100"),
            lines("G17 G0 X20 Y0\nG3 X0 Y10 R10 F100"));
}

TEST(Arc, AnR0BesideOffsetsIsStillR) {
  EXPECT_EQ(ending("G17 G0 X20 Y0\nG3 X0 Y10 I-10 R0 F100"), "alarm b2 arc-radius");
}

TEST(Arc, NeitherRNorAnOffsetIsAMissingWord) {
  EXPECT_EQ(ending("G17 G0 X20 Y0\nG3 X0 Y10 F100"), "alarm b2 missing-word");
}

// Parameter 3403#5.
TEST(Arc, NeitherRNorAnOffsetIsAStraightFeedUnderItsReading) {
  const Profile line = profile_with({{"gsk.arc.no-centre", "line"}});
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 X0 Y10 F100\nX10 Z5", line),
            (Lines{"rapid x10 y0", "feed x0 y10 f100", "feed x5 z5 f100"}));
  EXPECT_EQ(ending("G17 G0 X20 Y0\nG3 X0 Y10", line), "alarm b2 feed-missing");
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 X0 Y10 R10 F100", line),
            lines("G17 G0 X20 Y0\nG3 X0 Y10 R10 F100"));
  EXPECT_EQ(touched_readings("G17 G0 X20 Y0\nG3 X0 Y10 F100"), Lines{"gsk.arc.no-centre"});
  EXPECT_EQ(touched_readings("G17 G0 X20 Y0\nG3 X0 Y10 R10 F100"), Lines{});
}

// Parameter 3403#4: the radius of the semicircle and R are no farther apart than parameter 3410.
TEST(Arc, ARThatIsALittleTooSmallIsASemicircleUnderItsReading) {
  const auto end = [](const std::string& y, Profile profile, const char* tolerance = nullptr) {
    if (tolerance != nullptr) profile.parameters["3410"] = num(tolerance);
    return ending("G17 G0 X0 Y0\nG2 Y" + y + " R10 F100", profile);
  };
  const Profile half = profile_with({{"gsk.arc.small-radius", "semicircle"}});
  EXPECT_EQ(end("20.02", half), "end x0 y20.02 z0 a0 c0");
  EXPECT_EQ(end("20.021", half), "alarm b2 arc-radius");
  EXPECT_EQ(end("21", half, "0.5"), "end x0 y21 z0 a0 c0");
  EXPECT_EQ(end("21.001", half, "0.5"), "alarm b2 arc-radius");
  EXPECT_EQ(end("20.001", half, "0"), "alarm b2 arc-radius");
  EXPECT_EQ(end("20.02", {}), "alarm b2 arc-radius");
  // Its centre is the middle of the chord, whatever the sign of R is.
  for (const char* r : {"10", "-10"}) {
    EXPECT_EQ(lines(std::string("G17 G0 X0 Y0\nG3 Y20.02 F100 R") + r, half)[1],
              "arc x0 y20.02 c0,10.01 rot1 f100");
  }
}

TEST(Arc, ASmallRadiusIsAskedOfWhereTheParameterAllowsIt) {
  EXPECT_EQ(touched_readings("G17 G2 Y20.02 R10 F100"), Lines{"gsk.arc.small-radius"});
  EXPECT_EQ(touched_readings("G17 G2 Y20.021 R10 F100"), Lines{});
  EXPECT_EQ(touched_readings("G17 G2 Y20 R10 F100"), Lines{});
}

TEST(Arc, RWithTheEndAtTheStartMovesNothingInThePlaneUnderItsReading) {
  const Profile none = profile_with({{"gsk.arc.closed", "none"}});
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 X20 Y0 R10 F100\nG0 Y5", none),
            (Lines{"rapid x10 y0", "rapid y5"}));
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 R10 Z-2 F100", none),
            (Lines{"rapid x10 y0", "feed z-2 f100"}));
  EXPECT_EQ(ending("G17 G3 X0 Y0 R10", none), "alarm b1 feed-missing");
  EXPECT_EQ(touched_readings("G17 G3 X0 Y0 R10 F100"), Lines{"gsk.arc.closed"});
}

// Parameters 3403#4 and 3403#5: 0 runs, 1 alarms.
TEST(Arc, TheParametersOfTheMachineDecideOverTheReadings) {
  const std::string small = "G17 G0 X0 Y0\nG2 Y20.02 R10 F100";
  const std::string bare = "G17 G0 X20 Y0\nG3 X0 Y10 F100";
  Profile runs = profile_with({{"gsk.arc.small-radius", "alarm"}, {"gsk.arc.no-centre", "alarm"}});
  runs.parameters["3403.4"] = runs.parameters["3403.5"] = num("0");
  EXPECT_EQ(lines(small, runs).back(), "arc x0 y20.02 c0,10.01 rot-1 f100");
  EXPECT_EQ(lines(bare, runs).back(), "feed x0 y10 f100");
  EXPECT_EQ(ending("G17 G0 X0 Y0\nG2 Y20.021 R10 F100", runs), "alarm b2 arc-radius");
  Profile alarms =
      profile_with({{"gsk.arc.small-radius", "semicircle"}, {"gsk.arc.no-centre", "line"}});
  alarms.parameters["3403.4"] = alarms.parameters["3403.5"] = num("1");
  EXPECT_EQ(ending(small, alarms), "alarm b2 arc-radius");
  EXPECT_EQ(ending(bare, alarms), "alarm b2 missing-word");
}

TEST(Arc, RWithTheEndAtTheStartIsRefused) {
  EXPECT_EQ(ending("G17 G0 X20 Y0\nG3 X20 Y0 R10 F100"), "alarm b2 arc-end-point");
  EXPECT_EQ(ending("G17 G0 X20 Y0\nG3 R10 F100"), "alarm b2 arc-end-point");
  // A depth alone does not make it another point of the plane.
  EXPECT_EQ(ending("G17 G0 X20 Y0\nG3 Z5 R10 F100"), "alarm b2 arc-end-point");
}

TEST(Arc, TwiceRMayNotBeBelowTheChord) {
  // Chord 20 from (-10, 0) to (10, 0).
  const std::string start = "G17 G0 X-20 Y0\nG2 X20 Y0 F100 R";
  EXPECT_EQ(ending(start + "9.999"), "alarm b2 arc-radius");
  EXPECT_EQ(ending(start + "10"), "end x10 y0 z0 a0 c0");
  EXPECT_EQ(ending(start + "10.001"), "end x10 y0 z0 a0 c0");
  EXPECT_EQ(ending(start + "-9.999"), "alarm b2 arc-radius");
  EXPECT_EQ(ending(start + "-10"), "end x10 y0 z0 a0 c0");
}

TEST(Arc, OfHalfTheChordTheCentreIsItsMiddle) {
  for (const char* r : {"10", "-10"}) {
    const Record arc = arc_of(std::string("G17 G0 X-20 Y0\nG2 X20 Y0 F100 R") + r);
    EXPECT_EQ(arc.centre[0], num("0")) << r;
    EXPECT_EQ(arc.centre[1], num("0")) << r;
  }
}

TEST(Arc, OneIncrementAboveTheCentreIsARoot) {
  // Half chord 10, R 10.001: the distance is sqrt(10.001^2 - 10^2) = sqrt(0.020001), to the right
  // of the way from (-10, 0) to (10, 0) on the short clockwise arc.
  const Record arc = arc_of("G17 G0 X-20 Y0\nG2 X20 Y0 R10.001 F100");
  EXPECT_EQ(arc.centre[0], num("0"));
  EXPECT_EQ(arc.centre[1], Number::root(0, -1, num("0.020001")));
}

TEST(Arc, ANegativeRIsTheArcAboveHalfATurn) {
  // From (10, 0) to (0, 10): about (0, 0) a quarter counterclockwise, about (10, 10) three.
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 X0 Y10 R10 F100")[1], "arc x0 y10 c0,0 rot1 f100");
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 X0 Y10 R-10 F100")[1], "arc x0 y10 c10,10 rot1 f100");
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG2 X0 Y10 R10 F100")[1], "arc x0 y10 c10,10 rot-1 f100");
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG2 X0 Y10 R-10 F100")[1], "arc x0 y10 c0,0 rot-1 f100");
}

// From (10, 0) about (0, 0) to a point of the negative X axis whose radius is `radius`; the X word
// is twice that.
std::string to_radius(const std::string& diameter, const Profile& profile = {}) {
  return ending("G17 G0 X20 Y0\nG3 X-" + diameter + " Y0 I-10 J0 F100", profile);
}

TEST(Arc, TheRadiiMayDifferByAHundredth) {
  EXPECT_EQ(to_radius("20.018"), "end x-10.009 y0 z0 a0 c0");
  EXPECT_EQ(to_radius("20.02"), "end x-10.01 y0 z0 a0 c0");
  EXPECT_EQ(to_radius("20.022"), "alarm b2 arc-end-point");
  EXPECT_EQ(to_radius("19.98"), "end x-9.99 y0 z0 a0 c0");
  EXPECT_EQ(to_radius("19.978"), "alarm b2 arc-end-point");
}

TEST(Arc, Parameter3410SaysByHowMuchTheRadiiMayDiffer) {
  Profile profile;
  profile.parameters["3410"] = num("0.5");
  EXPECT_EQ(to_radius("21", profile), "end x-10.5 y0 z0 a0 c0");
  EXPECT_EQ(to_radius("21.002", profile), "alarm b2 arc-end-point");
  profile.parameters["3410"] = num("0.001");
  EXPECT_EQ(to_radius("20.002", profile), "end x-10.001 y0 z0 a0 c0");
  EXPECT_EQ(to_radius("20.004", profile), "alarm b2 arc-end-point");
}

TEST(Arc, Parameter3410OfZeroChecksNothing) {
  Profile profile;
  profile.parameters["3410"] = num("0");
  EXPECT_EQ(to_radius("40", profile), "end x-20 y0 z0 a0 c0");
}

TEST(Arc, TheDifferenceOfRadiiIsDecidedWithoutRounding) {
  // Start radius 5. The end (3.006, 4.008) lies at 5 x 1.002 = 5.01 exactly; 1e-9 more is refused.
  const std::string start = "G17 G0 X10 Y0\nG3 I-5 J0 F100 ";
  EXPECT_EQ(ending(start + "X6.012 Y4.008"), "end x3.006 y4.008 z0 a0 c0");
  EXPECT_EQ(ending(start + "X6.012 Y4.008000001"), "alarm b2 arc-end-point");
}

TEST(Arc, WhereTheRadiiDifferTheCentreIsKept) {
  const Record arc = arc_of("G17 G0 X20 Y0\nG3 X-20.02 Y0 I-10 J0 F100");
  EXPECT_EQ(arc.centre[0], num("0"));
  EXPECT_EQ(arc.centre[1], num("0"));
  EXPECT_EQ(arc.to[Axis::x], num("-10.01"));
}

TEST(Arc, WithTheEndAtTheStartOffsetsMakeAFullCircle) {
  const Lines want = {"rapid x10 y0", "arc x10 y0 c0,0 rot-1 f100"};
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG2 X20 Y0 I-10 J0 F100"), want);
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG2 I-10 F100"), want);
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG2 U0 I-10 F100"), want);
}

TEST(Arc, ACounterclockwiseFullCircleInEachPlane) {
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 I-10 F100")[1], "arc x10 y0 c0,0 rot1 f100");
  EXPECT_EQ(lines("G18 G0 Z10 X0\nG3 K-10 F100")[1], "arc x0 z10 c0,0 rot1 f100");
  EXPECT_EQ(lines("G19 G0 Y10 Z0\nG3 J-10 F100")[1], "arc y10 z0 c0,0 rot1 f100");
}

TEST(Arc, TheDepthAxisMakesAHelix) {
  EXPECT_EQ(lines("G17 G0 X20 Y0 Z5\nG2 I-10 Z3 F100")[1], "arc x10 y0 z3 c0,0 rot-1 f100");
  EXPECT_EQ(lines("G18 G0 X0 Z10 Y5\nG3 X20 Z0 K-10 Y2 F100")[1], "arc x10 y2 z0 c0,0 rot1 f100");
  EXPECT_EQ(lines("G19 G0 Y10 Z0 X8\nG3 Y0 Z10 R10 U-2 F100")[1], "arc x3 y0 z10 c0,0 rot1 f100");
}

TEST(Arc, TheDepthDoesNotCountInTheDifferenceOfRadii) {
  EXPECT_EQ(ending("G17 G0 X20 Y0\nG3 X-20 Y0 Z500 I-10 J0 F100"), "end x-10 y0 z500 a0 c0");
}

TEST(Arc, NeedsAFeed) {
  EXPECT_EQ(ending("G17 G0 X20 Y0\nG3 X0 Y10 R10"), "alarm b2 feed-missing");
  EXPECT_EQ(ending("G17 G0 X20 Y0\nG3 X0 Y10"), "alarm b2 feed-missing missing-word");
}

TEST(Arc, IsModal) {
  const Lines want = {"rapid x10 y0", "arc x0 y10 c0,0 rot1 f100", "arc x-10 y0 c0,0 rot1 f100"};
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 X0 Y10 R10 F100\nX-20 Y0 R10"), want);
}

TEST(Arc, IncrementsCountFromTheStart) {
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG3 U-20 V10 R10 F100"),
            lines("G17 G0 X20 Y0\nG3 X0 Y10 R10 F100"));
}

TEST(Arc, InInchesRAndTheOffsetsAreInInches) {
  const Lines want = {"rapid x25.4 y0", "arc x0 y25.4 c0,0 rot1 f254"};
  EXPECT_EQ(lines("G20 G17 G0 X2 Y0\nG3 X0 Y1 R1 F10"), want);
  EXPECT_EQ(lines("G20 G17 G0 X2 Y0\nG3 X0 Y1 I-1 F10"), want);
}

// Found by generated programs (seed 307643): after a thread that ends at an angle the position is
// an enclosure, of which equal radii cannot be told to be equal; that they agree can.
TEST(Arc, ItsRadiiAreComparedAlsoWhereThePositionIsOnlyEnclosed) {
  const std::string thread =
      "G17 G0 X20 Y0 Z6 F100\nG117 X51 Y39.71 W-0.512 I1.024 E40.72 P1.975 D5.001 Q0.988 J0.725 "
      "K250\n";
  EXPECT_TRUE(ending(thread + "G03 I2 U4 V2").starts_with("end"));
  EXPECT_EQ(ending(thread + "G03 I2 U4 V2.1"), "alarm b3 arc-end-point");
}

TEST(Arc, InFeedPerRevolution) {
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG99 G3 X0 Y10 R10 F0.2")[1], "arc x0 y10 c0,0 rot1 f0.2/rev");
}

TEST(Arc, WithoutAnyWordNothingMoves) {
  const Lines want = {"rapid x10 y0"};
  EXPECT_EQ(lines("G17 G0 X20 Y0\nG2"), want);
}

}  // namespace
}  // namespace gonogo::reference::testing
