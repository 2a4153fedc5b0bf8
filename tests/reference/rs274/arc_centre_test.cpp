// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs by their centre: full circles, and how far the end may miss the circle.
#include <gtest/gtest.h>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

constexpr const char* kDone = "end";

// How a block ends after the machine stood at the origin: an alarm, or "end".
std::string outcome(const std::string& block, const Profile& profile = ngc()) {
  const std::string last = ending_of("F100\n" + block, profile);
  return last.starts_with("end") ? kDone : last;
}

TEST(NgcArcCentre, AnEndAtTheStartIsAFullCircle) {
  EXPECT_EQ(path("G0 X1 Y2\nG2 X1 Y2 I3 J4 F9").at(1), "arc x1 y2 c4,6 rot-1 f9");
  EXPECT_EQ(path("G0 X1 Y2\nG3 X1 I3 F9 P2").at(1), "arc x1 y2 c4,2 rot2 f9");
}

TEST(NgcArcCentre, AFullCircleMayNeedAxisWords) {
  const Profile needed = ngc({{"ngc.full-circle-words", "needed"}});
  EXPECT_EQ(path("G2 I3 F9"), Lines{"arc x0 y0 c3,0 rot-1 f9"});
  EXPECT_EQ(outcome("G2 I3", needed), "alarm b2 missing-word");
  EXPECT_EQ(outcome("G2 Z1 I3", needed), "alarm b2 missing-word");
  EXPECT_EQ(outcome("G2 I3\nI4", needed), "alarm b2 missing-word");
  EXPECT_EQ(outcome("G2 Y0 I3", needed), kDone);
  EXPECT_EQ(outcome("G18 G2 Y0 I3", needed), "alarm b2 missing-word");
}

// NIST's interpreter wants a radius at both ends, LinuxCNC one of 0.00127 mm.
TEST(NgcArcCentre, AnEndInTheCentreHasNoRadius) {
  EXPECT_EQ(outcome("G2 X0.002 I0.002"), "alarm b2 arc-radius");
  EXPECT_EQ(outcome("G2 X0.0015 I0.0015", ngc({{"ngc.arc-tolerance", "linuxcnc"}})),
            "alarm b2 arc-radius");
  EXPECT_EQ(outcome("G2 X0.002 I0.001", ngc({{"ngc.arc-tolerance", "nist"}})), kDone);
  // Nor has it a way, which F of inverse time would count.
  EXPECT_EQ(outcome("G93 G2 X0.002 I0.002 F1"), "alarm b2 arc-radius");
  EXPECT_EQ(outcome("G93 G2 I0 F1"), "alarm b2 arc-radius");
}

// Half a turn about (r, 0) from the origin: the radii are r and x - r.
TEST(NgcArcCentre, ThePageAndGrblAllowAThousandth) {
  const Profile page = ngc({{"ngc.arc-tolerance", "page"}});
  const Profile grbl = ngc({{"ngc.arc-tolerance", "grbl"}});
  const std::string refused = "alarm b2 arc-end-point";
  for (const Profile& profile : {page, grbl}) {
    EXPECT_EQ(outcome("G2 X2.005 I1", profile), kDone);     // 1 and 1.005
    EXPECT_EQ(outcome("G2 X2.0051 I1", profile), refused);  // 1 and 1.0051
    EXPECT_EQ(outcome("G2 X199.9 I100", profile), kDone);   // 100 and 99.9
    EXPECT_EQ(outcome("G2 X199.8999 I100", profile), refused);
    EXPECT_EQ(outcome("G2 X1999.5 I1000", profile), kDone);  // 1000 and 999.5
    EXPECT_EQ(outcome("G2 X1999.4999 I1000", profile), refused);
  }
  // 99.9 and 100: a thousandth of the larger, more of the one at the start.
  EXPECT_EQ(outcome("G2 X199.9 I99.9", page), kDone);
  EXPECT_EQ(outcome("G2 X199.9 I99.9", grbl), refused);
  // 0.0005 inch is 0.0127 mm.
  EXPECT_EQ(outcome("G20 G2 X0.2005 I0.1", page), kDone);
  EXPECT_EQ(outcome("G20 G2 X0.20051 I0.1", page), refused);
  EXPECT_EQ(outcome("G20 G2 X0.2005 I0.1", grbl), refused);
}

TEST(NgcArcCentre, ReadingsAreAskedForOnlyWhereTheyMatter) {
  EXPECT_EQ(touched("F9\nG2 X2 I1\nX4 R1\nX6.002 I1\nM2"), Lines{});
  EXPECT_EQ(touched("F9\nG2 I1\nM2"), Lines{"ngc.full-circle-words"});
  EXPECT_EQ(touched("F9\nG2 X2.0021 I1\nM2"), Lines{"ngc.arc-tolerance"});
  EXPECT_EQ(touched("F9\nG2 X10 R4.9988\nM2"), Lines{"ngc.arc-tolerance"});
  EXPECT_EQ(touched("F9\nG2 X10 R4.9987\nM2"), Lines{});
  EXPECT_EQ(touched("F9\nG2 X20 I1\nM2"), Lines{});  // 1 and 19: an alarm under both
}

// The centre (1,0) stays where it is programmed.
TEST(NgcArcCentre, TheCentreStaysWithinTheTolerance) {
  EXPECT_EQ(path("G2 X2.002 I1 F9"), Lines{"arc x2.002 y0 c1,0 rot-1 f9"});
}

// The radii are 1 and 1 + d, or 1 - d.
TEST(NgcArcCentre, OfNistTheRadiiDifferByTwoMicrometresAtMost) {
  EXPECT_EQ(outcome("G2 X2.002 I1"), kDone);
  EXPECT_EQ(outcome("G2 X2.0021 I1"), "alarm b2 arc-end-point");
  EXPECT_EQ(outcome("G2 X2.002000001 I1"), "alarm b2 arc-end-point");
  EXPECT_EQ(outcome("G2 X1.998 I1"), kDone);
  EXPECT_EQ(outcome("G2 X1.9979 I1"), "alarm b2 arc-end-point");
  EXPECT_EQ(clauses("G2 X1.9979 I1 F9"), Lines{"NGC-ARC-03"});
}

// A 3-4-5 triangle: the radius at the start is 5 by (3,4), at the end 5 + d along X.
TEST(NgcArcCentre, TheToleranceHoldsOffTheAxes) {
  EXPECT_EQ(outcome("G3 X8.002 Y4 I3 J4"), kDone);
  EXPECT_EQ(outcome("G3 X8.0021 Y4 I3 J4"), "alarm b2 arc-end-point");
  // (3.0012, 4.0016) is 5.002 long; the end of both coordinates a ten-thousandth on is longer.
  EXPECT_EQ(outcome("G3 X6.0012 Y8.0016 I3 J4"), kDone);
  EXPECT_EQ(outcome("G3 X6.0012 Y8.0017 I3 J4"), "alarm b2 arc-end-point");
}

// 0.0002 inch.
TEST(NgcArcCentre, OfNistTheToleranceInInchesIsAnother) {
  EXPECT_EQ(outcome("G20 G2 X2.0002 I1"), kDone);
  EXPECT_EQ(outcome("G20 G2 X2.0003 I1"), "alarm b2 arc-end-point");
  EXPECT_EQ(outcome("G20 G2 X2.00020001 I1"), "alarm b2 arc-end-point");
}

TEST(NgcArcCentre, OfNistARadiusOfZeroIsOneThatIsZero) {
  EXPECT_EQ(outcome("G2 X0 I0"), "alarm b2 arc-radius");
  EXPECT_EQ(outcome("G2 X0.002 I0"), "alarm b2 arc-radius");
  EXPECT_EQ(outcome("G2 X1 I0 J0"), "alarm b2 arc-radius arc-end-point");
  EXPECT_EQ(outcome("G2 X0.0002 I0.0001"), kDone);
}

// Radii 100 and 100 + d. 0.02 sqrt2 = 0.028284..., 0.001 of the larger is 0.1001001... at
// d = 0.1001001...: d <= 0.001 (100 + d) where d <= 100/999 = 0.1001001...
TEST(NgcArcCentre, OfLinuxcncAThousandthOfTheLargerRadiusIsAllowed) {
  EXPECT_EQ(outcome("G2 X200.1001 I100", linuxcnc()), kDone);
  EXPECT_EQ(outcome("G2 X200.1002 I100", linuxcnc()), "alarm b2 arc-end-point");
  // The larger one at the start: d <= 0.1.
  EXPECT_EQ(outcome("G2 X199.9 I100", linuxcnc()), kDone);
  EXPECT_EQ(outcome("G2 X199.8999 I100", linuxcnc()), "alarm b2 arc-end-point");
}

// 0.0282^2 = 0.00079524, 0.0283^2 = 0.00080089; a thousandth of 1.03 is far below.
TEST(NgcArcCentre, OfLinuxcncASmallDifferenceIsAllowed) {
  EXPECT_EQ(outcome("G2 X2.0282 I1", linuxcnc()), kDone);
  EXPECT_EQ(outcome("G2 X2.0283 I1", linuxcnc()), "alarm b2 arc-end-point");
  EXPECT_EQ(outcome("G2 X1.9718 I1", linuxcnc()), kDone);
  EXPECT_EQ(outcome("G2 X1.9717 I1", linuxcnc()), "alarm b2 arc-end-point");
}

// 2.8284^2 = 7.99984656, 2.8285^2 = 8.00041225; a thousandth of 10000 is 10.
TEST(NgcArcCentre, OfLinuxcncALargeDifferenceIsNot) {
  EXPECT_EQ(outcome("G2 X20002.8284 I10000", linuxcnc()), kDone);
  EXPECT_EQ(outcome("G2 X20002.8285 I10000", linuxcnc()), "alarm b2 arc-end-point");
}

// 0.002 sqrt2 = 0.0028284... and 0.2 sqrt2 = 0.28284... inch; a thousandth of 1000 inch is 1.
TEST(NgcArcCentre, OfLinuxcncTheTolerancesInInchesAreATenth) {
  EXPECT_EQ(outcome("G20 G2 X2.0028 I1", linuxcnc()), kDone);
  EXPECT_EQ(outcome("G20 G2 X2.0029 I1", linuxcnc()), "alarm b2 arc-end-point");
  EXPECT_EQ(outcome("G20 G2 X2000.2828 I1000", linuxcnc()), kDone);
  EXPECT_EQ(outcome("G20 G2 X2000.2829 I1000", linuxcnc()), "alarm b2 arc-end-point");
}

TEST(NgcArcCentre, OfLinuxcncARadiusBelowATwentyThousandthOfAnInchIsZero) {
  EXPECT_EQ(outcome("G2 X0.00254 I0.00127", linuxcnc()), kDone);
  EXPECT_EQ(outcome("G2 X0.00252 I0.00126", linuxcnc()), "alarm b2 arc-radius");
  EXPECT_EQ(outcome("G2 X0.02 I0.02", linuxcnc()), "alarm b2 arc-radius");  // at the end
  EXPECT_EQ(outcome("G2 X0.001 I0.00126"), kDone);
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
