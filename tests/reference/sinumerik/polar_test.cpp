// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polar end points and the pole: SIE-POL, SIE-ARC-06, SIE-ARC-10.
#include <gtest/gtest.h>

#include "reference/clause_literal.hpp"
#include "sie_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

std::string ends_at(const std::string& program) {
  return end_in_plane(last_motion(program));
}

// The chain of poles of the 808D's manual.
TEST(SiePolar, PolesAreFromTheZeroThePositionAndThePoleBefore) {
  const std::string first = "G111 X20 Y10\nG0 RP=50 AP=30\n";
  EXPECT_EQ(ends_at(first), "63.301270189,35.000000000");
  const std::string second = first + "G110 X-10 Y20\nRP=30 AP=45\n";
  EXPECT_EQ(ends_at(second), "74.514473625,76.213203436");
  const std::string third = second + "G112 X40 Y20\nRP=30 AP=135\n";
  EXPECT_EQ(ends_at(third), "72.088066754,96.213203436");
  EXPECT_EQ(line(first, 0), "rapid x20 + 25*sqrt(3) y35");
}

TEST(SiePolar, ThePoleIsTheZeroUntilItIsSet) {
  EXPECT_EQ(line("G0 X5 Y5\nRP=10 AP=90", 1), "rapid x0 y10");
}

TEST(SiePolar, AloneTheCodesPutThePoleOnTheirBase) {
  EXPECT_EQ(line("G0 X5 Y7\nG110\nRP=10 AP=0", 1), "rapid x15 y7");
  EXPECT_EQ(line("G0 X5 Y7\nG110\nG111\nRP=10 AP=0", 1), "rapid x10 y0");
  EXPECT_EQ(line("G111 X1 Y2\nG112\nG0 RP=10 AP=0", 0), "rapid x11 y2");
}

TEST(SiePolar, ThePoleIsAsItsCodeSaysWhateverTheMode) {
  EXPECT_EQ(line("G91 G0 X5 Y5\nG111 X1 Y2\nRP=10 AP=0", 1), "rapid x11 y2");
  EXPECT_EQ(line("G0 X5 Y5\nG110 X=AC(1) Y2\nRP=10 AP=0", 1), "rapid x16 y7");
  EXPECT_EQ(line("G111 RP=10 AP=90\nG0 RP=10 AP=0", 0), "rapid x10 y10");
  EXPECT_EQ(line("G111 X3\nG112 RP=10 AP=90\nG0 RP=1 AP=0", 0), "rapid x4 y10");
  EXPECT_EQ(line("G70\nG111 X1\nG71 G0 RP=1 AP=0", 0), "rapid x26.4 y0");
}

TEST(SiePolar, UnderG91AnAngleAddsUnderItsReading) {
  const std::string program = "G0 RP=10 AP=90\nG91 AP=90";
  EXPECT_EQ(path(program), (Lines{"rapid x0 y10", "rapid x0 y10"}));
  const Profile adds = sie({{"sie.ap.g91", "incremental"}});
  EXPECT_EQ(path(program, adds), (Lines{"rapid x0 y10", "rapid x-10 y0"}));
  // The first angle about a pole is its own, and AC is absolute.
  EXPECT_EQ(path("G91 G0 RP=10 AP=90", adds), Lines{"rapid x0 y10"});
  EXPECT_EQ(line("G0 RP=10 AP=90\nG91 AP=AC(180)", 1, adds), "rapid x-10 y0");
}

TEST(SiePolar, APoleStandsAlone) {
  EXPECT_EQ(outcome("G111 X1 Z2"), "conflicting-words Z");
  EXPECT_EQ(outcome("G1 G111 X1"), "conflicting-words G");
  EXPECT_EQ(outcome("G110 F5"), "conflicting-words F");
  EXPECT_EQ(outcome("G111 X1 RP=5 AP=3"), "conflicting-words X");
  EXPECT_EQ(outcome("G111 AP=5"), "missing-word RP");
  EXPECT_EQ(outcome("G111 RP=5"), "missing-word AP");
  EXPECT_EQ(outcome("G18\nG111 Z1 X5"), "end");
}

TEST(SiePolar, AnglesAndRadiiHoldOn) {
  EXPECT_EQ(path("G0 RP=10 AP=0\nAP=90\nRP=5"),
            (Lines{"rapid x10 y0", "rapid x0 y10", "rapid x0 y5"}));
  EXPECT_EQ(outcome("G0 RP=10"), "missing-word AP");
  EXPECT_EQ(outcome("G0 AP=10"), "missing-word RP");
  for (const char* change : {"G110", "G111 X1", "G17", "G18"}) {
    const std::string before = std::string("G0 RP=10 AP=0\n") + change + "\n";
    EXPECT_EQ(outcome(before + "AP=90"), "missing-word RP") << change;
    EXPECT_EQ(outcome(before + "RP=9"), "missing-word AP") << change;
  }
}

TEST(SiePolar, ACodeOfThePlanePutsThePoleOnTheZero) {
  EXPECT_EQ(line("G111 X5 Y5\nG17 G0 RP=10 AP=0", 0), "rapid x10 y0");
}

// From the pole at (5, 5), and from one 1 beside it along X; AP and RP hold on.
TEST(SiePolar, TheCodeOfThePlaneInForceLeavesThePoleUnderThatReading) {
  const Profile kept = sie({{"sie.pole.same-plane", "kept"}});
  EXPECT_EQ(line("G111 X5 Y5\nG17 G0 RP=10 AP=0", 0, kept), "rapid x15 y5");
  EXPECT_EQ(line("G111 X5 Y5\nG17\nG17\nG112 X1\nG0 RP=10 AP=0", 0, kept), "rapid x16 y5");
  EXPECT_EQ(path("G0 RP=10 AP=0\nG17\nAP=90", kept), (Lines{"rapid x10 y0", "rapid x0 y10"}));
  EXPECT_EQ(path("G0 RP=10 AP=0\nG17\nRP=9 AP=IC(90)", kept),
            (Lines{"rapid x10 y0", "rapid x0 y9"}));
  EXPECT_EQ(outcome("G0 RP=10 AP=0\nG18\nG17\nAP=90", kept), "missing-word RP");
  EXPECT_EQ(outcome("G0 RP=10 AP=0\nG17\nG111\nAP=90", kept), "missing-word RP");
}

TEST(SiePolar, TheReadingOfAPlaneInForceIsAskedWhereItShows) {
  const Lines asked{"sie.pole.same-plane"};
  EXPECT_EQ(touched("G111 X5\nG17\nG0 RP=10 AP=90"), asked);
  EXPECT_EQ(touched("G111 X5\nG17\nG112 X1"), asked);
  EXPECT_EQ(touched("G0 RP=10 AP=0\nG17\nAP=90"), asked);
  EXPECT_EQ(touched("G0 RP=10 AP=0\nG17\nRP=9 AP=IC(90)"), asked);
  for (const char* program :
       {"G111 X5\nG17\nG0 X1", "G111 X5\nG17\nG111 X1\nG0 RP=10 AP=90",
        "G111 X5\nG18\nG17\nG0 RP=10 AP=90", "G17\nG0 RP=10 AP=90",
        "G0 RP=10 AP=0\nG17\nRP=9 AP=90", "G0 RP=10 AP=0\nG17\nG112 X1\nG0 RP=9 AP=90",
        "G0 RP=10 AP=0\nG17\nG91 RP=9 AP=90"}) {
    EXPECT_EQ(touched(program), Lines{}) << program;
  }
}

// Under G91 the angle of before shows where AP counts from it: 30 + 60 in place of 60.
TEST(SiePolar, UnderG91ThePlaneInForceShowsWhereAnglesAdd) {
  const std::string program = "G0 RP=10 AP=30\nG17\nG91 RP=10 AP=60";
  EXPECT_EQ(touched(program), Lines{"sie.ap.g91"});
  const auto last = [&](std::string_view angle, std::string_view pole) {
    return path(program, sie({{"sie.ap.g91", angle}, {"sie.pole.same-plane", pole}})).back();
  };
  EXPECT_EQ(last("incremental", "kept"), "rapid x0 y10");
  EXPECT_EQ(last("absolute", "kept"), last("absolute", "reset"));
  EXPECT_EQ(last("incremental", "reset"), last("absolute", "reset"));
}

TEST(SiePolar, AnglesAreAbsoluteAndIcAddsToThem) {
  EXPECT_EQ(path("G91 G0 RP=10 AP=90\nAP=90\nAP=IC(90)\nAP=IC(-180)"),
            (Lines{"rapid x0 y10", "rapid x0 y10", "rapid x-10 y0", "rapid x10 y0"}));
  EXPECT_EQ(outcome("G0 RP=5 AP=IC(30)"), "missing-word AP");
}

TEST(SiePolar, TheRangesAreThoseOfTheWords) {
  EXPECT_EQ(outcome("G0 RP=10 AP=360\nAP=-360"), "end");
  EXPECT_EQ(outcome("G0 RP=10 AP=360.001"), "value-out-of-range AP");
  EXPECT_EQ(outcome("G0 RP=10 AP=-360.001"), "value-out-of-range AP");
  EXPECT_EQ(outcome("G0 RP=10 AP=300\nAP=IC(300)"), "end");
  EXPECT_EQ(outcome("G0 RP=-0.001 AP=0"), "value-sign RP");
  EXPECT_EQ(outcome("G0 RP=0 AP=0"), "end");
}

// In G18 the first axis is Z: from it angles turn to X.
TEST(SiePolar, AnglesTurnFromTheFirstAxisOfThePlane) {
  EXPECT_EQ(line("G18 G0 RP=10 AP=90", 0), "rapid x10 z0");
  EXPECT_EQ(line("G19 G0 RP=10 AP=90 X5", 0), "rapid x5 y0 z10");
}

TEST(SiePolar, CartesianWordsOfThePlaneConflict) {
  EXPECT_EQ(outcome("G0 X1 RP=5 AP=3"), "conflicting-words X");
  EXPECT_EQ(outcome("G3 RP=5 AP=3 Y1"), "conflicting-words Y");
  EXPECT_EQ(outcome("G18 G0 Y1 RP=5 AP=3"), "end");
  EXPECT_EQ(clauses("G0 X1 RP=5 AP=3"), Lines{"SIE-COM-01"});
}

TEST(SiePolar, ThePoleIsTheCentreOfAnArc) {
  EXPECT_EQ(line("G0 X10\nG3 RP=10 AP=90 F9", 1), "arc x0 y10 c0,0 rot1 f9");
  EXPECT_EQ(line("G0 X10\nG2 RP=10 AP=90 Z5 TURN=1 F9", 1), "arc x0 y10 z5 c0,0 rot-2 f9");
  EXPECT_EQ(clauses("G0 X10\nG3 RP=10 AP=90 F9"), (Lines{"SIE-G1-01", "SIE-ARC-06"}));
}

// The radius at the start is 10, RP the one at the end.
TEST(SiePolar, TheRadiusMayMissTheStart) {
  EXPECT_EQ(outcome("G0 X10\nG3 RP=10.01 AP=90"), "end");
  EXPECT_EQ(outcome("G0 X10\nG3 RP=10.011 AP=90"), "arc-end-point RP");
  EXPECT_EQ(outcome("G0 X10\nG3 RP=9.99 AP=20"), "end");
  EXPECT_EQ(outcome("G0 X10\nG3 RP=9.989 AP=20"), "arc-end-point RP");
}

// cos 20 and sin 20 are enclosures; the radius is 50 by what was programmed.
TEST(SiePolar, TheRadiusOfAPolarPlaceIsExact) {
  const std::string before = "F9 S1 M3\nG1 RP=50 AP=20\n";
  EXPECT_EQ(touched(before + "G3 AP=70\nAP=70.5\nAP=200"), Lines{});
  EXPECT_EQ(touched(before + "G3 X0 Y50 I=AC(0) J=AC(0)"), Lines{});
  EXPECT_EQ(touched(before + "G0 Z5\nG3 AP=70\nG2 I=AC(0) J=AC(0) AR=33\nAP=20"), Lines{});
}

TEST(SiePolar, WholeTurnsLeadToTheSamePoint) {
  const std::string before = "G0 RP=50 AP=20\nF9\nG3 ";
  for (const char* angle : {"AP=20", "AP=-340", "AP=IC(360)", "AP=IC(0)"}) {
    EXPECT_EQ(last_motion(before + angle).clause, "SIE-ARC-06"_clause);
    const Record circle = last_motion(before + angle);
    EXPECT_EQ(circle.to[Axis::x], last_motion("G0 RP=50 AP=20").to[Axis::x]) << angle;
    EXPECT_EQ(circle.centre[0], Number(0)) << angle;
  }
  EXPECT_EQ(outcome(before + "AP=20.001"), "end");
}

// The pole beside an enclosed position, and the radius that it was put at.
TEST(SiePolar, APoleBesideAnEnclosedPlaceHasItsExactDistance) {
  EXPECT_EQ(touched("F9 S1 M3\nG1 RP=50 AP=20\nG110 X3 Y4\nG2 RP=5 AP=33\nAP=100"), Lines{});
  EXPECT_EQ(outcome("G1 RP=50 AP=20\nG110\nG2 RP=5 AP=33"), "arc-radius RP, arc-end-point RP");
}

// The way from a pole beside an enclosed place is a decimal: (-4, 6) and 4.001 along X.
TEST(SiePolar, TheWayAboutAPoleBesideAnEnclosedPlaceIsExact) {
  const std::string before = "F9\nG1 RP=14.301 AP=342.167\nG110 X-4 Y6\nG1 RP=4.001 AP=0\n";
  EXPECT_EQ(outcome_of_program(before + "G3 Y69"), "missing-word CR");
  EXPECT_EQ(outcome_of_program(before + "G2 Y=IC(1) CR=0.4"), "arc-radius CR");
  EXPECT_EQ(outcome_of_program(before + "G2 Y=IC(1) CR=0.5"), "end");
}

// The pole is put by polar coordinates from where the machine stands: 40 away, and
// CIRCLE_ERROR_FACTOR lets the end be 0.04 off. cos 143.064 is an enclosure.
TEST(SiePolar, APolePutPolarFromThePlaceHasItsExactDistance) {
  const std::string zero = "F9\nG111 AP=-143.064 RP=40\nG2 AP=277.57 RP=";
  EXPECT_EQ(outcome_of_program(zero + "40.04"), "end");
  EXPECT_EQ(outcome_of_program(zero + "40.041"), "arc-end-point RP");
  const std::string pole = "F9\nG0 X3 Y4\nG111 X3 Y4\nG112 AP=-143.064 RP=40\nG2 AP=277.57 RP=";
  EXPECT_EQ(outcome_of_program(pole + "40.04"), "end");
  EXPECT_EQ(outcome_of_program(pole + "40.041"), "arc-end-point RP");
}

// Start, end and pole on one ray: the centre lies on the line of the chord, and would go to its
// perpendicular, by nearly 90 degrees.
TEST(SiePolar, AnArcFromRadiusToRadiusOnOneRayIsRefused) {
  const std::string before = "G110 X20 Y20\nG1 AP=-359 RP=1 F100\nG3 ";
  for (const char* angle : {"-359", "1", "IC(0)", "IC(360)"}) {
    const std::string program = before + "AP=" + angle + " RP=1.001";
    EXPECT_EQ(outcome_of_program(program), "arc-end-point RP") << angle;
    EXPECT_EQ(outcome_of_program(program, sie({{"sie.arc.correct", "project"}})),
              "arc-end-point RP");
    EXPECT_EQ(outcome_of_program(program, sie({{"sie.arc.correct", "programmed"}})), "end");
  }
  EXPECT_EQ(outcome_of_program("G1 AP=20 RP=0.005 F9\nG3 AP=70 RP=0"), "arc-end-point RP");
}

// Inward the projected centre is the middle of the chord: half a turn about 0.9995 on the ray of
// one degree, whose cosine is 0.999847695 and sine 0.017452406.
TEST(SiePolar, InwardOnOneRayTheProjectedCentreIsTheMiddle) {
  const std::string program = "G1 AP=1 RP=1 F100\nG3 AP=1 RP=0.999";
  EXPECT_EQ(outcome_of_program(program), "arc-end-point RP");
  EXPECT_EQ(centre(last_motion(program, sie({{"sie.arc.correct", "project"}}))),
            "0.999347771,0.017443680");
}

// On the ray of 20 degrees u from 5 to 5.004 on the other side: the middle is -0.002 u. To 4.996
// half the chord is 4.998, and as in SieArcCorrection the centre is 0.002 u and 0.141407213 off
// the chord, on its left for G3: u = (0.939692621, 0.342020143), left of -u (0.342020143, -u_x).
TEST(SiePolar, AnArcToTheOtherSideHasItsCentreOnTheChord) {
  const std::string before = "G1 AP=20 RP=5 F9\n";
  EXPECT_EQ(centre(last_motion(before + "G3 AP=200 RP=5.004")), "-0.001879385,-0.000684040");
  EXPECT_EQ(centre(last_motion(before + "G2 AP=-160 RP=5.004")), "-0.001879385,-0.000684040");
  EXPECT_EQ(centre(last_motion(before + "G3 AP=200 RP=4.996")), "0.050243501,-0.132195275");
  EXPECT_EQ(centre(last_motion(before + "G2 AP=200 RP=4.996")), "-0.046484730,0.133563355");
}

// SIE-CT-01 straight ahead and straight behind.
TEST(SiePolar, ATangentArcAlongARayIsALine) {
  const std::string before = "G1 AP=20 RP=10 F9\nAP=20 RP=20\nCT AP=20 ";
  EXPECT_EQ(last_motion(before + "RP=30").kind, RecordKind::feed);
  EXPECT_EQ(outcome_of_program(before + "RP=15"), "arc-tangent CT");
}

// SIE-POL-02 holds for AP and RP beside any other word.
TEST(SiePolar, TheRangesAreCheckedBesideAnotherFormOfTheArc) {
  EXPECT_EQ(outcome("G3 AR=90 RP=-1 AP=0"), "value-sign RP, conflicting-words AP");
  EXPECT_EQ(outcome("G3 CR=9 RP=-1 AP=0"), "value-sign RP, conflicting-words AP");
  EXPECT_EQ(outcome("G1 RP=5 AP=10\nG2 I5 J0 AP=IC(400)"),
            "conflicting-words AP, value-out-of-range AP");
  EXPECT_EQ(outcome("G3 AR=90 RP=1"), "conflicting-words RP, missing-word AP");
}

TEST(SiePolar, FullCirclesOfTheFirstSampleAreExact) {
  const std::string program = "G0 X67.5 Y80.211\nG111 X50 Y50\nG0 RP=34.913 AP=200.052\nF9\n";
  EXPECT_EQ(centre(last_motion(program + "G3 AP=200.052")), "50.000000000,50.000000000");
}

}  // namespace
// SIE-ARC-08, SIE-ARC-10. The pole lies on the chord, which is 1,999.999 long: the corrected centre
// is 0.0005 from the pole along 20 degrees and sqrt(1000^2 - 999.9995^2) = 0.999999875 across, to
// the left of the chord, where the arc has at most half a turn: 0.0005 (cos 20, sin 20) +
// 0.999999875 (cos 290, sin 290).
TEST(SiePolar, AnArcStraightAcrossThePoleIsCorrectedTowardsTheShorterArc) {
  const Record arc = last_motion("F100\nG0 AP=20 RP=1000\nG3 AP=200 RP=999.999\n");
  EXPECT_EQ(centre(arc), "0.342489947,-0.939521493");
}

}  // namespace gonogo::reference::testing::sie
