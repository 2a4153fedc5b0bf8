// SPDX-License-Identifier: GPL-3.0-or-later
//
// G02 and G03 in the plane of Z and X.
#include <gtest/gtest.h>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

// The textbook's example 7. R15 from (Z0, X0) to (Z-24, X12 true): with the centre (Z-15, X0) the
// end lies at (-9)^2 + 12^2 = 15^2. Then R5 clockwise from (-24, 12) to (-31, 13): the centre
// (-27, 16) lies 3-4-5 from the start and (-4, -3) from the end.
TEST(HncArc, CutsTheArcsOfTheTextbook) {
  EXPECT_EQ(path("%3000\nN10 T0101\nN20 M03 S500\nN30 G00 X40 Z5\nN40 G00 X0\nN50 G01 Z0 F60\n"
                 "N60 G03 U24 W-24 R15\nN70 G02 X26 Z-31 R5\nN80 G01 Z-40\nN90 G00 X40 Z5\n"
                 "N100 M05\nN110 M30"),
            (Lines{"rapid x20 z5", "rapid x0", "feed z0 f60", "arc x12 z-24 c-15,0 rot1 f60",
                   "arc x13 z-31 c-27,16 rot-1 f60", "feed z-40 f60", "rapid x20 z5"}));
}

// I is a true length along X, K along Z, from the start, under G90 and G91.
TEST(HncArc, TakesItsCentreFromTheStart) {
  const Lines want = {"rapid x10 z0", "arc x0 z10 c0,0 rot-1 f100"};
  EXPECT_EQ(path("G00 X20 Z0\nG02 X0 Z10 I-10 K0 F100"), want);
  EXPECT_EQ(path("G00 X20 Z0\nG91 G02 X-20 Z10 I-10 F100"), want);
  EXPECT_EQ(path("G37 G00 X10 Z0\nG02 X0 Z10 I-10 F100"), want);
}

TEST(HncArc, TurnsFullyWithoutAnEnd) {
  EXPECT_EQ(path("G00 X20 Z0\nG02 I-10 F100").at(1), "arc x10 z0 c0,0 rot-1 f100");
}

TEST(HncArc, RBeatsIAndK) {
  EXPECT_EQ(path("G00 X20 Z0\nG02 X0 Z10 I99 K99 R10 F100").at(1), "arc x0 z10 c0,0 rot-1 f100");
}

TEST(HncArc, RefusesWhatIsNoArc) {
  EXPECT_EQ(ending_of("G02 X20 Z10 F100"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G02 X0 Z0 R5 F100"), "alarm b1 arc-end-point");
  EXPECT_EQ(ending_of("G02 X0 Z10 R4.999 F100"), "alarm b1 arc-radius");
  EXPECT_EQ(ending_of("G02 X0 Z10 R5 F100"), "end x0 y0 z10 a0 c0");
  EXPECT_EQ(ending_of("G02 X0 Z10 R5"), "alarm b1 feed-missing");
}

// From (Z10, X0) about the origin; the end is 0.01 or 0.011 off.
TEST(HncArc, TheRadiiMayDifferByParameter3410) {
  EXPECT_EQ(ending_of("G00 Z10\nG03 X20.02 Z0 K-10 F100"), "end x10.01 y0 z0 a0 c0");
  EXPECT_EQ(ending_of("G00 Z10\nG03 X20.022 Z0 K-10 F100"), "alarm b2 arc-end-point");
  Profile profile = hnc();
  profile.parameters["3410"] = 0;
  EXPECT_EQ(ending_of("G00 Z10\nG03 X20 Z0 K-10 F100", profile), "end x10 y0 z0 a0 c0");
  EXPECT_EQ(ending_of("G00 Z10\nG03 X20.002 Z0 K-10 F100", profile), "alarm b2 arc-end-point");
  profile.parameters["3410"] = -1;
  EXPECT_EQ(ending_of("G00 Z10\nG03 X90 Z0 K-10 F100", profile), "end x45 y0 z0 a0 c0");
}

TEST(HncArc, ARadiusOfZeroIsAnAlarmOrNoMotion) {
  const Profile none = hnc({{"hnc.arc.zero-radius", "none"}});
  EXPECT_EQ(ending_of("G02 X0 Z0 I0 K0 F100"), "alarm b1 arc-radius");
  EXPECT_EQ(path("G02 X0 Z0 I0 K0 F100", none), Lines{});
  EXPECT_EQ(ending_of("G02 X0 Z5 I0 K0 F100"), "alarm b1 arc-radius arc-end-point");
  EXPECT_EQ(ending_of("G02 X0 Z5 I0 K0 F100", none), "alarm b1 arc-end-point");
  Profile any_end = hnc();
  any_end.parameters["3410"] = -1;
  EXPECT_EQ(ending_of("G02 X0 Z5 I0 K0 F100", any_end), "alarm b1 arc-radius");
  // However near its end is: within parameter 3410.
  EXPECT_EQ(ending_of("G02 X0 Z0.005 I0 K0 F100"), "alarm b1 arc-radius");
}

TEST(HncArc, RWithTheEndAtTheStartIsAnAlarmOrNoMotion) {
  const Profile none = hnc({{"hnc.arc.closed", "none"}});
  const std::string closed = "G00 X20 Z5\nG02 X20 Z5 R5 F100\nG00 Z0";
  EXPECT_EQ(ending_of(closed), "alarm b2 arc-end-point");
  EXPECT_EQ(path(closed, none), (Lines{"rapid x10 z5", "rapid z0"}));
  EXPECT_EQ(touched(closed), Lines{"hnc.arc.closed"});
  EXPECT_EQ(ending_of("G02 X0 Z0 R5", none), "alarm b1 feed-missing");
}

// The chord is 20.02 and 20.021: half of it is 0.01 and more than R.
TEST(HncArc, ARThatIsALittleTooSmallIsASemicircleUnderItsReading) {
  const Profile half = hnc({{"hnc.arc.small-radius", "semicircle"}});
  EXPECT_EQ(path("G02 X0 Z20.02 R10 F100", half), Lines{"arc x0 z20.02 c10.01,0 rot-1 f100"});
  EXPECT_EQ(path("G03 X0 Z20.02 R-10 F100", half), Lines{"arc x0 z20.02 c10.01,0 rot1 f100"});
  EXPECT_EQ(ending_of("G02 X0 Z20.02 R10 F100"), "alarm b1 arc-radius");
  EXPECT_EQ(ending_of("G02 X0 Z20.021 R10 F100", half), "alarm b1 arc-radius");
  Profile wide = half;
  wide.parameters["3410"] = 1;
  EXPECT_EQ(ending_of("G02 X0 Z22 R10 F100", wide), "end x0 y0 z22 a0 c0");
  wide.parameters["3410"] = -1;
  EXPECT_EQ(ending_of("G02 X0 Z20.02 R10 F100", wide), "alarm b1 arc-radius");
  EXPECT_EQ(touched("G02 X0 Z20.02 R10 F100"), Lines{"hnc.arc.small-radius"});
  EXPECT_EQ(touched("G02 X0 Z20.021 R10 F100"), Lines{});
  EXPECT_EQ(touched("G02 X0 Z20 R10 F100"), Lines{});
}

TEST(HncArc, MovesNothingWithoutWords) {
  EXPECT_EQ(path("G02\nG03"), Lines{});
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
