// SPDX-License-Identifier: GPL-3.0-or-later
//
// G2 and G3: centres, full circles, planes, helices, forms.
#include <gtest/gtest.h>

#include "sie_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

TEST(SieArc, TheCentreIsFromTheStartWhateverTheMode) {
  EXPECT_EQ(line("G0 X10 Y5\nG2 X20 Y5 I5 F9", 1), "arc x20 y5 c15,5 rot-1 f9");
  EXPECT_EQ(line("G0 X10 Y5\nG91 G3 X10 I5 F9", 1), "arc x20 y5 c15,5 rot1 f9");
  EXPECT_EQ(line("G0 X10 Y5\nG3 X20 Y5 I=IC(5) F9", 1), "arc x20 y5 c15,5 rot1 f9");
  EXPECT_EQ(line("G0 X10 Y5\nG91 G2 X=AC(20) I=AC(15) J=AC(5) F9", 1), "arc x20 y5 c15,5 rot-1 f9");
}

// The samples of the manual: 3-4-5 triangles about (50,50) and the misprinted ones elsewhere.
TEST(SieArc, ACentreGivenInHalfIsAtTheStartInTheOther) {
  EXPECT_EQ(line("G0 Y5\nG2 X6 Y5 I=AC(3) F9", 1), "arc x6 y5 c3,5 rot-1 f9");
}

TEST(SieArc, WithoutAnEndItIsAFullCircle) {
  EXPECT_EQ(line("G0 X1 Y2\nG2 I3 J4 F9", 1), "arc x1 y2 c4,6 rot-1 f9");
  EXPECT_EQ(line("G0 X1 Y2\nG3 X1 Y2 I3 F9", 1), "arc x1 y2 c4,2 rot1 f9");
  EXPECT_EQ(line("G0 X1 Y2\nG91 G3 X0 I3 F9", 1), "arc x1 y2 c4,2 rot1 f9");
  EXPECT_EQ(line("G2 I3 Z5 F9", 0), "arc x0 y0 z5 c3,0 rot-1 f9");
  EXPECT_EQ(clauses("G2 I3 F9"), Lines{"SIE-ARC-03"});
}

TEST(SieArc, ThePlaneGivesTheSense) {
  EXPECT_EQ(line("G18 G2 Z10 X0 K5 F9", 0), "arc x0 z10 c5,0 rot-1 f9");
  EXPECT_EQ(line("G19 G3 Y10 J5 F9", 0), "arc y10 z0 c5,0 rot1 f9");
  EXPECT_EQ(outcome("G18 G2 X10 Z0 J5"), "axis-not-in-plane J");
}

TEST(SieArc, TwoEndPointAxesChooseThePlane) {
  const Record by_centre = last_motion("G2 X10 Z0 I5 K0 F9");
  EXPECT_EQ(by_centre.plane, Plane::g18);
  EXPECT_EQ(by_centre.rot, -1);
  EXPECT_EQ(centre(by_centre), "0.000000000,5.000000000");
  EXPECT_EQ(clause_name(by_centre.clause), "SIE-ARC-01");
  EXPECT_EQ(last_motion("G3 X10 Z0 CR=5 F9").plane, Plane::g18);
  EXPECT_EQ(last_motion("G3 Y10 Z0 CR=5 F9").plane, Plane::g19);
  EXPECT_EQ(last_motion("G18 G3 X10 Y0 CR=5 F9").plane, Plane::g17);
  EXPECT_EQ(last_motion("G3 X10 Y0 CR=5 F9").plane, Plane::g17);
  // One axis, or three of them.
  EXPECT_EQ(last_motion("G3 X10 CR=5 F9").plane, Plane::g17);
  EXPECT_EQ(last_motion("G3 X10 Y0 Z5 CR=5 F9").plane, Plane::g17);
}

TEST(SieArc, AHelixStaysInThePlaneInForce) {
  EXPECT_EQ(line("G2 X10 Z5 I5 J0 F9", 0), "arc x10 y0 z5 c5,0 rot-1 f9");
  EXPECT_EQ(line("G2 X10 Z5 CR=5 TURN=0 F9", 0), "arc x10 y0 z5 c5,0 rot-1 f9");
  EXPECT_EQ(line("G3 X10 Z5 AR=180 F9", 0), "arc x10 y0 z5 c5,0 rot1 f9");
  EXPECT_EQ(outcome("G2 X10 Z5 I5 J0 K0"), "axis-not-in-plane K");
  EXPECT_EQ(outcome("G2 X10 Y0 I5 K1"), "axis-not-in-plane K");
  EXPECT_EQ(clauses("G2 X10 Z5 I5 J0 F9"), Lines{"SIE-ARC-09"});
}

// (0,50) to (0,0) about (0,25) with 3 more turns: 1260 degrees.
TEST(SieArc, TurnAddsWholeTurns) {
  EXPECT_EQ(line("G0 X0 Y50 Z50\nG3 X0 Y0 Z33 I0 J-25 TURN=3 F9", 1),
            "arc x0 y0 z33 c0,25 rot4 f9");
  EXPECT_EQ(line("G2 I5 TURN=2 Z-3 F9", 0), "arc x0 y0 z-3 c5,0 rot-3 f9");
  EXPECT_EQ(line("G2 I5 TURN=999 F9", 0), "arc x0 y0 c5,0 rot-1000 f9");
  EXPECT_EQ(line("G2 I5 TURN=0 F9", 0), "arc x0 y0 c5,0 rot-1 f9");
  EXPECT_EQ(outcome("G2 I5 TURN=1000"), "value-out-of-range TURN");
  EXPECT_EQ(outcome("G2 I5 TURN=-1"), "value-out-of-range TURN");
  EXPECT_EQ(outcome("G2 I5 TURN=1.5"), "not-an-integer TURN");
  EXPECT_EQ(outcome("G2 X10 CR=5 TURN=2"), "end");
}

TEST(SieArc, AnArcHasOneForm) {
  EXPECT_EQ(outcome("G2 X10"), "missing-word CR");
  EXPECT_EQ(outcome("G2 Z5"), "missing-word CR");
  EXPECT_EQ(outcome("G2 TURN=1"), "missing-word CR");
  EXPECT_EQ(outcome("G2 AR=90"), "missing-word X");
  EXPECT_EQ(outcome("G2 AR=90 Z5"), "missing-word X");
  EXPECT_EQ(outcome("G2 X10 I5 CR=5"), "conflicting-words CR");
  EXPECT_EQ(outcome("G2 X10 AR=90 CR=5"), "conflicting-words CR");
  EXPECT_EQ(outcome("G2 X10 I5 AR=90"), "conflicting-words AR");
  EXPECT_EQ(outcome("G2 AP=10 RP=5 CR=5"), "conflicting-words AP");
  EXPECT_EQ(outcome("G2 RP=5 I5"), "conflicting-words RP, missing-word AP");
  EXPECT_EQ(outcome("G2 I5 AR=90 Z3"), "end");
  EXPECT_EQ(clauses("F1\nG2 X10"), Lines{"SIE-ARC-11"});
}

// From (0, 0) to (10, 0) about (5, -12) it is a radius of 13; of 6 the centre is root 11 off the
// chord, below it for a short arc clockwise.
TEST(SieArc, WhetherRadiusOrCentreCountsIsAReading) {
  const auto arc = [](std::string_view reading, const std::string& block) {
    return line("F9\n" + block, 0, sie({{"sie.cr.centre", reading}}));
  };
  const std::string both = "G2 X10 Y0 I5 J-12 CR=6";
  EXPECT_EQ(arc("radius", both), arc("alarm", "G2 X10 Y0 CR=6"));
  EXPECT_EQ(arc("centre", both), "arc x10 y0 c5,-12 rot-1 f9");
  EXPECT_EQ(arc("centre", "G2 I5 CR=5"), "arc x0 y0 c5,0 rot-1 f9");
  EXPECT_EQ(outcome(both), "conflicting-words CR");
  EXPECT_EQ(clauses("F1\n" + both), Lines{"SIE-ARC-16"});
  for (const std::string_view reading : {"radius", "centre"}) {
    const Profile profile = sie({{"sie.cr.centre", reading}});
    EXPECT_EQ(outcome("G2 X10 K5 CR=6", profile), "axis-not-in-plane K") << reading;
    EXPECT_EQ(outcome("G2 X10 I5 AR=90 CR=6", profile), "conflicting-words CR") << reading;
    EXPECT_EQ(outcome("G2 AP=9 RP=9 I5 CR=6", profile), "conflicting-words AP") << reading;
  }
}

TEST(SieArc, TheCentreIsNotTheStart) {
  EXPECT_EQ(outcome("G2 I0"), "arc-radius I");
  EXPECT_EQ(outcome("G2 X5 I0 J0"), "arc-radius I, arc-end-point I");
  EXPECT_EQ(outcome("G2 X0.01 I0 J0"), "arc-radius I");
  EXPECT_EQ(outcome("G2 X5 I0.00000000000000000001"), "arc-end-point I");
  EXPECT_EQ(outcome("G2 J0 AR=90"), "arc-radius AR");
  EXPECT_EQ(outcome("G2 AP=0 RP=5"), "arc-radius RP, arc-end-point RP");
}

TEST(SieArc, ARotaryAxisGoesAlong) {
  EXPECT_EQ(line("G2 X10 I5 A90 F9", 0), "arc x10 y0 a90 c5,0 rot-1 f9");
}

// SIE-ARC-12: half a turn about X0, in the plane of Z and X at Z5, or of X and Y down to Z0.
TEST(SieArc, ToTwoAxesByOneCentreWordItsPlaneIsAReading) {
  const Profile helix = sie({{"sie.arc.plane", "helix"}});
  EXPECT_EQ(last_motion("G0 X10 Z5\nG2 X-10 Z5 I-10 F100").plane, Plane::g18);
  EXPECT_EQ(last_motion("G0 X10 Z5\nG2 X-10 Z5 I-10 F100", helix).plane, Plane::g17);
  EXPECT_EQ(line("G0 X10 Z5\nG2 X-10 Z0 I-10 F100", 1, helix), "arc x-10 y0 z0 c0,0 rot-1 f100");
  EXPECT_EQ(outcome("G0 X10 Z5\nG2 X-10 Z0 I-10"), "arc-end-point I");
  EXPECT_EQ(last_motion("G0 X10 Z5\nG3 X10 Z25 K10 F100", helix).plane, Plane::g18);
  EXPECT_EQ(last_motion("G0 X10 Z5\nG2 X-10 Z5 I-10 K0 F100", helix).plane, Plane::g18);
}

// Half a turn about X0 Y0 down to Z-5. In the plane of Z and X its chord would be sqrt(400 + 25) =
// 20.6, more than twice 10.
TEST(SieArc, ByCrAloneItsPlaneIsAReading) {
  const Profile helix = sie({{"sie.arc.plane", "helix"}});
  EXPECT_EQ(line("G0 X10\nG3 X-10 Z-5 CR=10 F100", 1, helix), "arc x-10 y0 z-5 c0,0 rot1 f100");
  EXPECT_EQ(clauses("G2 X10 Z5 CR=5 F9", helix), Lines{"SIE-ARC-09"});
  EXPECT_EQ(outcome("G0 X10\nG3 X-10 Z-5 CR=10"), "arc-radius CR");
  EXPECT_EQ(last_motion("G18 G0 X10\nG2 X-10 Y4 CR=12 F100", helix).plane, Plane::g18);
  EXPECT_EQ(last_motion("G18 G0 X10\nG2 X-10 Y4 CR=12 F100").plane, Plane::g17);
}

TEST(SieArc, TheReadingOfThePlaneIsAskedWhereBothAreForms) {
  const std::string before = "F9 S1 M3\n";
  for (const char* arc : {"G2 X10 Z0 I5", "G19 G2 X1 Z1 CR=40", "G2 X10 Z5 CR=9"}) {
    EXPECT_EQ(touched(before + arc), Lines{"sie.arc.plane"}) << arc;
  }
  for (const char* arc :
       {"G2 X10 Z0 I5 K0", "G2 X10 Z5 I5 J0", "G2 X10 Z5 CR=9 TURN=0", "G2 X10 Y0 Z5 CR=9",
        "G3 X10 Z5 AR=180", "G2 Z5 X5 K5 I0", "G2 X9 CR=9"}) {
    EXPECT_EQ(touched(before + arc), Lines{}) << arc;
  }
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
