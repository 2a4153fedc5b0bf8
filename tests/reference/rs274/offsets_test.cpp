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

}  // namespace
}  // namespace gonogo::reference::testing::ngc
