// SPDX-License-Identifier: GPL-3.0-or-later
//
// LCYC82 on the pilot hole of the manual's rectangle.
#include <gtest/gtest.h>

#include "s802_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

std::string hole(std::string_view changes = "", std::string_view before = "G0") {
  return fmt::format(
      "{} F200 S300 M3\nG0 X60 Y40 Z5\n{}\nR101=5 R102=2 R103=0 R104=-17.5 R105=2\n{}\nLCYC82\n",
      before, before, changes);
}
Lines drills(std::string_view changes, std::string_view before = "G0") {
  Lines all = path(hole(changes, before), s802());
  all.erase(all.begin());
  return all;
}
std::string hole_outcome(std::string_view changes) {
  return outcome_of_program(hole(changes), s802());
}

TEST(Lcyc82, DrillsWhereTheToolStands) {
  EXPECT_EQ(drills(""), (Lines{"rapid z2", "feed z-17.5 f200", "dwell 2", "rapid z5"}));
  EXPECT_EQ(clauses(hole(), s802()).back(), "SIE-LC82-01");
}

TEST(Lcyc82, NoDwellOfZeroSeconds) {
  EXPECT_EQ(drills("R105=0"), (Lines{"rapid z2", "feed z-17.5 f200", "rapid z5"}));
  EXPECT_EQ(drills("R105=0.001")[2], "dwell 0.001");
}

TEST(Lcyc82, GoesAlongTheDepthAxisOfThePlane) {
  EXPECT_EQ(drills("", "G18"), (Lines{"rapid y2", "feed y-17.5 f200", "dwell 2", "rapid y5"}));
  EXPECT_EQ(drills("", "G19"), (Lines{"rapid x2", "feed x-17.5 f200", "dwell 2", "rapid x5"}));
}

TEST(Lcyc82, ItsPlanesAreOfTheFrame) {
  EXPECT_EQ(drills("G158 X1 Z10"), (Lines{"rapid z12", "feed z-7.5 f200", "dwell 2", "rapid z15"}));
  EXPECT_EQ(drills("G258 RPL=17"), drills(""));
}

TEST(Lcyc82, ItsFeedIsInInchesWhereThoseOfMotionsAre) {
  const std::string text = "G70 F10\nR101=5 R102=2 R104=-1\nLCYC82\n";
  EXPECT_EQ(path(text, s802({{"sie.g70.f", "inch"}})).at(1), "feed z-1 f254");
  EXPECT_EQ(path(text, s802({{"sie.g70.f", "mm"}})).at(1), "feed z-1 f10");
}

TEST(Lcyc82, ItsFeedIsThatInForce) {
  EXPECT_EQ(drills("G95 F0.1")[1], "feed z-17.5 f0.1/rev");
  EXPECT_EQ(outcome_of_program(hole("G95"), s802({{"sie.feed-change", "deleted"}})),
            "feed-missing F");
}

TEST(Lcyc82, TheRetractPlaneIsNotBelowTheClearance) {
  EXPECT_EQ(hole_outcome("R101=2"), "end");
  EXPECT_EQ(hole_outcome("R101=1.999"), "reference-plane R101");
  EXPECT_EQ(hole_outcome("R101=11 R103=9"), "end");
}

TEST(Lcyc82, AsPrintedTheManualsFirstProgramEndsAtTheCycle) {
  const std::string printed = rectangle_program("9");
  EXPECT_EQ(ending(printed, s802()), "alarm b4 reference-plane");
  EXPECT_EQ(outcome_of_program(printed, s802()), "reference-plane R101");
  EXPECT_EQ(clauses(printed, s802()).back(), "SIE-LC82-02");
}

TEST(Lcyc82, TheDepthIsBelowTheReferencePlane) {
  EXPECT_EQ(hole_outcome("R104=-0.001"), "end");
  EXPECT_EQ(hole_outcome("R104=0"), "reference-plane R104");
  EXPECT_EQ(hole_outcome("R104=1"), "reference-plane R104");
}

TEST(Lcyc82, ClearanceAndDwellAreNotBelowZero) {
  EXPECT_EQ(hole_outcome("R102=0"), "end");
  EXPECT_EQ(hole_outcome("R102=-0.001"), "value-sign R102");
  EXPECT_EQ(hole_outcome("R105=-0.001"), "value-sign R105");
  EXPECT_EQ(clauses(hole("R102=-1"), s802()).back(), "SIE-LC82-04");
}

TEST(Lcyc82, NeedsAFeed) {
  EXPECT_EQ(hole_outcome("F0"), "feed-missing F");
  EXPECT_EQ(outcome_of_program("LCYC82", s802()), "reference-plane R104, feed-missing F");
}

TEST(Lcyc82, AllBrokenRulesAreReportedInTheOrderOfTheirParameters) {
  EXPECT_EQ(hole_outcome("R105=-1 R104=1 R102=-1 R101=-2"),
            "reference-plane R101, value-sign R102, reference-plane R104, value-sign R105");
}

TEST(Lcyc82, MessagesHaveTheNumbersOfTheProgramAlsoInInches) {
  const Item last =
      expand("G70 F10\nR101=-5 R102=-1 R104=3\nLCYC82", s802({{"sie.lcyc.unit", "inch"}})).back();
  Lines messages;
  for (const Alarm& alarm : std::get<AlarmReport>(last).alarms) messages.push_back(alarm.message);
  EXPECT_EQ(messages,
            (Lines{"The retract plane R101 = -5 lies below the clearance R103 + R102 = -1.",
                   "The safety clearance R102 = -1 is below zero.",
                   "The depth R104 = 3 is not below the reference plane R103 = 0."}));
}

TEST(Lcyc82, AnAlarmStandsAtTheCall) {
  const Item last = expand("F9\nN10  LCYC82", s802()).back();
  EXPECT_EQ(std::get<AlarmReport>(last).alarms.at(0).where.begin, 5U);
}

TEST(Lcyc82, TheSpindleIsAReading) {
  const Profile alarm = s802({{"sie.spindle", "alarm"}});
  EXPECT_EQ(hole_outcome("M5"), "end");
  EXPECT_EQ(outcome_of_program(hole("M5"), alarm), "spindle-stopped S");
  EXPECT_EQ(outcome_of_program(hole(), alarm), "end");
}

TEST(Lcyc82, StandsAlone) {
  const std::string set = "F200\nR101=5 R104=-5\n";
  const auto beside = [&](std::string_view block) {
    return outcome_of_program(set + std::string(block), s802());
  };
  EXPECT_EQ(beside("N10 LCYC82"), "end");
  EXPECT_EQ(beside("lcyc82"), "end");
  EXPECT_EQ(beside("G1 LCYC82"), "conflicting-words G");
  EXPECT_EQ(beside("LCYC82 M3"), "conflicting-words M");
  EXPECT_EQ(beside("LCYC82 F5"), "conflicting-words F");
  EXPECT_EQ(beside("R101=5 LCYC82"), "conflicting-words R101");
  EXPECT_EQ(beside("CT LCYC82"), "conflicting-words CT");
  EXPECT_EQ(beside("LCYC82 LCYC82"), "conflicting-words LCYC82");
  EXPECT_EQ(beside("LCYC75 LCYC82"), "conflicting-words LCYC82");
}

TEST(Lcyc82, LeavesFeedMotionAndPlaneAsTheyWere) {
  EXPECT_EQ(path(hole("G1") + "X5", s802()).back(), "feed x5 f200");
  EXPECT_EQ(path(hole("") + "X5 G0", s802()).back(), "rapid x5");
  EXPECT_EQ(path(hole("", "G18") + "G3 Z10 X60 CR=9 G18", s802()).back().substr(0, 3), "arc");
  EXPECT_EQ(ending(hole(), s802()), "end x60 y40 z5 a0 c0");
}

// The place of 17 degrees is known as such after the hole as before it.
TEST(Lcyc82, ThePlaceInThePlaneStaysKnown) {
  const Record arc = last_motion("F9\nG0 AP=17 RP=10\nR101=5 R104=-5\nLCYC82\nG3 AP=17", s802());
  EXPECT_EQ(arc.kind, RecordKind::arc);
  EXPECT_EQ(arc.rot, 1);
}

TEST(Lcyc82, ATangentArcAfterItHasNoDirection) {
  EXPECT_EQ(outcome_of_program(hole() + "CT X5 Y5", s802()), "arc-tangent X");
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
