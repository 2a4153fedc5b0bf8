// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offsets. Numbers are the documents' examples, or follow from coordinate = place - origin.
#include <gtest/gtest.h>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

// A tool 40 long, a reference point, and two coordinate systems.
Profile machine(
    std::initializer_list<std::pair<std::string_view, std::string_view>> readings = {}) {
  Profile profile = ngc(readings);
  profile.tools["1"].length = 40;
  profile.reference_point[Axis::z] = 100;
  profile.parameters["5181"] = 7;
  profile.offsets["G55"][Axis::x] = 50;
  profile.offsets["G59.3"][Axis::y] = -2;
  return profile;
}

// The documents: G10 L2 P1 X3.5 Y17.2.
TEST(NgcOffsets, G10L2PutsTheOrigin) {
  EXPECT_EQ(path("G10 L2 P1 X3.5 Y17.2\nG0 X1 Y-1 Z1"), Lines{"rapid x4.5 y16.2 z1"});
  EXPECT_EQ(path("G10 L2 P2 X3\nG0 X1\nG55 X1\nG54 X1"),
            (Lines{"rapid x1", "rapid x4", "rapid x1"}));
}

TEST(NgcOffsets, G10L20GivesThePositionItsCoordinates) {
  EXPECT_EQ(path("G0 X10\nG10 L20 P1 X1.5\nX1.5\nX0"),
            (Lines{"rapid x10", "rapid x10", "rapid x8.5"}));
}

TEST(NgcOffsets, TheProfileSaysWhereSystemsLie) {
  EXPECT_EQ(path("G0 X1 Y1\nG55 X1 Y1\nG59.3 X1 Y1", machine()),
            (Lines{"rapid x1 y1", "rapid x51 y1", "rapid x1 y-1"}));
}

// The documents: at X4 without an offset G92 X7 moves all origins by -3.
TEST(NgcOffsets, G92GivesThePositionItsCoordinates) {
  EXPECT_EQ(path("G0 X4\nG92 X7\nX7\nX0"), (Lines{"rapid x4", "rapid x4", "rapid x-3"}));
  EXPECT_EQ(path("G0 X4\nG92 X7\nG92.1\nX1\nG92.3\nX1"),
            (Lines{"rapid x4", "rapid x1", "rapid x1"}));
  EXPECT_EQ(path("G0 X4\nG92 X7\nG92.2\nX1\nG92.3\nX1"),
            (Lines{"rapid x4", "rapid x1", "rapid x-2"}));
}

// Zero as the page says: X back to 5 - 0; kept as LinuxCNC 2.9 prints it: origin X4, Y5.
TEST(NgcOffsets, AnAxisThatG92DoesNotName) {
  constexpr const char* kProgram = "G0 X5 Y6\nG92 X1\nG92 Y1\nX0 Y0";
  EXPECT_EQ(path(kProgram, ngc({{"ngc.g92-other-axes", "zero"}})).at(1), "rapid x0 y5");
  EXPECT_EQ(path(kProgram, ngc({{"ngc.g92-other-axes", "kept"}})).at(1), "rapid x4 y5");
  EXPECT_EQ(touched(std::string(kProgram) + "\nM2"), Lines{"ngc.g92-other-axes"});
}

TEST(NgcOffsets, TheToolLengthMovesWhatFollows) {
  EXPECT_EQ(path("G43 H1\nG0 Z2\nG49 Z2", machine()), (Lines{"rapid z42", "rapid z2"}));
  EXPECT_EQ(path("T1 M6 G43 G0 Z2", machine()), Lines{"rapid z42"});
  EXPECT_EQ(path("G43.1 Z0.25 \nG0 Z1"), Lines{"rapid z1.25"});
  EXPECT_EQ(ending_of("G43 H7", machine()), "not-covered b1 profile");
}

TEST(NgcOffsets, ReferencePointsAreTheMachines) {
  EXPECT_EQ(path("G10 L2 P1 X5\nG0 X1 Z1\nG28 Z2.5", machine()),
            (Lines{"rapid x6 z1", "rapid z2.5", "rapid z100"}));
  EXPECT_EQ(path("G0 X1\nG30 X3", machine()).back(), "rapid x7");
  EXPECT_EQ(path("G0 X1\nG28.1\nX2\nG28 X3").back(), "rapid x1");
}

// NIST 3.5.8: the reference point is reached along all axes, whichever the block names.
TEST(NgcOffsets, AxesWithoutAWordGoToTheReferencePointOrStay) {
  const Profile all = ngc({{"ngc.g28-axes", "all"}});
  const Profile named = ngc({{"ngc.g28-axes", "named"}});
  const std::string program = "G0 X1 Y2 Z3\nG28 Z5\nM2";
  EXPECT_EQ(path(program, named), (Lines{"rapid x1 y2 z3", "rapid z5", "rapid z0"}));
  EXPECT_EQ(path(program, all), (Lines{"rapid x1 y2 z3", "rapid z5", "rapid x0 y0 z0 a0 c0"}));
  EXPECT_EQ(touched(program), Lines{"ngc.g28-axes"});
  // The others are there, all are named, or none is.
  EXPECT_EQ(touched("G0 Z3\nG28 Z5\nM2"), Lines{});
  EXPECT_EQ(touched("G0 X1\nG28 X2 Y2 Z2 A0 C0\nM2"), Lines{});
  EXPECT_EQ(touched("G0 X1\nG28\nM2"), Lines{});
  EXPECT_EQ(touched("G0 X1\nG28 G0 Z2\nM2"), Lines{});  // an alarm under both
  // X and Y are turned by 17 degrees, whose sine is no root: they are not compared.
  EXPECT_EQ(path("G10 L2 P1 X5 R17\nG0 X1 Y2\nG28 X3 Y3\nM2").size(), 3U);
}

TEST(NgcOffsets, P0OfG10L2IsTheSystemInForceOrAnAlarm) {
  const std::string program = "G10 L2 P0 X5\nG0 X1\nM2";
  EXPECT_EQ(path(program, ngc({{"ngc.g10-p0", "in-force"}})), Lines{"rapid x6"});
  EXPECT_EQ(ending_of(program, ngc({{"ngc.g10-p0", "alarm"}})), "alarm b1 value-out-of-range");
  EXPECT_EQ(touched(program), Lines{"ngc.g10-p0"});
  EXPECT_EQ(touched("G10 L2 P1 X5\nG10 L20 P0 X5\nM2"), Lines{});
}

TEST(NgcOffsets, G43WithoutHTakesTheLoadedToolOrIsAnAlarm) {
  const Profile loaded = machine({{"ngc.g43-without-h", "loaded"}});
  const Profile needed = machine({{"ngc.g43-without-h", "missing-word"}});
  EXPECT_EQ(path("T1 M6\nG43\nG0 Z2", loaded), Lines{"rapid z42"});
  EXPECT_EQ(ending_of("T1 M6\nG43\nG0 Z2", needed), "alarm b2 missing-word");
  EXPECT_EQ(path("G43 H1\nG0 Z2", needed), Lines{"rapid z42"});
}

TEST(NgcOffsets, G53HasNoOffsets) {
  EXPECT_EQ(path("G55 G43 H1 G0 X1 Z1\nG53 X2 Z2\nX3", machine()),
            (Lines{"rapid x51 z41", "rapid x2 z2", "rapid x53"}));
  EXPECT_EQ(ending_of("G0 G91\nG53 X1"), "alarm b2 conflicting-words");
  EXPECT_EQ(ending_of("F1 G81 X1 Z-1 R1\nG53 X1"), "alarm b2 conflicting-words");
}

// Centre and end of an arc move alike; an initial level is a place.
TEST(NgcOffsets, ArcsAndCyclesMoveAsAWhole) {
  EXPECT_EQ(path("G55 F1 G0 X0\nG2 X10 I5", machine()).back(), "arc x60 y0 c55,0 rot-1 f1");
  EXPECT_EQ(path("G10 L2 P2 Z5\nF1 G0 Z20\nG98 G81 X1 Z-2 R2\nG55 X2"),
            (Lines{"rapid z20", "rapid x1 y0", "rapid z2", "feed z-2 f1", "rapid z20",
                   "rapid x2 y0", "rapid z7", "feed z3 f1", "rapid z20"}));
}

// A quarter of a turn takes (x, y) to (-y, x); half of one takes it to (-x, -y).
TEST(NgcOffsets, RTurnsTheSystemAboutItsOrigin) {
  EXPECT_EQ(path("G10 L2 P1 X5 R90\nG0 X3 Y1\nG1 X4 F9\nG3 X2 I-1\nG10 L2 P1 R0\nG0 X0 Y0"),
            (Lines{"rapid x4 y3", "feed x4 y4 f9", "arc x4 y2 c4,3 rot1 f9", "rapid x5 y0"}));
  EXPECT_EQ(path("G10 L2 P1 R180\nG0 X1 Y2\nG91 X1\nZ1"),
            (Lines{"rapid x-1 y-2", "rapid x-2 y-2", "rapid z1"}));
  EXPECT_EQ(path("G10 L2 P2 R90\nG0 X1\nG55 X2\nG54 X2"),
            (Lines{"rapid x1", "rapid x1 y2", "rapid x2"}));
}

// The documents: an offset of G92 or G52 is applied after the rotation. G92 X0 at (0, 3) of the
// machine, x' = 3: the axis X' points along Y.
TEST(NgcOffsets, G92AndG52AreAlongTurnedAxes) {
  EXPECT_EQ(path("G10 L2 P1 R90\nG0 X3\nG92 X0\nX1").back(), "rapid x0 y4");
  EXPECT_EQ(path("G10 L2 P1 R90\nG52 X2\nG0 X1 Y1").back(), "rapid x-1 y3");
}

// G53 leaves Y of the machine where it is; G30 goes first to X1 Y1 of the program.
TEST(NgcOffsets, PlacesOfTheMachineDoNotTurn) {
  EXPECT_EQ(path("G10 L2 P1 R90\nG0 X3 Y1\nG53 X7"), (Lines{"rapid x-1 y3", "rapid x7 y3"}));
  EXPECT_EQ(path("G10 L2 P1 R90\nG0 X3 Y1\nG30 X1 Y1", machine()),
            (Lines{"rapid x-1 y3", "rapid x-1 y1", "rapid x7 y0"}));
  EXPECT_EQ(ending_of("G10 L2 P1 R90\nG0 X3 Y1\nG30 X1"), "not-covered b3 G28");
  EXPECT_EQ(path("G10 L2 P1 R90\nG0 X3 Y1\nG10 L20 P1 X0\nX1").back(), "rapid x-1 y4");
}

TEST(NgcOffsets, ATurnedCycleIsAlongTheThirdAxis) {
  EXPECT_EQ(path("G10 L2 P1 R90\nG0 Z5\nG99 G81 X2 Y0 Z-1 R1 F9"),
            (Lines{"rapid z5", "rapid x0 y2", "rapid z1", "feed z-1 f9", "rapid z1"}));
  EXPECT_EQ(ending_of("G10 L2 P1 R90\nF9 G18 G2 X2 I1"), "not-covered b2 rotation");
  EXPECT_EQ(ending_of("G10 L2 P1 R90\nM3 G33 X2 K1"), "not-covered b2 rotation");
}

// The documents: G52 X1 Y2 reduces the coordinates of the position by 1 and 2; Z stays.
TEST(NgcOffsets, G52IsALocalOrigin) {
  EXPECT_EQ(path("G52 X1 Y2\nG0 X0 Y0 Z0\nG52 X0\nX0 Y0"),
            (Lines{"rapid x1 y2 z0", "rapid x0 y2"}));
  EXPECT_EQ(path("G0 X4\nG92 X7\nG52 X1\nX0").back(), "rapid x1");
  EXPECT_EQ(ending_of("G52"), "alarm b1 missing-word");
}

// A tool 40 long stands at Z50 of the machine: Z10 of the program under G43. L10 Z1.5 makes it
// 48.5 long, L11 with G59.3 at Z0 too.
TEST(NgcOffsets, G10SetsWhatAToolMovesTheAxesBy) {
  EXPECT_EQ(path("G10 L1 P1 Z5 R2\nG43 H1\nG0 Z1", machine()), Lines{"rapid z6"});
  EXPECT_EQ(path("G43 H1\nG0 Z10\nG10 L10 P1 Z1.5\nZ0\nG43 H1 Z0", machine()),
            (Lines{"rapid z50", "rapid z40", "rapid z48.5"}));
  EXPECT_EQ(path("G10 L2 P1 Z3\nG0 Z47\nG10 L11 P1 Z1.5\nG43 H1 Z0", machine()).back(),
            "rapid z51.5");
  EXPECT_EQ(ending_of("G10 L1 Z5", machine()), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G10 L1 P0 Z5", machine()), "alarm b1 value-out-of-range");
  EXPECT_EQ(ending_of("G10 L1 P2 Z5", machine()), "alarm b1 no-tool");
  EXPECT_EQ(ending_of("G10 L0", machine()), "not-covered b1 G10");
  EXPECT_EQ(ending_of("G10 L2 P1 X1 I1"), "alarm b1 unused-word");
  // What nothing uses may be passed over, and changes nothing then.
  const Profile ignores = ngc({{"ngc.unused-words", "ignored"}});
  EXPECT_EQ(path("G10 L2 P1 X5 I3 J4 Q2\nG0 X1", ignores), Lines{"rapid x6"});
  EXPECT_EQ(path("G0 X1\nG10 L20 P1 X5 R90 I3\nX6", ignores), (Lines{"rapid x1", "rapid x2"}));
}

TEST(NgcOffsets, G43Point2AddsToTheToolLength) {
  EXPECT_EQ(path("G43 H1\nG43.2 H1\nG43.2 Z1 X2\nG0 X0 Z0", machine()), Lines{"rapid x2 z81"});
  EXPECT_EQ(ending_of("G43.2"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G43.2 H1 Z1", machine()), "alarm b1 conflicting-words");
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
