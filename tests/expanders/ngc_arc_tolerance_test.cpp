// SPDX-License-Identifier: GPL-3.0-or-later
// How far an end may lie off the circle, by the readings of ngc.arc-tolerance.
#include <gtest/gtest.h>

#include "expanders/ngc/radii.hpp"
#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

constexpr const char* kNist = R"({"readings":{"ngc.arc-tolerance":"nist"}})";
constexpr const char* kLinuxcnc = R"({"readings":{"ngc.arc-tolerance":"linuxcnc"}})";

std::string arc_tolerance_alarm(const std::string& block, const char* profile = kNist) {
  return run_ngc("F9\n" + block + "\n", profile).alarm;
}

// Radius 10 at the start; the end is on the same diameter.
TEST(NgcTolerance, TwoThousandthsAreAllowed) {
  EXPECT_EQ(arc_tolerance_alarm("G2 X20.002 I10"), "");
  EXPECT_EQ(arc_tolerance_alarm("G2 X20.0021 I10"), "arc-end-point");
  EXPECT_EQ(arc_tolerance_alarm("G2 X19.998 I10"), "");
  EXPECT_EQ(arc_tolerance_alarm("G2 X19.9979 I10"), "arc-end-point");
}

// 100 and 99.9, 99.9 and 100 mm; 0.1 and 0.1005 in.
TEST(NgcTolerance, AThousandthByThePageAndByGrbl) {
  constexpr const char* kPage = R"({"readings":{"ngc.arc-tolerance":"page"}})";
  constexpr const char* kGrbl = R"({"readings":{"ngc.arc-tolerance":"grbl"}})";
  for (const char* profile : {kPage, kGrbl}) {
    EXPECT_EQ(arc_tolerance_alarm("G2 X2.005 I1", profile), "");
    EXPECT_EQ(arc_tolerance_alarm("G2 X2.0051 I1", profile), "arc-end-point");
    EXPECT_EQ(arc_tolerance_alarm("G2 X199.9 I100", profile), "");
    EXPECT_EQ(arc_tolerance_alarm("G2 X1999.4999 I1000", profile), "arc-end-point");
  }
  EXPECT_EQ(arc_tolerance_alarm("G2 X199.9 I99.9", kPage), "");
  EXPECT_EQ(arc_tolerance_alarm("G2 X199.9 I99.9", kGrbl), "arc-end-point");
  EXPECT_EQ(arc_tolerance_alarm("G20 G2 X0.2005 I0.1", kPage), "");
  EXPECT_EQ(arc_tolerance_alarm("G20 G2 X0.2005 I0.1", kGrbl), "arc-end-point");
}

// 0.0002 in = 0.00508 mm.
TEST(NgcTolerance, InInches) {
  EXPECT_EQ(arc_tolerance_alarm("G20 G2 X2.0002 I1"), "");
  EXPECT_EQ(arc_tolerance_alarm("G20 G2 X2.00021 I1"), "arc-end-point");
}

TEST(NgcTolerance, TheCentreStays) {
  EXPECT_EQ(run_ngc("G2 X20.002 I10 F9\n").motions(), "arc17 c=10,0 rot=-1 x=20.002 y=0 f=9\n");
}

TEST(NgcTolerance, ACircleOfNoSize) {
  EXPECT_EQ(arc_tolerance_alarm("G2 X0 I0"), "arc-radius");
  EXPECT_EQ(arc_tolerance_alarm("G2 I0.0001"), "");
}

// sqrt(2) mm (square 2) and sqrt(2) + 0.002 mm: the square of the latter is 2.005660854...,
// so that an end at (1, 1.002826) from the centre (square 2.005659986) is inside and one at
// (1, 1.002827) (square 2.005661992) is not.
TEST(NgcTolerance, RootsAreDecidedExactly) {
  EXPECT_EQ(arc_tolerance_alarm("G2 X2 Y2.002826 I1 J1"), "");
  EXPECT_EQ(arc_tolerance_alarm("G2 X2 Y2.002827 I1 J1"), "arc-end-point");
}

// 2 sqrt(2) = 2.828427 of a radius of 10,000, of which 1/1000 is 10.
TEST(NgcTolerance, LinuxcncHasALargestDifference) {
  EXPECT_EQ(arc_tolerance_alarm("G2 X20002.8284 I10000", kLinuxcnc), "");
  EXPECT_EQ(arc_tolerance_alarm("G2 X20002.8285 I10000", kLinuxcnc), "arc-end-point");
}

// 0.02 sqrt(2) = 0.0282842 of a radius of 10, of which 1/1000 is less.
TEST(NgcTolerance, LinuxcncForgivesSmallDifferences) {
  EXPECT_EQ(arc_tolerance_alarm("G2 X20.0282 I10", kLinuxcnc), "");
  EXPECT_EQ(arc_tolerance_alarm("G2 X20.0283 I10", kLinuxcnc), "arc-end-point");
}

// 1/1000 of the larger radius r with r - 100 = r / 1000: r = 100 / 0.999 = 100.1001001...
TEST(NgcTolerance, LinuxcncForgivesAThousandthOfTheLarger) {
  EXPECT_EQ(arc_tolerance_alarm("G2 X200.1001001 I100", kLinuxcnc), "");
  EXPECT_EQ(arc_tolerance_alarm("G2 X200.1001002 I100", kLinuxcnc), "arc-end-point");
  // The larger at the start: 100 - 0.1 = 99.9 at the end is just inside.
  EXPECT_EQ(arc_tolerance_alarm("G2 X199.9 I100", kLinuxcnc), "");
  EXPECT_EQ(arc_tolerance_alarm("G2 X199.8999 I100", kLinuxcnc), "arc-end-point");
}

// 0.002 sqrt(2) = 0.00282842 in; 0.2 sqrt(2) = 0.282842 in.
TEST(NgcTolerance, LinuxcncInInches) {
  EXPECT_EQ(arc_tolerance_alarm("G20 G2 X2.002828 I1", kLinuxcnc), "");
  EXPECT_EQ(arc_tolerance_alarm("G20 G2 X2.002829 I1", kLinuxcnc), "arc-end-point");
  EXPECT_EQ(arc_tolerance_alarm("G20 G2 X2000.28284 I1000", kLinuxcnc), "");
  EXPECT_EQ(arc_tolerance_alarm("G20 G2 X2000.28285 I1000", kLinuxcnc), "arc-end-point");
}

TEST(NgcTolerance, LinuxcncRefusesTinyCircles) {
  EXPECT_EQ(arc_tolerance_alarm("G2 I0.00127", kLinuxcnc), "");
  EXPECT_EQ(arc_tolerance_alarm("G2 I0.00126", kLinuxcnc), "arc-radius");
}

// Half the chord is 5.
TEST(NgcTolerance, OfAShortRadius) {
  EXPECT_EQ(arc_tolerance_alarm("G2 X10 R5"), "");
  EXPECT_EQ(arc_tolerance_alarm("G2 X10 R4.9999"), "arc-radius");
  EXPECT_EQ(arc_tolerance_alarm("G2 X10 R4.9987", kLinuxcnc), "arc-radius");
  EXPECT_EQ(arc_tolerance_alarm("G2 X10 R4.99872", kLinuxcnc), "arc-radius");
  EXPECT_EQ(run_ngc("G2 X10 R4.99873 F9\n", kLinuxcnc).motions(),
            "arc17 c=5,0 rot=-1 x=10 y=0 f=9\n");
  EXPECT_EQ(run_ngc("G3 X10 R-4.9988 F9\n", kLinuxcnc).motions(),
            "arc17 c=5,0 rot=1 x=10 y=0 f=9\n");
}

// Squares beyond 64 bits, one count beside equality: (n + t)^2 against n^2.
TEST(NgcRadii, DifferByMoreIsExact) {
  const Wide n = Wide{kLargest};
  const Wide t = 2'000'000;
  EXPECT_FALSE(ngc::differ_by_more((n + t) * (n + t), n * n, t * t));
  EXPECT_TRUE(ngc::differ_by_more((n + t) * (n + t) + 1, n * n, t * t));
  EXPECT_FALSE(ngc::differ_by_more(n * n, (n + t) * (n + t), t * t));
  EXPECT_TRUE(ngc::differ_by_more(n * n, (n + t) * (n + t) + 1, t * t));
  EXPECT_FALSE(ngc::differ_by_more(n * n, n * n, 0));
}

}  // namespace
}  // namespace gonogo::expanders::testing
