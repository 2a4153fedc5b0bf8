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

// Z-0.5 inch is Z-12.7, and is -2.54; the tool stands at Z 5.08. C lies at X40, a radius of
// 20.
TEST(OpenPoints, OtherUnitsKeepRetainedWordsOrClearThemOrLeaveTheirNumbers) {
  const std::string program = "G20 G00 X4 Z0.2\nG94 X2 Z-0.5 R-0.1 F5\nG21 X40 F100";
  const auto third = [&](const char* alternative) {
    const Lines all = lines(program, profile_with({{"gsk.retained", alternative}}));
    return Lines(all.begin() + 5, all.begin() + 7);
  };
  EXPECT_EQ(third("keep"), (Lines{"rapid z-15.24", "feed x20 z-12.7 f100"}));
  EXPECT_EQ(third("clear"), (Lines{"rapid z5.08", "feed x20 z5.08 f100"}));
  EXPECT_EQ(third("number"), (Lines{"rapid z-0.6", "feed x20 z-0.5 f100"}));
}

// In G17 the cycle has X and Y; behind G18 again Z and X.
TEST(OpenPoints, AnotherPlaneKeepsRetainedWordsOrClearsThemOrThoseOutsideIt) {
  const std::string program = "G00 X100 Y10 Z5\nG94 X60 Z-10 F100\nG17 Y5\nG18 X50";
  const Profile clear = profile_with({{"gsk.retained", "clear"}});
  const Profile in_plane = profile_with({{"gsk.retained", "in-plane"}});
  EXPECT_EQ(lines(program).at(5), "rapid x30");
  EXPECT_EQ(lines(program, clear).at(5), "rapid x50");
  EXPECT_EQ(lines(program, in_plane).at(5), "rapid x30");
  EXPECT_EQ(lines(program, in_plane).at(10), "feed x25 z5 f100");
  EXPECT_EQ(lines(program).at(10), "feed x25 z-10 f100");
  EXPECT_EQ(lines(program, clear).at(10), "feed x25 z5 f100");
  EXPECT_EQ(lines("G94 X60 Z-10 F100\nG18 G21 X50", clear).at(5), "feed x25 z-10 f100");
}

// 5 inches a minute are 127 mm, and 127 mm times 25.4 are 3225.8.
TEST(OpenPoints, OtherUnitsLeaveTheFeedOrItsNumber) {
  const Profile number = profile_with({{"gsk.feed-units", "number"}});
  EXPECT_EQ(lines("G20 F5\nG21 G01 X40"), Lines{"feed x20 f127"});
  EXPECT_EQ(lines("G20 F5\nG21 G01 X40", number), Lines{"feed x20 f5"});
  EXPECT_EQ(lines("F127\nG20 G01 X2", number), Lines{"feed x25.4 f3225.8"});
  EXPECT_EQ(lines("G20 F5\nG21 G01 X40 F9", number), Lines{"feed x20 f9"});
}

TEST(OpenPoints, AnotherKindOfFeedLeavesItsNumberOrTakesItAway) {
  const Profile deleted = profile_with({{"gsk.feed-change", "deleted"}});
  EXPECT_EQ(lines("F100\nG99 G01 X20"), Lines{"feed x10 f100/rev"});
  EXPECT_EQ(ending("F100\nG99 G01 X20", deleted), "alarm b2 feed-missing");
  EXPECT_EQ(lines("F100\nG99 G01 X20 F0.2", deleted), Lines{"feed x10 f0.2/rev"});
  EXPECT_EQ(lines("F100\nG98 G01 X20", deleted), Lines{"feed x10 f100"});
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
