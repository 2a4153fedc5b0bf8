// SPDX-License-Identifier: GPL-3.0-or-later
//
// G158, G258, G259: base = translation + rotation * workpiece. A quarter turn takes (x, y) to
// (-y, x).
#include <gtest/gtest.h>

#include "s802_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

const Profile kAdditive = s802({{"sie.g158", "additive"}});
const Profile kRotationOnly = s802({{"sie.g258", "rotation-only"}});

Lines moves(std::string_view program, const Profile& profile = s802()) {
  return path(program, profile);
}
std::string frame_outcome(std::string_view block) {
  return outcome(block, s802());
}
Lines warnings(std::string_view program) {
  grammar::MemorySource bytes(program);
  grammar::LineSource source(bytes);
  const Profile profile = s802();
  Expander expander(profile, source, OpenPaths::shown);
  Lines messages;
  expander.on_warning(
      [&](const Warning& warning, const grammar::Line&) { messages.push_back(warning.message); });
  while (expander.next() != nullptr) {
  }
  return messages;
}

TEST(SieFrame, ATranslationMovesWhatFollows) {
  EXPECT_EQ(moves("G158 X10 Y20\nG0 X1 Y2 Z3"), Lines{"rapid x11 y22 z3"});
  EXPECT_EQ(moves("G158 Z-5\nG0 Z3"), Lines{"rapid z-2"});
}

TEST(SieFrame, TheToolDoesNotMoveAndStaysWhereItIs) {
  const std::string program = "G0 X5 Y5\nG158 X10\nG0 Y1";
  EXPECT_EQ(moves(program), (Lines{"rapid x5 y5", "rapid y1"}));
  EXPECT_EQ(ending(program, s802()), "end x5 y1 z0 a0 c0");
  EXPECT_EQ(line("G0 X5\nG158 X10\nG91 X1", 1, s802()), "rapid x6");
}

// The tool stands at 5: 6, or with the translation 5 + 10 + 1 = 16, and from there 17.
TEST(SieFrame, AnIncrementGoesTheTranslationOnceUnderThatReading) {
  const Profile with = s802({{"sie.frame.increment", "with-translation"}});
  EXPECT_EQ(moves("G0 X5\nG158 X10\nG91 X1\nX1", with),
            (Lines{"rapid x5", "rapid x16", "rapid x17"}));
  EXPECT_EQ(moves("G0 X5\nG158 X10\nG0 X0\nG91 X1", with),
            (Lines{"rapid x5", "rapid x10", "rapid x11"}));
  EXPECT_EQ(moves("G158 X10\nG0 X0\nG158\nG91 X5", with), (Lines{"rapid x10", "rapid x5"}));
  EXPECT_EQ(moves("G158 X10\nG0 X=IC(1) Z=IC(2)", with), Lines{"rapid x11 z2"});
}

// Seen from a frame that is turned by 90 degrees, 10 along X are -10 along Y: -5 - 10 along Y
// there are 15 along X.
TEST(SieFrame, TheTranslationThatAnIncrementGoesIsSeenInTheTurnedFrame) {
  const Profile with = s802({{"sie.frame.increment", "with-translation"}});
  EXPECT_EQ(moves("G158 X10\nG259 RPL=90\nG91 G0 Y-5", with), Lines{"rapid x15 y0"});
}

TEST(SieFrame, TheReadingOfIncrementsIsAskedBehindATranslationOnly) {
  EXPECT_EQ(touched("G158 X10\nG91 G0 X1", s802()), Lines{"sie.frame.increment"});
  EXPECT_EQ(touched("G158 X10\nG0 X0\nG91 X1\nZ1", s802()), Lines{});
  EXPECT_EQ(touched("G259 RPL=9\nG91 G0 X1", s802()), Lines{});
}

TEST(SieFrame, G158AloneClears) {
  EXPECT_EQ(moves("G158 X10\nG259 RPL=90\nG158\nG0 X1 Y2"), Lines{"rapid x1 y2"});
  EXPECT_EQ(moves("G158 X10\nG259 RPL=90\nG158\nG0 X1 Y2", kAdditive), Lines{"rapid x1 y2"});
}

TEST(SieFrame, G158ReplacesTranslationAndRotation) {
  EXPECT_EQ(moves("G158 X10\nG259 RPL=90\nG158 Y5\nG0 X1 Y1"), Lines{"rapid x1 y6"});
}

// (10, 0) + the quarter turn of (5, 0) = (10, 5), and the quarter turn of (1, 0) is (0, 1).
TEST(SieFrame, AnAdditiveG158IsInTheTurnedFrameAndKeepsTheRotation) {
  EXPECT_EQ(moves("G158 X10\nG259 RPL=90\nG158 X5\nG0 X1 Y0", kAdditive), Lines{"rapid x10 y6"});
  EXPECT_EQ(moves("G158 X10\nG158 X-10\nG0 X1", kAdditive), Lines{"rapid x1"});
}

// The quarter turn of (5, 0) is (0, 5) and that of (1, 2) is (-2, 1); the half one of (5, 0) is
// (-5, 0).
TEST(SieFrame, AG158OfTheTranslationAloneLeavesTheRotation) {
  const Profile alone = s802({{"sie.g158", "translation-only"}});
  EXPECT_EQ(moves("G258 RPL=90\nG158 X10\nG0 X5 Y0", alone), Lines{"rapid x10 y5"});
  EXPECT_EQ(moves("G158 X10 Y10\nG259 RPL=90\nG158 Y5\nG0 X1 Y2", alone), Lines{"rapid x-2 y6"});
  EXPECT_EQ(moves("G258 RPL=90\nG158 X10\nG259 RPL=90\nG0 X5 Y0", alone), Lines{"rapid x5 y0"});
  EXPECT_EQ(moves("G258 RPL=90\nG158 X10\nG158\nG0 X5 Y0", alone), Lines{"rapid x5 y0"});
}

TEST(SieFrame, TheReadingOfG158MattersOnlyInAFrame) {
  EXPECT_EQ(touched("G158 X10\nG158\nG158 Y5", s802()), Lines{});
  EXPECT_EQ(touched("G158 X10\nG158 Y5", s802()), Lines{"sie.g158"});
  EXPECT_EQ(touched("G258 RPL=9\nG158 Y5", s802()), Lines{"sie.g158"});
}

TEST(SieFrame, ARotationGoesFromTheFirstAxisTowardTheSecond) {
  EXPECT_EQ(moves("G258 RPL=90\nG0 X1 Y0"), Lines{"rapid x0 y1"});
  EXPECT_EQ(moves("G18\nG258 RPL=90\nG0 Z1 X0"), Lines{"rapid x1 z0"});
  EXPECT_EQ(moves("G19\nG258 RPL=90\nG0 Y1 Z0"), Lines{"rapid y0 z1"});
  EXPECT_EQ(moves("G258 RPL=-90\nG0 X1 Y0"), Lines{"rapid x0 y-1"});
}

TEST(SieFrame, OneAxisOfATurnedPlaneMovesBoth) {
  EXPECT_EQ(moves("G258 RPL=90\nG0 X1"), Lines{"rapid x0 y1"});
  EXPECT_EQ(moves("G258 RPL=90\nG0 Z1"), Lines{"rapid z1"});
  EXPECT_EQ(moves("G0 X2 Y3\nG258 RPL=90\nG0 X1"), (Lines{"rapid x2 y3", "rapid x2 y1"}));
}

// The place 50 from the zero at 20 degrees: half a turn on, the pole of the translated frame is
// that zero again, and the arc about it needs no correction. At 20 degrees in base coordinates the
// tool stands at -160 in the turned frame.
TEST(SieFrame, APolarPlaceIsKnownInAnotherFrame) {
  const std::string before = "F9 S1 M3\nG0 RP=50 AP=20\n";
  EXPECT_EQ(touched(before + "G259 RPL=180\nG158\nG3 AP=70 RP=50", s802()), Lines{});
  EXPECT_EQ(touched(before + "G158 X5 Y-3\nG111 X-5 Y3\nG3 AP=70 RP=50", s802()), Lines{});
  const std::string turned = before + "G259 RPL=180\nG3 RP=50 AP=";
  EXPECT_EQ(outcome_of_program(turned + "-160", s802()), "end");
  EXPECT_EQ(clauses(turned + "-160", s802()).back(), "SIE-ARC-06");
  EXPECT_EQ(path(turned + "-160", s802()).back().substr(0, 3), "arc");
}

// sqrt(2)/2 and sqrt(3)/2.
TEST(SieFrame, OfFortyFiveAndThirtyDegreesItIsExact) {
  const Number half = num("1/2");
  const Record diagonal = last_motion("G258 RPL=45\nG0 X3 Y1", s802());
  EXPECT_EQ(diagonal.to[Axis::x], Number::root(0, 1, 2));
  EXPECT_EQ(diagonal.to[Axis::y], Number::root(0, 2, 2));
  const Record thirty = last_motion("G258 RPL=30\nG0 X2 Y0", s802());
  EXPECT_EQ(thirty.to[Axis::x], Number::root(0, 1, 3));
  EXPECT_EQ(thirty.to[Axis::y], half * 2);
}

// cos 17 = 0.9563047559630355, sin 17 = 0.2923717047227367.
TEST(SieFrame, OfSeventeenDegreesItIsEnclosed) {
  const Record record = last_motion("G258 RPL=17\nG0 X10 Y0", s802());
  EXPECT_EQ(record.to[Axis::x].decimal_text(12), "9.563047559630");
  EXPECT_EQ(record.to[Axis::y].decimal_text(12), "2.923717047227");
}

TEST(SieFrame, AFrameThatIsClearedLeavesAnExactPosition) {
  const std::string turned = "G0 X20 Y10\nG258 RPL=17\nG0 Z1\nG258\nG0 X21";
  EXPECT_EQ(ending(turned, s802()), "end x21 y10 z1 a0 c0");
}

TEST(SieFrame, G259AddsAboutTheShiftedZero) {
  EXPECT_EQ(moves("G158 X10\nG259 RPL=30\nG259 RPL=60\nG0 X1 Y0"), Lines{"rapid x10 y1"});
  EXPECT_EQ(moves("G258 RPL=30\nG259 RPL=60\nG0 X1 Y0"), Lines{"rapid x0 y1"});
}

TEST(SieFrame, WholeTurnsAreNoRotation) {
  EXPECT_EQ(frame_outcome("G258 RPL=720\nG18"), "end");
  EXPECT_EQ(frame_outcome("G258 RPL=405\nG259 RPL=-45\nG18"), "end");
  EXPECT_EQ(frame_outcome("G258 RPL=360.001\nG18"), "plane-not-allowed G");
}

TEST(SieFrame, G258ReplacesTheTranslationTooOrNot) {
  const std::string turns = "G158 X10\nG258 RPL=90\nG0 X1 Y0";
  EXPECT_EQ(moves(turns), Lines{"rapid x0 y1"});
  EXPECT_EQ(moves(turns, kRotationOnly), Lines{"rapid x10 y1"});
  const std::string clears = "G158 X10\nG259 RPL=90\nG258\nG0 X1 Y0";
  EXPECT_EQ(moves(clears), Lines{"rapid x1 y0"});
  EXPECT_EQ(moves(clears, kRotationOnly), Lines{"rapid x11 y0"});
  EXPECT_EQ(touched("G259 RPL=90\nG258 RPL=9", s802()), Lines{});
  EXPECT_EQ(touched("G158 X1\nG258 RPL=9", s802()), Lines{"sie.g258"});
}

TEST(SieFrame, AnAngleMayStandWithoutEqualsSign) {
  EXPECT_EQ(moves("G258 RPL90\nG0 X1 Y0"), Lines{"rapid x0 y1"});
  EXPECT_EQ(warnings("G258 RPL90").size(), 1U);
  EXPECT_EQ(warnings("G258 RPL=90"), Lines{});
  const Profile required = s802({{"sie.rpl-equals", "required"}});
  EXPECT_EQ(outcome("G258 RPL90", required), "syntax RPL");
  EXPECT_EQ(clauses("G258 RPL90", required), Lines{"SIE-FRM-03"});
  EXPECT_EQ(outcome("G258 RPL=90", required), "end");
  // A block that does not parse says nothing else: S and G1 would be conflicting-words, G599
  // undefined-code.
  for (const char* program : {"G259 RPL60 S300", "G1 X5 RPL60", "G599 RPL60", "RPL60 RPL60"}) {
    EXPECT_EQ(outcome(program, required), "syntax RPL") << program;
    EXPECT_EQ(clauses(program, required), Lines{"SIE-FRM-03"}) << program;
  }
  EXPECT_EQ(outcome("G259 RPL60 S300", s802()), "conflicting-words S");
}

TEST(SieFrame, TheTranslationIsInTheUnitsInForce) {
  EXPECT_EQ(moves("G70\nG158 X1\nG71\nG0 X0"), Lines{"rapid x25.4"});
}

TEST(SieFrame, ItsCodesStandAlone) {
  EXPECT_EQ(frame_outcome("N5 G158 X1"), "end");
  EXPECT_EQ(frame_outcome("G158 X1 F5"), "conflicting-words F");
  EXPECT_EQ(frame_outcome("G158 X1 M3"), "conflicting-words M");
  EXPECT_EQ(frame_outcome("G0 G158 X1"), "conflicting-words G");
  EXPECT_EQ(frame_outcome("G158 A5"), "conflicting-words A");
  EXPECT_EQ(frame_outcome("G158 RPL=5"), "conflicting-words RPL");
  EXPECT_EQ(frame_outcome("G258 X5 RPL=5"), "conflicting-words X");
  EXPECT_EQ(frame_outcome("G259 RPL=5 C5"), "conflicting-words C");
  EXPECT_EQ(frame_outcome("G158 X=AC(5)"), "conflicting-words X");
  EXPECT_EQ(frame_outcome("G158 Y=IC(5)"), "conflicting-words Y");
  EXPECT_EQ(frame_outcome("G158 X1 G258 RPL=5"), "duplicate-word G");
  EXPECT_EQ(frame_outcome("G1 X5 RPL=5"), "conflicting-words RPL");
  EXPECT_EQ(clauses("G158 X1 F5", s802()), Lines{"SIE-FRM-07"});
  EXPECT_EQ(clauses("G158 X1 M8", s802()), Lines{"SIE-FRM-07"});
  EXPECT_EQ(clauses("G158 X1 G1", s802()), Lines{"SIE-FRM-04"});
  EXPECT_EQ(clauses("G158 X1 I5", s802()), Lines{"SIE-FRM-04"});
}

TEST(SieFrame, G259NeedsAnAngle) {
  EXPECT_EQ(frame_outcome("G259"), "missing-word RPL");
  EXPECT_EQ(frame_outcome("G258"), "end");
}

TEST(SieFrame, ARotationStaysInItsPlane) {
  EXPECT_EQ(frame_outcome("G258 RPL=30\nG18"), "plane-not-allowed G");
  EXPECT_EQ(frame_outcome("G258 RPL=30\nG17\nG1 X1"), "end");
  EXPECT_EQ(frame_outcome("G258 RPL=30\nG258\nG18"), "end");
  EXPECT_EQ(frame_outcome("G158 X5\nG18"), "end");
  EXPECT_EQ(frame_outcome("G258 RPL=30\nG2 X1 Z1 CR=5"), "plane-not-allowed G");
  EXPECT_EQ(frame_outcome("G158 X5\nG2 X6 Z1 CR=9"), "end");
}

// A plane that is refused is the plane that the words of its block are meant in: there K is an axis
// of the arc, and AR stands beside a centre and an end. Found by generated program 30,049,805.
TEST(SieFrame, ABlockIsCheckedInThePlaneThatIsRefused) {
  EXPECT_EQ(frame_outcome("G258 RPL=30\nG19 G2 J5 K5 AR=90 Z9 F9"),
            "conflicting-words AR, plane-not-allowed G");
  EXPECT_EQ(frame_outcome("G258 RPL=30\nG19 G2 J5 I5 AR=90 F9"),
            "axis-not-in-plane I, plane-not-allowed G");
}

// From base (10, 5) half round (10, 0).
TEST(SieFrame, AnArcTurnsWithItsCentre) {
  EXPECT_EQ(line("G158 X10\nG259 RPL=90\nG0 X5 Y0\nG3 X-5 Y0 I-5 F100", 1, s802()),
            "arc x10 y-5 c10,0 rot1 f100");
  EXPECT_EQ(line("G258 RPL=90\nG0 X5 Y0 Z0\nG2 I-5 Z4 F100", 1, s802()),
            "arc x0 y5 z4 c0,0 rot-1 f100");
}

TEST(SieFrame, ACircleThroughAPointTurnsWithItsPoints) {
  EXPECT_EQ(moves("G158 Z2\nG259 RPL=90\nCIP X10 Y0 Z-2 I1=5 J1=5 K1=-2 F100"),
            Lines{"arc3 x0 y10 z0 via x-5 y5 z0 f100"});
}

// After +X to (10, 0) the tangent arc to (15, 5) has its centre at (10, 5). In the turned frame the
// end is (5, -15).
TEST(SieFrame, ATangentArcFollowsTheMotionBeforeTheFrame) {
  EXPECT_EQ(line("G1 X10 F100\nG258 RPL=90\nCT X5 Y-15", 1, s802()), "arc x15 y5 c10,5 rot1 f100");
}

TEST(SieFrame, PolesArePlacesOfTheWorkpiece) {
  EXPECT_EQ(moves("G158 X10\nG0 AP=0 RP=5"), Lines{"rapid x15 y0"});
  EXPECT_EQ(line("G0 X5 Y0\nG158 X10\nG110\nG0 AP=90 RP=1", 1, s802()), "rapid x5 y1");
  EXPECT_EQ(moves("G258 RPL=90\nG111 X3 Y0\nG0 AP=0 RP=1"), Lines{"rapid x0 y4"});
}

// A pole may go along, stay on the machine or go back to the zero; G53 may leave a frame out.
TEST(SieFrame, WhatNoTextSaysOfAFrameIsNotCovered) {
  const Profile profile = s802();
  EXPECT_EQ(outcome("G111 X5\nG158 X10\nG0 AP=0 RP=1", profile), "not-covered RP");
  EXPECT_EQ(outcome("G110\nG258 RPL=30\nG112 X1", profile), "not-covered G112");
  EXPECT_EQ(outcome("G111 X5\nG158 X10\nG17\nG0 AP=0 RP=1", profile), "end");
  EXPECT_EQ(outcome("G111 X5\nG17\nG158 X10\nG0 AP=0 RP=1", profile), "end");
  const Profile kept = s802({{"sie.pole.same-plane", "kept"}});
  EXPECT_EQ(outcome("G111 X5\nG158 X10\nG17\nG0 AP=0 RP=1", kept), "not-covered RP");
  EXPECT_EQ(outcome("G111 X5\nG17\nG158 X10\nG0 AP=0 RP=1", kept), "not-covered RP");
  EXPECT_EQ(outcome("G111 X5\nG158\nG0 AP=0 RP=1", profile), "end");  // none was in force
  EXPECT_EQ(outcome("G158 X10\nG53 G0 X1", profile), "not-covered G53");
  EXPECT_EQ(outcome("G158 X10\nG53\nG0 X1", profile), "end");
  EXPECT_EQ(outcome("G158 X10\nG158\nG53 G0 X1", profile), "end");
}

TEST(SieFrame, TheSister840DHasNone) {
  EXPECT_EQ(outcome("G158 X1"), "undefined-code G");
  EXPECT_EQ(outcome("G258"), "undefined-code G");
}

TEST(SieFrame, The802SHasThreeHundredParameters) {
  EXPECT_EQ(frame_outcome("R299=1"), "end");
  EXPECT_EQ(frame_outcome("R300=1"), "value-out-of-range R300");
  EXPECT_EQ(frame_outcome("G0 X=R300"), "value-out-of-range X");
  EXPECT_EQ(outcome("R300=1"), "end");
}

// The helix of SieCt.AHelixClimbsInOtherPlanes, gone on in the same way through the workpiece: the
// rotation about X by 90 degrees names (Y10, Z10) as (Y10, Z-10), and the tool does not move
// (SIE-FRM-04).
TEST(SieFrame, AHelixClimbsOnBelowARotationOfAnotherPlane) {
  EXPECT_EQ(centre(last_motion("G2 I5 Z10 F9\nG19\nG258 RPL=90\nCT Y10 Z-10", s802())),
            "5.000000000,-5.707963268");
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
