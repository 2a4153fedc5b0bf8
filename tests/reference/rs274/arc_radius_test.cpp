// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs by their radius.
#include <gtest/gtest.h>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

std::string arc_record(const std::string& block, const Profile& profile = ngc()) {
  return path("F9\n" + block, profile).back();
}

// Chord 6 along X, R5: the centre is 4 off the chord; clockwise with at most half a turn it is on
// the right of the chord, here below.
TEST(NgcArcRadius, IsTheShortArcOrWithANegativeRTheLongOne) {
  EXPECT_EQ(arc_record("G2 X6 R5"), "arc x6 y0 c3,-4 rot-1 f9");
  EXPECT_EQ(arc_record("G2 X6 R-5"), "arc x6 y0 c3,4 rot-1 f9");
  EXPECT_EQ(arc_record("G3 X6 R5"), "arc x6 y0 c3,4 rot1 f9");
  EXPECT_EQ(arc_record("G3 X6 R-5"), "arc x6 y0 c3,-4 rot1 f9");
}

// A quarter of a turn about (0, 0) from (1, 0) to (0, 1).
TEST(NgcArcRadius, TheCentreOfAQuarterIsExact) {
  EXPECT_EQ(path("G0 X1\nG3 X0 Y1 R1 F9").at(1), "arc x0 y1 c0,0 rot1 f9");
  EXPECT_EQ(path("G0 X1\nG2 X0 Y1 R-1 F9").at(1), "arc x0 y1 c0,0 rot-1 f9");
}

// Chord 2, R2: the centre is sqrt(3) off.
TEST(NgcArcRadius, TheCentreMayBeARoot) {
  const Item item = expand("G3 X2 R2 F9", ngc()).front();
  const auto& record = std::get<Record>(item);
  EXPECT_EQ(record.centre[0], num("1"));
  EXPECT_EQ(record.centre[1], exact::sqrt(3));
}

// Chord (4, 2), R3: the chord's square is 20, so the centre is 2 = sqrt(9 - 5) off the middle
// (2, 1), along (-2, 4)/sqrt(20) where it is on the left: 2/sqrt(20) = 1/sqrt(5).
TEST(NgcArcRadius, TheCentreOfASlantedChordIsARoot) {
  const Item item = expand("G3 X4 Y2 R3 F9", ngc()).front();
  const auto& record = std::get<Record>(item);
  EXPECT_EQ(record.centre[0], num("2") - num("2") / exact::sqrt(5));
  EXPECT_EQ(record.centre[1], num("1") + num("4") / exact::sqrt(5));
}

TEST(NgcArcRadius, TurnsInThePlaneInForce) {
  EXPECT_EQ(arc_record("G18 G2 Z6 R5"), "arc x0 z6 c3,-4 rot-1 f9");
  EXPECT_EQ(arc_record("G19 G2 Y6 R5"), "arc y6 z0 c3,-4 rot-1 f9");
}

TEST(NgcArcRadius, NeedsAnAxisWordOfThePlane) {
  EXPECT_EQ(arc_record("G2 R5"), "alarm b2 missing-word");
  EXPECT_EQ(arc_record("G2 Z1 R5"), "alarm b2 missing-word");
}

TEST(NgcArcRadius, CannotEndWhereItStarts) {
  EXPECT_EQ(arc_record("G2 X0 R5"), "alarm b2 arc-end-point");
  EXPECT_EQ(arc_record("G2 X0 Z5 R5"), "alarm b2 arc-end-point");
  EXPECT_EQ(arc_record("G2 X0 R5", linuxcnc()), "alarm b2 arc-end-point");
}

TEST(NgcArcRadius, OfHalfTheChordIsHalfATurn) {
  EXPECT_EQ(arc_record("G2 X10 R5"), "arc x10 y0 c5,0 rot-1 f9");
  EXPECT_EQ(arc_record("G2 X10 R-5"), "arc x10 y0 c5,0 rot-1 f9");
  EXPECT_EQ(arc_record("G2 X10 R4.9999"), "alarm b2 arc-radius");
  EXPECT_EQ(arc_record("G2 X10 R-4.9999"), "alarm b2 arc-radius");
  EXPECT_EQ(arc_record("G2 X10 R0"), "alarm b2 arc-radius");
}

// Half the chord is 5: 5 - 4.9988 = 0.0012 <= 0.00127 < 0.0013 = 5 - 4.9987.
TEST(NgcArcRadius, OfLinuxcncALittleLessIsForgiven) {
  EXPECT_EQ(arc_record("G2 X10 R4.9988", linuxcnc()), "arc x10 y0 c5,0 rot-1 f9");
  EXPECT_EQ(arc_record("G3 X10 R-4.9988 P2", linuxcnc()), "arc x10 y0 c5,0 rot2 f9");
  EXPECT_EQ(arc_record("G2 X10 R4.9987", linuxcnc()), "alarm b2 arc-radius");
  EXPECT_EQ(arc_record("G2 X10 R4.99873", linuxcnc()), "arc x10 y0 c5,0 rot-1 f9");
  EXPECT_EQ(arc_record("G2 X10 R4.998729", linuxcnc()), "alarm b2 arc-radius");
}

// Chord 1 inch, R0.49995: 0.00005 inch less than half.
TEST(NgcArcRadius, OfLinuxcncInInchesTheSameIsForgiven) {
  EXPECT_EQ(arc_record("G20 G2 X1 R0.49995", linuxcnc()), "arc x25.4 y0 c12.7,0 rot-1 f9");
  EXPECT_EQ(arc_record("G20 G2 X1 R0.49994", linuxcnc()), "alarm b2 arc-radius");
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
