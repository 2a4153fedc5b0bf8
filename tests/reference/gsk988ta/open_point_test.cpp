// SPDX-License-Identifier: GPL-3.0-or-later
//
// Readings of points that neither the manual nor its reading decides: the default and the others.
#include <gtest/gtest.h>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

TEST(OpenPoints, WordsOfACuttingCycleOutliveAMillingCycleOrNot) {
  const std::string program = "G00 X100 Z5\nG94 X0 Z0 F100\nG110 I8 L3 Q5 D4\nG94 X20";
  EXPECT_EQ(lines(program).at(6), "feed x10 z0 f100");
  EXPECT_EQ(lines(program, profile_with({{"gsk.g94.in-mode", "clear"}})).at(6), "feed x10 z5 f100");
}

TEST(OpenPoints, APocketWithoutDepthEndsAtTheInitialOrTheRPlane) {
  const std::string program = "G110 X0 Z0 Y-5 R-5 I8 L3 Q5 D4";
  EXPECT_EQ(ending(program, profile_with({{"gsk.pocket.end", "r-plane"}})), "end x0 y0 z0 a0 c0");
  EXPECT_EQ(ending(program, profile_with({{"gsk.pocket.end", "r-plane"},
                                          {"gsk.zero-depth-end", "r-plane"}})),
            "end x0 y-5 z0 a0 c0");
  EXPECT_EQ(ending(program, profile_with({{"gsk.zero-depth-end", "r-plane"}})),
            "end x0 y0 z0 a0 c0");
}

TEST(OpenPoints, ADwellWithoutATimeIsAnAlarmOrNothing) {
  EXPECT_EQ(ending("G04"), "alarm b1 missing-word");
  EXPECT_EQ(lines("G04", profile_with({{"gsk.dwell-without-word", "none"}})), Lines{});
}

TEST(OpenPoints, AnArcWithoutRadiusIsAnAlarmOrNoMotionInThePlane) {
  const Profile none = profile_with({{"gsk.arc.zero-radius", "none"}});
  EXPECT_EQ(ending("G02 X0 Z0 I0 K0 F100"), "alarm b1 arc-radius");
  EXPECT_EQ(lines("G02 X0 Z0 I0 K0 F100", none), Lines{});
  // From the centre to elsewhere the radii differ as well, which parameter 3410 (0.01 mm) does not
  // admit.
  EXPECT_EQ(ending("G02 X0 Z5 I0 K0 F100"), "alarm b1 arc-radius arc-end-point");
  EXPECT_EQ(ending("G02 X0 Z5 I0 K0 F100", none), "alarm b1 arc-end-point");
  // Nor does an angle lead from the centre to an end within that. Found by fuzz_differential_gsk.
  EXPECT_EQ(ending("G02 X0 Z0.005 I0 K0 F100"), "alarm b1 arc-radius");
  EXPECT_EQ(lines("G02 X0 Z0 Y5 I0 K0 F100", none), (Lines{"feed x0 y5 z0 f100"}));
}

// Radii 5 and 5.5 round Z5: compared only under `exact`.
TEST(OpenPoints, AZeroToleranceSwitchesTheCheckOffOrIsExact) {
  Profile profile;
  profile.parameters["3410"] = 0;
  EXPECT_EQ(lines("G02 X0 Z10.5 K5 F100", profile).size(), 1U);
  ASSERT_FALSE(set_reading(profile, "gsk.arc.tolerance-zero", "exact"));
  EXPECT_EQ(ending("G02 X0 Z10.5 K5 F100", profile), "alarm b1 arc-end-point");
  EXPECT_EQ(lines("G02 X0 Z10 K5 F100", profile).size(), 1U);
}

TEST(OpenPoints, DecimalsAreThoseOfTheValue) {
  const Profile alarm = profile_with({{"gsk.decimals", "alarm"}});
  EXPECT_EQ(lines("G00 X1.5000", alarm), (Lines{"rapid x0.75"}));
  EXPECT_EQ(ending("G00 X1.5001", alarm), "alarm b1 value-out-of-range");
}

// Entered at Y50; G50 calls that Y10. The R plane is 5 below.
TEST(OpenPoints, G50RenamesTheInitialPlaneOrKeepsItsCoordinate) {
  const std::string program = "G00 Y50\nG110 I8 L3 Q5 D4 F100\nG50 Y10\nX0 Z0 Y0 R-5";
  EXPECT_EQ(lines(program).at(3), "rapid y5");
  EXPECT_EQ(lines(program, profile_with({{"gsk.g50.initial-plane", "kept"}})).at(3), "rapid y45");
}

TEST(OpenPoints, TheInchFeedOfALoneRotaryAxisIsScaledOrInDegrees) {
  const Profile degrees = profile_with({{"gsk.rotary-feed-inch", "degrees"}});
  EXPECT_EQ(lines("G20 G01 C90 F10"), (Lines{"feed c90 f254"}));
  EXPECT_EQ(lines("G20 G01 C90 F10", degrees), (Lines{"feed c90 f10"}));
  EXPECT_EQ(lines("G20 G01 X2 C90 F10", degrees), (Lines{"feed x25.4 c90 f254"}));
  EXPECT_EQ(lines("G21 G01 C90 F10", degrees), (Lines{"feed c90 f10"}));
}

}  // namespace
}  // namespace gonogo::reference::testing
