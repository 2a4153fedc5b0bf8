// SPDX-License-Identifier: GPL-3.0-or-later
// Poles and polar targets of the expander of sinumerik840d.
#include <gtest/gtest.h>

#include "sinumerik_outcomes.hpp"

namespace gonogo::expanders::testing {
namespace {

// 20 + 50 cos 30 = 63.301270189, 63.301270189 - 10 + 30 cos 45 = 74.5144736248, ...
// The last x is 20 + 50 cos 30 - 10 + 40 - 30 cos 45 = 72.08806675362551: the places before it
// are not rounded.
TEST(SinumerikPolar, ChainOfPoles) {
  EXPECT_EQ(motions_and_alarm("G111 X20 Y10\nG0 RP=50 AP=30\nG110 X-10 Y20\nRP=30 AP=45\n"
                              "G112 X40 Y20\nRP=30 AP=135\n"),
            "rapid x=63.301270189 y=35\nrapid x=74.514473625 y=76.213203436\n"
            "rapid x=72.088066754 y=96.213203436\n");
}

// 40 + 12.207 cos 21 and 33 + 12.207 sin 21; sqrt(149) is 4e-4 less than 12.207.
TEST(SinumerikPolar, CircleAboutThePole) {
  const std::string arc = motions_and_alarm("G0 X30 Y40\nG111 X40 Y33\nG2 RP=12.207 AP=21 F9\n");
  EXPECT_NE(arc.find(" rot=-1 x=51.396216266 y=37.37459756 f=9\n"), std::string::npos) << arc;
}

TEST(SinumerikPolar, PolesAreNotByG90AndG91) {
  EXPECT_EQ(motions_and_alarm("G0 X5\nG110 X1 Y1\nRP=1 AP=0\n"), "rapid x=5\nrapid x=7 y=1\n");
  EXPECT_EQ(motions_and_alarm("G91 G0 X5\nG111 X1 Y1\nRP=1 AP=0\n"), "rapid x=5\nrapid x=2 y=1\n");
  EXPECT_EQ(motions_and_alarm("G0 X5\nG110 X=AC(1) Y=IC(1)\nRP=1 AP=0\n"),
            "rapid x=5\nrapid x=7 y=1\n");
}

TEST(SinumerikPolar, PoleByAngleAndRadius) {
  EXPECT_EQ(motions_and_alarm("G111 RP=2 AP=90\nG0 RP=1 AP=0\n"), "rapid x=1 y=2\n");
  EXPECT_EQ(motions_and_alarm("G111 RP=2\n"), "missing-word");
}

TEST(SinumerikPolar, PoleCodesAlone) {
  EXPECT_EQ(motions_and_alarm("G0 X5\nG110\nRP=1 AP=0\n"), "rapid x=5\nrapid x=6 y=0\n");
  EXPECT_EQ(motions_and_alarm("G111 X5\nG111\nG0 RP=1 AP=0\n"), "rapid x=1 y=0\n");
  EXPECT_EQ(motions_and_alarm("G111 X5\nG112\nG0 RP=1 AP=0\n"), "rapid x=6 y=0\n");
}

TEST(SinumerikPolar, AngleAndRadiusStay) {
  EXPECT_EQ(motions_and_alarm("G0 RP=2 AP=90\nAP=180\nRP=3\n"),
            "rapid x=0 y=2\nrapid x=-2 y=0\nrapid x=-3 y=0\n");
  EXPECT_EQ(motions_and_alarm("G0 RP=2 AP=90\nG111 X1\nAP=0\n"), "rapid x=0 y=2\nmissing-word");
  EXPECT_EQ(motions_and_alarm("G0 RP=2 AP=90\nG17 RP=1\n"), "rapid x=0 y=2\nmissing-word");
}

TEST(SinumerikPolar, APlaneCodePutsThePoleAtZero) {
  EXPECT_EQ(motions_and_alarm("G111 X5 Y5\nG17 G0 RP=1 AP=0\n"), "rapid x=1 y=0\n");
  EXPECT_EQ(motions_and_alarm("G111 X5 Y5\nG18 G0 RP=1 AP=90\n"), "rapid x=1 z=0\n");
}

// 5 and 1 more along X.
TEST(SinumerikPolar, TheCodeOfThePlaneInForceLeavesThePoleUnderThatReading) {
  const char* kept = R"({"readings":{"sie.pole.same-plane":"kept"}})";
  EXPECT_EQ(motions_and_alarm("G111 X5 Y5\nG17 G0 RP=1 AP=0\n", kept), "rapid x=6 y=5\n");
  EXPECT_EQ(motions_and_alarm("G0 RP=2 AP=90\nG17 RP=1\n", kept), "rapid x=0 y=2\nrapid x=0 y=1\n");
  EXPECT_EQ(motions_and_alarm("G0 RP=2 AP=90\nG18\nG17 RP=1\n", kept),
            "rapid x=0 y=2\nmissing-word");
}

TEST(SinumerikPolar, IncrementalAngle) {
  EXPECT_EQ(motions_and_alarm("G0 RP=2 AP=90\nAP=IC(90)\nAP=IC(-270)\n"),
            "rapid x=0 y=2\nrapid x=-2 y=0\nrapid x=0 y=-2\n");
  EXPECT_EQ(motions_and_alarm("G91 G0 RP=2 AP=90\nAP=180\n"), "rapid x=0 y=2\nrapid x=-2 y=0\n");
  EXPECT_EQ(motions_and_alarm("G0 RP=2 AP=IC(90)\n"), "missing-word");
}

TEST(SinumerikPolar, CylinderAndRotaryAxes) {
  EXPECT_EQ(motions_and_alarm("G0 RP=2 AP=90 Z5 A7\n"), "rapid x=0 y=2 z=5 a=7\n");
  EXPECT_EQ(motions_and_alarm("G19 G1 RP=2 AP=90 X=IC(5) F9\n"), "feed x=5 y=0 z=2 f=9\n");
}

TEST(SinumerikPolar, Alarms) {
  EXPECT_EQ(motions_and_alarm("G0 RP=-1 AP=0\n"), "value-sign");
  EXPECT_EQ(motions_and_alarm("G0 RP=1 AP=360.001\n"), "value-out-of-range");
  EXPECT_EQ(motions_and_alarm("G0 RP=1 AP=-360.001\n"), "value-out-of-range");
  EXPECT_EQ(motions_and_alarm("G0 RP=1 AP=-360\n"), "rapid x=1 y=0\n");
  EXPECT_EQ(motions_and_alarm("G0 RP=1 AP=0 X1\n"), "conflicting-words");
  EXPECT_EQ(motions_and_alarm("G18 G0 RP=1 AP=0 X1\n"), "conflicting-words");
  EXPECT_EQ(motions_and_alarm("G111 Z1\n"), "conflicting-words");
  EXPECT_EQ(motions_and_alarm("G111 X1 RP=1 AP=0\n"), "conflicting-words");
  EXPECT_EQ(motions_and_alarm("G111 X1 M8\n"), "conflicting-words");
  EXPECT_EQ(motions_and_alarm("G111 G0 X1\n"), "conflicting-words");
  EXPECT_EQ(motions_and_alarm("G110 G111 X1\n"), "duplicate-word");
  EXPECT_EQ(motions_and_alarm("G2 RP=1 AP=0 I1 F9\n"), "conflicting-words");
  EXPECT_EQ(motions_and_alarm("G2 RP=1 AP=0 F9\n"), "arc-radius");
}

TEST(SinumerikPolar, Inches) {
  EXPECT_EQ(motions_and_alarm("G70\nG111 X1\nG0 RP=1 AP=0\n"), "rapid x=50.8 y=0\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
