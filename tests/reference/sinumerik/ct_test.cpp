// SPDX-License-Identifier: GPL-3.0-or-later
//
// CT: SIE-CT-01, SIE-CT-02.
#include <gtest/gtest.h>

#include "sie_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

// Along +X, then to (20,10): the centre is straight above the start at the radius 10.
TEST(SieCt, AnArcGoesOnInTheDirectionBefore) {
  EXPECT_EQ(line("G1 X10 F9\nCT X20 Y10", 1), "arc x20 y10 c10,10 rot1 f9");
  EXPECT_EQ(line("G1 X10 F9\nCT X20 Y-10", 1), "arc x20 y-10 c10,-10 rot-1 f9");
  // Back to Y5 on the same X: half a turn.
  EXPECT_EQ(line("G1 X10 F9\nCT X10 Y5", 1), "arc x10 y5 c10,2.5 rot1 f9");
  EXPECT_EQ(line("G0 X10 F9\nCT X20 Y10", 1), "arc x20 y10 c10,10 rot1 f9");
}

TEST(SieCt, ArcsFollowOneAnother) {
  EXPECT_EQ(path("G0 X10 F9\nG91 CT X10 Y10\nX10 Y10\nX10 Y10"),
            (Lines{"rapid x10", "arc x20 y10 c10,10 rot1 f9", "arc x30 y20 c30,10 rot-1 f9",
                   "arc x40 y30 c30,30 rot1 f9"}));
}

TEST(SieCt, AnEndStraightAheadMakesALine) {
  EXPECT_EQ(line("G1 X10 Y10 F9\nCT X15 Y15", 1), "feed x15 y15 f9");
  EXPECT_EQ(line("G1 X10 F9\nCT X15 Z3", 1), "feed x15 y0 z3 f9");
  EXPECT_EQ(clauses("G1 X10 F9\nCT X15").back(), "SIE-CT-01");
}

TEST(SieCt, NoTurnsMayBeAdded) {
  EXPECT_EQ(line("G1 X10 F9\nCT X15 TURN=0", 1), "feed x15 y0 f9");
  EXPECT_EQ(line("G1 X10 F9\nCT X20 Y10 TURN=0", 1), "arc x20 y10 c10,10 rot1 f9");
  EXPECT_EQ(outcome("G1 X10 F9\nCT X15 TURN=1"), "conflicting-words TURN");
}

TEST(SieCt, AnEndStraightBehindIsAnAlarm) {
  EXPECT_EQ(outcome("G1 X10\nCT X5"), "arc-tangent X");
  EXPECT_EQ(outcome("G1 X10\nCT X5 Y0.001"), "end");
  EXPECT_EQ(clauses("F9\nG1 X10\nCT X5").back(), "SIE-CT-01");
}

TEST(SieCt, ItNeedsAMotionBefore) {
  EXPECT_EQ(outcome("CT X5 Y5"), "arc-tangent X");
  EXPECT_EQ(outcome("G1 X0\nCT X5 Y5"), "arc-tangent X");
  EXPECT_EQ(outcome("G1 A50\nCT Y5"), "arc-tangent Y");
  EXPECT_EQ(outcome("G1 Z10\nCT X5 Y5"), "arc-tangent X");
  EXPECT_EQ(outcome("G1 X10\nCT X10 Y0"), "arc-tangent X");
  EXPECT_EQ(outcome("G1 X10\nCT Z5"), "arc-tangent CT");
}

TEST(SieCt, TheMotionBeforeStaysTheLastOneWithALength) {
  EXPECT_EQ(line("G1 X10 F9\nX10\nCT X20 Y10", 2), "arc x20 y10 c10,10 rot1 f9");
  EXPECT_EQ(line("G1 X10 F9\nG110\nG4 F1\nCT X20 Y10", 2), "arc x20 y10 c10,10 rot1 f9");
  EXPECT_EQ(line("G1 X10 Z5 F9\nCT X20 Y10", 1), "arc x20 y10 c10,10 rot1 f9");
}

TEST(SieCt, ItIsInThePlaneInForce) {
  EXPECT_EQ(line("G18 G1 Z10 F9\nCT Z20 X10", 1), "arc x10 z20 c10,10 rot1 f9");
  EXPECT_EQ(line("G1 X10 Z10 F9\nG18 CT X10 Z20", 1), "arc x10 z20 c15,5 rot-1 f9");
}

TEST(SieCt, TheThirdAxisMakesAHelix) {
  EXPECT_EQ(line("G1 X10 F9\nCT X20 Y10 Z3", 1), "arc x20 y10 z3 c10,10 rot1 f9");
  EXPECT_EQ(clauses("G1 X10 F9\nCT X20 Y10 Z3").back(), "SIE-CT-02");
}

// The radius at the end is (10,7.5), clockwise: on goes (7.5,-10); to (60,40) the centre is half of
// (10,7.5) off.
TEST(SieCt, ItFollowsACircleThroughThreePoints) {
  EXPECT_EQ(line("G0 X30 Y40 F9\nCIP X50 Y40 I1=40 J1=45\nCT X60", 2),
            "arc x60 y40 c55,43.75 rot1 f9");
  // Radius 5 about (5,0,0) by (5,3,4): at the end down along -(0,3,4), of which G17 sees -Y.
  EXPECT_EQ(line("CIP X10 I1=5 J1=3 K1=4 F9\nCT X20", 1), "arc x20 y0 c15,0 rot1 f9");
  EXPECT_EQ(line("CIP X10 I1=5 J1=3 K1=4 F9\nG18 CT X20", 1), "arc x20 z0 c0,15 rot-1 f9");
}

// The short arc of radius 10 on a chord of 10 has its centre at (5,-5 sqrt3); at the end it goes on
// along (5 sqrt3,-5), and the next centre is the mirrored (15,5 sqrt3).
TEST(SieCt, ItFollowsARadiusWithOneRoot) {
  const Record arc = last_motion("G2 X10 CR=10 F9\nCT X20");
  EXPECT_EQ(arc.rot, 1);
  EXPECT_EQ(arc.centre[0], Number(15));
  EXPECT_EQ(arc.centre[1], Number::root(0, 5, 3));
}

TEST(SieCt, ItFollowsPolarArcsAndTakesPolarEnds) {
  EXPECT_EQ(line("G0 X10\nG3 RP=10 AP=90 F9\nCT AP=180", 2), "arc x-10 y0 c0,0 rot1 f9");
  // Any angle: the circle of the arc before is the one that goes on.
  EXPECT_EQ(centre(last_motion("G0 X10\nG3 RP=10 AP=20 F9\nCT AP=77")), "0.000000000,0.000000000");
  EXPECT_EQ(centre(last_motion("G2 I10 AR=33 F9\nCT X20 Y0")), "10.000000000,0.000000000");
}

TEST(SieCt, ItFollowsAFullCircle) {
  EXPECT_EQ(line("G2 I5 F9\nCT X-10 Y0", 1), "arc x-10 y0 c-5,0 rot1 f9");
}

// A full circle about (5,0) clockwise goes +Y at its end, 5 a radian, while Z climbs by 10/(2 pi).
// In G19 the centre to (10,10) is then (5, 10 - 5 pi).
TEST(SieCt, AHelixClimbsInOtherPlanes) {
  EXPECT_EQ(centre(last_motion("G2 I5 Z10 F9\nG19 CT Y10")), "5.000000000,-5.707963268");
  // Half a turn: +-Y again, and twice the climb: (0,-5) and 10/pi a radian.
  EXPECT_EQ(centre(last_motion("G2 X10 I5 J0 Z10 F9\nG19 CT Y-10")), "-5.000000000,2.146018366");
  EXPECT_EQ(centre(last_motion("G2 X10 I5 J0 Z10 F9\nCT X20")), "15.000000000,0.000000000");
}

// From (10,0) to (9.995,0) about the origin, which the tolerance of the radii admits: the arc has
// no sweep, and no text says which way it goes. Round once more, it is a circle. Found by generated
// program 30,084,685 of the 802S.
TEST(SieCt, WhatFollowsAnArcWithoutSweepIsNotDecided) {
  const Profile programmed = sie({{"sie.arc.correct", "programmed"}});
  EXPECT_EQ(path("G0 X10\nG3 AP=0 RP=9.995 F9", programmed).size(), 2U);
  EXPECT_THROW(path("G0 X10\nG3 AP=0 RP=9.995 F9\nCT X20 Y5", programmed), exact::Undecided);
  // Half a turn between places that are only enclosed is one.
  EXPECT_EQ(path("G0 AP=-10 RP=2\nG3 AP=-190 RP=2 F9\nCT X20 Y5").size(), 3U);
  EXPECT_EQ(path("G0 X10\nG3 AP=0 RP=9.995 TURN=1 F9\nCT X20 Y5", programmed).size(), 3U);
}

// From (10,0) about (10.001,0) into that very point, which the tolerance admits, too: of the way
// that a radius of 0 turns no text says anything. Found by generated program 70,390,691 of the
// 840D.
TEST(SieCt, WhatFollowsAnArcThatEndsInItsCentreIsNotDecided) {
  const Profile programmed = sie({{"sie.arc.correct", "programmed"}});
  EXPECT_EQ(path("G0 X10\nG3 X10.001 I0.001 F9", programmed).size(), 2U);
  EXPECT_THROW(path("G0 X10\nG3 X10.001 I0.001 F9\nCT X20 Y5", programmed), exact::Undecided);
}

// How many of so many arcs behind a block are expanded before their digits are too many.
std::size_t arcs_of_chain(std::string program, int arcs) {
  for (int i = 1; i <= arcs; ++i) {
    program += "\nCT X0." + std::to_string(10'007 + i * i * 31 % 80'021) + " Y0." +
               std::to_string(10'007 + i * i * 47 % 79'999);
  }
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  Expander expander(sie(), lines, OpenPaths::shown);
  std::size_t count = 0;
  try {
    while (const Item* item = expander.next()) {
      const auto* record = std::get_if<Record>(item);
      if (record != nullptr && record->kind == RecordKind::arc) ++count;
    }
  } catch (const exact::Undecided&) {
    return count;
  }
  return count;
}

// The work of a chain does not grow with its length: the digits of each arc are more than those of
// the one before, over a square root (CR) as in what is enclosed (AR), and they end.
TEST(SieCt, AChainEndsWhereItsDigitsAreTooMany) {
  for (const char* first : {"G2 X10 Y1 CR=37 F9", "G2 X10 Y1 AR=37 F9", "G1 X10 Y1 F9"}) {
    SCOPED_TRACE(first);
    EXPECT_GE(arcs_of_chain(first, 50), 50U);
    const std::size_t most = arcs_of_chain(first, 1'000);
    EXPECT_LT(most, 900U);
    EXPECT_EQ(arcs_of_chain(first, 2'000), most);
  }
}

TEST(SieCt, WordsOfArcsConflict) {
  EXPECT_EQ(outcome("G1 X10\nCT X20 Y5 CR=5"), "conflicting-words CR");
  EXPECT_EQ(outcome("G1 X10\nCT X20 Y5 TURN=1"), "conflicting-words TURN");
  EXPECT_EQ(outcome("G1 X10\nCT X20 Y5 I3"), "conflicting-words I");
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
