// SPDX-License-Identifier: GPL-3.0-or-later
// Flat and far arcs of the expander of sinumerik840d: they show every digit that gets lost. All
// numbers from 50 digits by another program.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "sinumerik_outcomes.hpp"

namespace gonogo::expanders::testing {
namespace {

const std::string kTooFlat = "An arc as flat as this is not implemented.";

// What the expander says of a program that it does not implement.
std::string note_of(const std::string& program) {
  return run_sinumerik(program, "{}").note;
}

/// How far the centre of the last arc is off, millimetres; infinite when there is none.
long double off_centre(const std::string& program, long double p, long double q) {
  const std::string record = last_motion_or_alarm(program);
  const std::size_t at = record.find("c=");
  if (!record.starts_with("arc") || at == std::string::npos) return INFINITY;
  char* rest = nullptr;
  const long double got_p = std::strtold(record.c_str() + at + 2, &rest);
  const long double got_q = std::strtold(rest + 1, nullptr);
  return std::hypot(got_p - p, got_q - q);
}

constexpr long double kClose = 1e-6L;

// Direction (1000, 0.001), way (1000, 0.0010001): across 1e-4, along 1000000.0000010001, and the
// centre lies along / across = 1e10 half chords to the left of the middle:
// 1500 - (0.0010001 * 10000000000.010001) / 2 = -4999000.00000500100005,
// 0.00150005 + (1000 * 10000000000.010001) / 2 = 5000000000005.00200005.
TEST(SinumerikFlatArc, AlmostStraightOnHasItsTrueCentre) {
  EXPECT_EQ(last_motion_or_alarm("G1 X1000 Y0.001 F9\nCT X2000 Y0.0020001\n"),
            "arc17 c=-4999000.000005001,5000000000005.00200005 rot=1 x=2000 y=0.0020001 f=9");
}

// 10140690700.2500010140691401, -1014059070025000101.40591401
TEST(SinumerikFlatArc, AlmostBehindHasItsTrueCentre) {
  EXPECT_EQ(last_motion_or_alarm("G1 X100000 Y0.001 F9\nCT X-700.5 Y-0.00000701\n"),
            "arc17 c=10140690700.250001014,-1014059070025000101.40591401 rot=-1 x=-700.5 "
            "y=-0.00000701 f=9");
}

// 0.5 and 0.0000005 are 0.0005 times the place before.
TEST(SinumerikFlatArc, ExactlyBehindIsAnAlarmAndACountBesideItIsNone) {
  EXPECT_EQ(last_motion_or_alarm("G1 X1000 Y0.001 F9\nCT X0.5 Y0.0000005\n"), "arc-tangent");
  EXPECT_EQ(last_motion_or_alarm("G1 X1000 Y0.001 F9\nCT X0.5 Y0.000000501\n").substr(0, 6),
            "arc17 ");
}

// 500000 / tan(0.0005 degrees) = 57295779511.6278798334621626987
TEST(SinumerikFlatArc, SmallAndLargeOpeningAngles) {
  EXPECT_LT(off_centre("G3 X1000000 AR=0.001 F9\n", 500000, 57295779511.62787983346L), kClose);
  EXPECT_LT(off_centre("G2 X1000000 AR=0.001 F9\n", 500000, -57295779511.62787983346L), kClose);
  EXPECT_LT(off_centre("G3 X1000000 AR=359.999 F9\n", 500000, -57295779511.62787983346L), kClose);
}

// The arc is 1.7e-6 mm long: a count of its end turns the direction by 1e-8.
TEST(SinumerikFlatArc, TangentOfATinyArc) {
  EXPECT_LT(off_centre("G3 J0.1 AR=0.001 F9\nCT X0.7 Y0.0006\n", -0.00727311731996126924L,
                       416.818926294967804082L),
            kClose);
}

// Along the line of 33 degrees, 0.01 mm long.
TEST(SinumerikFlatArc, TangentOfATinyLine) {
  EXPECT_LT(off_centre("G1 AP=33 RP=0.01 F9\nCT X1 Y0.65\n", -766.657738785949440705L,
                       1180.56775197838375494L),
            kClose);
}

// Half a turn about (1, 0) that rises by 3: at its end the direction is (0, 1, 3/pi). In G19 from
// (0, 3) with (1, 0.954929658551372) to (4, 5); in G18 straight along Z.
TEST(SinumerikFlatArc, TangentOfAHelixRises) {
  EXPECT_LT(off_centre("G3 X2 Z3 I1 J0 F9\nG19 CT Y4 Z5\n", 5.24767752883019885553L,
                       -2.49535505766039771108L),
            kClose);
  EXPECT_EQ(last_motion_or_alarm("G3 X2 Z3 I1 J0 F9\nG18 CT X4\n"),
            "arc18 c=3,3 rot=1 x=4 z=3 f=9");
  // Five half turns.
  EXPECT_LT(off_centre("G3 X2 Z3 I1 J0 TURN=2 F9\nG19 CT Y4 Z5\n", -1.54512327519025523409L,
                       11.0902465503805104682L),
            kClose);
}

// A quarter of radius 10 that rises by 5: (0, 1, 1/pi). Over a chord of 4 along Y the centre is
// pi half chords below its middle: 5 - 2 pi.
TEST(SinumerikFlatArc, TangentOfATangentHelixRises) {
  EXPECT_LT(off_centre("G1 X10 F9\nCT X20 Y10 Z5\nG19 CT Y14 Z5\n", 12, -1.28318530717958647693L),
            kClose);
}

// The pole lies on the chord of 1999.999: at most half a turn has the centre to the left of it, at
// sqrt(1000^2 - 999.9995^2) = 0.999999874999992 along 290 degrees from 0.0005 along 20 degrees.
TEST(SinumerikFlatArc, APoleOnTheChordTakesTheShorterWay) {
  EXPECT_LT(
      off_centre("G0 AP=20 RP=1000\nG3 AP=200 RP=999.999 F9\n", 0.342489946883L, -0.939521493253L),
      kClose);
}

// The largest length is that in millimetres.
TEST(SinumerikFlatArc, LargestLength) {
  EXPECT_EQ(last_motion_or_alarm("G0 X1000000000\n"), "rapid x=1000000000");
  EXPECT_EQ(last_motion_or_alarm("G0 X1000000000.001\n"), "value-out-of-range");
  EXPECT_EQ(last_motion_or_alarm("G70 G0 X39370078\n"), "rapid x=999999981.2");
  EXPECT_EQ(last_motion_or_alarm("G70\nG0 X39370079\n"), "value-out-of-range");
}

// The direction at the end of a spiral is irrational, and the end 0.00254 mm beside it: of a radius
// of 5.08e12 mm a processor's digits leave thousands of millimetres open.
TEST(SinumerikFlatArc, WhatTheDigitsDoNotReachIsNotImplemented) {
  EXPECT_EQ(note_of("G70\nG0 X1 Y30 Z30\nG19 G0 Y40\n"
                    "G3 Y30.0001 Z20 K-10 TURN=3 F200\nCT X64 Z40\n"),
            kTooFlat);
  // What an expression gives is known to a count. -0.00001745 mm beside 5 mm: a radius of 716 m.
  EXPECT_EQ(note_of("G0 X=TAN(-0.001)\nG1 Y14 Z5 F90\nG18 CT X0 Z10\n"), kTooFlat);
  // A radius of 1e6 chords from a place that is known to a count.
  EXPECT_EQ(note_of("G0 X=SQRT(2)\nG2 Y20 X13.5 AR=359.9999 F100\n"), kTooFlat);
  EXPECT_EQ(note_of("G0 X=SQRT(2)\nG2 Y20 X13.5 AR=359.9 F100\n"), "");
}

// An inch has fewer counts: 0.00044 mm beside, over a chord of 7.77 and with a radius of 2540 m.
TEST(SinumerikFlatArc, ACentreMovedToTheBisectorFromAReckonedPlaceIsNotImplemented) {
  EXPECT_EQ(note_of("G70\nG0 X=TAN(-0.001)\nG3 X0 Y0.306 I100000 F100\n"), kTooFlat);
  EXPECT_EQ(note_of("G70\nG0 X=TAN(-0.001)\nG3 X0 Y2 I1 J1 F100\n"), "");
}

// The start is known to a count. A radius of 5 mm over a chord of 0.001 turns by 1e4 times what
// the chord does; of 254 km over 1 km, where an inch has fewer counts, the centre moves by 0.012
// mm.
TEST(SinumerikFlatArc, ARadiusFarAboveTheChordFromAReckonedPlaceIsNotImplemented) {
  const std::string tiny = "G0 X=TAN(-0.001)\nG3 X0 Z0.001 CR=-5 F200\n";
  EXPECT_EQ(note_of(tiny), "");
  EXPECT_EQ(note_of(tiny + "G18 CT X0 Z10\n"), kTooFlat);
  const std::string start = "G70\nG0 X=TAN(-0.001)\n";
  EXPECT_EQ(note_of(start + "G3 X17.203 Y38.029 CR=-999 F500\n"), "");
  EXPECT_EQ(note_of(start + "G3 X17.203 Y38.029 CR=-9999998.999 F500\n"), kTooFlat);
}

// Over a way of 355 mm the end lies 3e-13 mm off the line, at 25 km from zero.
TEST(SinumerikFlatArc, WhetherATangentIsStraightFarOffIsNotImplemented) {
  EXPECT_EQ(note_of("G70 G19 G0 Y40 Z30\nG110 Y5 Z-6\nG0 AP=359.9999999 RP=0.5\n"
                    "G1 AP=0 RP=1000000 F100\nG91 CT Y14.001\n"),
            kTooFlat);
  EXPECT_EQ(last_motion_or_alarm("G0 AP=30 RP=5\nG1 AP=30 RP=10 F100\nCT AP=30 RP=20\n"),
            "feed x=17.320508076 y=10 f=100");
}

// The chord is 1.5e-9 mm, and the radii, of 6.6 km, differ by as much: the centre lies on the
// chord.
TEST(SinumerikFlatArc, RadiiWhoseRoundingWouldBeSeenAreNotImplemented) {
  const std::string none = "An arc as near its limit as this is not implemented.";
  const std::string start = "G1 AP=359.999 RP=10 F100\n";
  EXPECT_EQ(note_of(start + "G2 X=AC(10) I=AC(6602548)\n"), none);
  EXPECT_EQ(note_of(start + "G2 AP=200 RP=10\n"), "");
}

// The angle is known to some counts of 1e-9 degrees: over 254 km they are 0.018 mm.
TEST(SinumerikFlatArc, AFarPlaceByACalculatedAngleIsNotImplemented) {
  const std::string none = "A turn as far off as this is not implemented.";
  EXPECT_EQ(note_of("G0 AP=TAN(18) RP=254000000\n"), none);
  EXPECT_EQ(note_of("G0 AP=0.324919696 RP=254000000\n"), "");
  EXPECT_EQ(note_of("G0 AP=TAN(18) RP=2540000\n"), "");
  EXPECT_EQ(note_of("G3 I254000000 AR=TAN(18) F100\n"), none);
  EXPECT_EQ(note_of("G3 I2540000 AR=TAN(18) F100\n"), "");
}

// The start, 0.001 mm about the pole along 359.999 degrees, is 1.5e-13 mm beside the line of the
// other two.
TEST(SinumerikFlatArc, WhatIsAllButInLineIsNotImplemented) {
  const std::string start = "G19 G0 X10 Y10 Z-6\nG111 Y10 Z-6\nG0 AP=359.999 RP=0.001\n";
  EXPECT_EQ(note_of(start + "CIP X12 I1=60 J1=10.001 F100\n"), kTooFlat);
  EXPECT_EQ(note_of(start + "CIP X30 I1=60 J1=10.1 F100\n"), "");
  // Nor does the tangent, seen in the plane, have a direction that is known.
  EXPECT_EQ(note_of(start + "CIP X30 I1=20 J1=10.001 F100\nCT Y0 Z0 X6\n"), kTooFlat);
}

// The start is 1.7e-8 mm beside the line through the end, so the chord is 1.5e-17 mm above 10.
TEST(SinumerikFlatArc, AChordThatIsTheDiameterButForRoundingIsNotImplemented) {
  const std::string none = "An arc as near its limit as this is not implemented.";
  const std::string start = "G0 AP=359.999 RP=0.001\nG0 X10\n";
  EXPECT_EQ(note_of(start + "G2 X20 Y0 CR=5 F100\n"), none);
  EXPECT_EQ(note_of(start + "G2 X20 Y0 CR=5.001 F100\n"), "");
  // From the start to the centre 5.000000000000000030 mm, from there to the end 5.01.
  EXPECT_EQ(note_of(start + "G2 X20.01 Y0 I5 J=AC(0) F100\n"), none);
  EXPECT_EQ(note_of(start + "G2 X20.009 Y0 I5 J=AC(0) F100\n"), "");
}

// Whether places that are known to a count lie in line cannot be said.
TEST(SinumerikFlatArc, ThreePointsInLineAreKnownOfWholeCountsOnly) {
  EXPECT_EQ(note_of("G0 X=SQRT(2) Y=SQRT(3)\nCIP X3 Y=SQRT(3) I1=2 J1=SQRT(3) F9\n"), kTooFlat);
  EXPECT_EQ(last_motion_or_alarm("G0 X1 Y1\nCIP X3 Y1 I1=2 J1=1 F9\n").substr(0, 5), "feed ");
}

}  // namespace
}  // namespace gonogo::expanders::testing
