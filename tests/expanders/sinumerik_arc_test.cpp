// SPDX-License-Identifier: GPL-3.0-or-later
// G2 and G3 of the expander of sinumerik840d: one arc in its forms, planes, helix.
#include <gtest/gtest.h>

#include "sinumerik_outcomes.hpp"

namespace gonogo::expanders::testing {
namespace {

std::string sinumerik_arc(const std::string& block, const std::string& before = "G0 X0",
                          const char* profile = "{}") {
  return last_motion_or_alarm("F9\n" + before + "\n" + block + "\n", profile);
}

constexpr const char* kStartA = "G0 X67.5 Y80.211";
constexpr const char* kStartB = "G0 X133 Y44.48";
constexpr const char* kProject = R"({"readings":{"sie.arc.correct":"project"}})";
constexpr const char* kProgrammed = R"({"readings":{"sie.arc.correct":"programmed"}})";

// The arc from (67.5, 80.211) to (17.203, 38.029) about (50, 50): the radii at its ends differ by
// 9.3e-5, so that each form has a centre of its own. All numbers from 40 digits by another program.
TEST(SinumerikArc, CentreIsCorrectedToTheRadiusOfTheStart) {
  const char* want = "arc17 c=50.000125102,49.999927534 rot=1 x=17.203 y=38.029 f=9";
  EXPECT_EQ(sinumerik_arc("G3 X17.203 Y38.029 I-17.5 J-30.211", kStartA), want);
  EXPECT_EQ(sinumerik_arc("G3 X17.203 Y38.029 I=AC(50) J=AC(50)", kStartA), want);
  EXPECT_EQ(sinumerik_arc("G2 X115 Y113.3 I-43 J25.52", kStartB),
            "arc17 c=89.99805856,69.996728481 rot=-1 x=115 y=113.3 f=9");
}

TEST(SinumerikArc, ReadingsOfTheCorrection) {
  const char* block = "G3 X17.203 Y38.029 I-17.5 J-30.211";
  EXPECT_EQ(sinumerik_arc(block, kStartA, kProject),
            "arc17 c=50.000037766,50.000031672 rot=1 x=17.203 y=38.029 f=9");
  EXPECT_EQ(sinumerik_arc(block, kStartA, kProgrammed),
            "arc17 c=50,50 rot=1 x=17.203 y=38.029 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X115 Y113.3 I-43 J25.52", kStartB, kProject),
            "arc17 c=90.000676575,69.997413228 rot=-1 x=115 y=113.3 f=9");
}

TEST(SinumerikArc, Radius) {
  EXPECT_EQ(sinumerik_arc("G3 X17.203 Y38.029 CR=34.913", kStartA),
            "arc17 c=49.999127587,50.001116952 rot=1 x=17.203 y=38.029 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X115 Y113.3 CR=-50", kStartB),
            "arc17 c=90.001780412,69.997701939 rot=-1 x=115 y=113.3 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X115 Y113.3 CR=50", kStartB),
            "arc17 c=157.998219588,87.782298061 rot=-1 x=115 y=113.3 f=9");
}

// From (0, 0): about (5, -12) a radius of 13.
TEST(SinumerikArc, RadiusBesideACentre) {
  const char* radius = R"({"readings":{"sie.cr.centre":"radius"}})";
  const char* centre = R"({"readings":{"sie.cr.centre":"centre"}})";
  const std::string both = "G2 X10 Y0 I5 J-12 CR=6";
  EXPECT_EQ(sinumerik_arc(both), "conflicting-words");
  EXPECT_EQ(sinumerik_arc(both, "G0 X0", radius), sinumerik_arc("G2 X10 Y0 CR=6"));
  EXPECT_EQ(sinumerik_arc(both, "G0 X0", centre), sinumerik_arc("G2 X10 Y0 I5 J-12"));
  EXPECT_EQ(sinumerik_arc("G2 I5 CR=5", "G0 X0", radius), "arc-end-point");
  EXPECT_EQ(sinumerik_arc("G2 I5 CR=5", "G0 X0", centre), sinumerik_arc("G2 I5"));
  for (const char* profile : {radius, centre}) {
    EXPECT_EQ(sinumerik_arc("G2 X10 K5 CR=6", "G0 X0", profile), "axis-not-in-plane");
    EXPECT_EQ(sinumerik_arc("G2 X10 I5 AR=90 CR=6", "G0 X0", profile), "conflicting-words");
  }
}

TEST(SinumerikArc, OpeningAngleAndEndPoint) {
  EXPECT_EQ(sinumerik_arc("G3 X17.203 Y38.029 AR=140.134", kStartA),
            "arc17 c=50.000077645,49.999984121 rot=1 x=17.203 y=38.029 f=9");
  EXPECT_EQ(sinumerik_arc("G2 AR=269.31 X115 Y113.3", kStartB),
            "arc17 c=90.001916449,69.997737519 rot=-1 x=115 y=113.3 f=9");
}

TEST(SinumerikArc, OpeningAngleAndCentre) {
  EXPECT_EQ(sinumerik_arc("G3 I-17.5 J-30.211 AR=140.134", kStartA),
            "arc17 c=50,50 rot=1 x=17.202872937 y=38.029077837 f=9");
  EXPECT_EQ(sinumerik_arc("G2 AR=269.31 I-43 J25.52", kStartB),
            "arc17 c=90,70 rot=-1 x=115.000322788 y=113.304206037 f=9");
}

TEST(SinumerikArc, PoleIsTheCentre) {
  EXPECT_EQ(sinumerik_arc("G3 RP=34.913 AP=200.052", std::string(kStartA) + "\nG111 X50 Y50"),
            "arc17 c=50.000714375,49.999586203 rot=1 x=17.203362302 y=38.029280526 f=9");
  EXPECT_EQ(sinumerik_arc("G3 RP=34.913 AP=200.052", std::string(kStartA) + "\nG111 X50 Y50",
                          kProgrammed),
            "arc17 c=50,50 rot=1 x=17.203362302 y=38.029280526 f=9");
}

// The sample as printed, with G91 for G90: it ends at (248, 157.78).
TEST(SinumerikArc, TheSampleUnderG91) {
  EXPECT_EQ(sinumerik_arc("G91 G2 X115 Y113.3 I-43 J25.52", kStartB), "arc-end-point");
  EXPECT_EQ(sinumerik_arc("G91 G2 X115 Y113.3 CR=-50", kStartB), "arc-radius");
  EXPECT_EQ(sinumerik_arc("G91 G2 AR=269.31 I-43 J25.52", kStartB),
            "arc17 c=90,70 rot=-1 x=115.000322788 y=113.304206037 f=9");
}

// 10^2 + 7^2 at both ends.
TEST(SinumerikArc, CentreCountsFromTheStart) {
  EXPECT_EQ(sinumerik_arc("G2 X50 Y40 I10 J-7", "G0 X30 Y40"),
            "arc17 c=40,33 rot=-1 x=50 y=40 f=9");
  EXPECT_EQ(sinumerik_arc("G91 G2 X20 I10 J-7", "G0 X30 Y40"),
            "arc17 c=40,33 rot=-1 x=50 y=40 f=9");
  EXPECT_EQ(sinumerik_arc("G91 G2 X20 I=AC(40) J=IC(-7)", "G0 X30 Y40"),
            "arc17 c=40,33 rot=-1 x=50 y=40 f=9");
}

TEST(SinumerikArc, FullCircle) {
  EXPECT_EQ(sinumerik_arc("G2 I3"), "arc17 c=3,0 rot=-1 x=0 y=0 f=9");
  EXPECT_EQ(sinumerik_arc("G3 X0 J-3"), "arc17 c=0,-3 rot=1 x=0 y=0 f=9");
  EXPECT_EQ(sinumerik_arc("G3 Z5 J-3 TURN=1"), "arc17 c=0,-3 rot=2 x=0 y=0 z=5 f=9");
  EXPECT_EQ(sinumerik_arc("G3 RP=2 AP=90", "G0 RP=2 AP=-270"), "arc17 c=0,0 rot=1 x=0 y=2 f=9");
  EXPECT_EQ(sinumerik_arc("G3 RP=2 AP=43", "G0 RP=2 AP=-317").substr(0, 17), "arc17 c=0,0 rot=1");
}

// Chord 6 with 5: the centre is 4 off its middle. G2, at most 180 degrees, has it on the right.
TEST(SinumerikArc, SignOfTheRadius) {
  EXPECT_EQ(sinumerik_arc("G2 X6 CR=+5"), "arc17 c=3,-4 rot=-1 x=6 y=0 f=9");
  EXPECT_EQ(sinumerik_arc("G3 X6 CR=5"), "arc17 c=3,4 rot=1 x=6 y=0 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X6 CR=-5"), "arc17 c=3,4 rot=-1 x=6 y=0 f=9");
  EXPECT_EQ(sinumerik_arc("G3 X6 CR=-5"), "arc17 c=3,-4 rot=1 x=6 y=0 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X6 CR=3"), "arc17 c=3,0 rot=-1 x=6 y=0 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X6 CR=-3"), "arc17 c=3,0 rot=-1 x=6 y=0 f=9");
}

// 90 degrees over a chord of 2: radius sqrt(2), centre 1 off the middle.
TEST(SinumerikArc, SideOfTheOpeningAngle) {
  EXPECT_EQ(sinumerik_arc("G3 X2 AR=90"), "arc17 c=1,1 rot=1 x=2 y=0 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X2 AR=90"), "arc17 c=1,-1 rot=-1 x=2 y=0 f=9");
  EXPECT_EQ(sinumerik_arc("G3 X2 AR=270"), "arc17 c=1,-1 rot=1 x=2 y=0 f=9");
  EXPECT_EQ(sinumerik_arc("G3 X2 AR=180"), "arc17 c=1,0 rot=1 x=2 y=0 f=9");
}

TEST(SinumerikArc, OtherPlanes) {
  EXPECT_EQ(sinumerik_arc("G18 G3 X1 Z3 I-2", "G0 X3 Z1"), "arc18 c=1,1 rot=1 x=1 z=3 f=9");
  EXPECT_EQ(sinumerik_arc("G19 G2 Y6 Z5 J3", "G0 Z5"), "arc19 c=3,5 rot=-1 y=6 z=5 f=9");
  EXPECT_EQ(sinumerik_arc("G18 G3 Z6 CR=5"), "arc18 c=3,4 rot=1 x=0 z=6 f=9");
  EXPECT_EQ(sinumerik_arc("G19 G3 Y2 AR=90"), "arc19 c=1,1 rot=1 y=2 z=0 f=9");
}

TEST(SinumerikArc, EndPointAxesChooseThePlane) {
  EXPECT_EQ(sinumerik_arc("G2 X4 Z0 I2"), "arc18 c=0,2 rot=-1 x=4 z=0 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X2 Z2 K2"), "arc18 c=2,0 rot=-1 x=2 z=2 f=9");
  EXPECT_EQ(sinumerik_arc("G3 Y0 Z6 CR=5"), "arc19 c=-4,3 rot=1 y=0 z=6 f=9");
  EXPECT_EQ(sinumerik_arc("G18 G2 X4 Y0 I2"), "arc17 c=2,0 rot=-1 x=4 y=0 f=9");
  // Not with a word for the other axis of the plane, TURN or AR.
  EXPECT_EQ(sinumerik_arc("G2 X4 Z1 I2 J0"), "arc17 c=2,0 rot=-1 x=4 y=0 z=1 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X4 Z1 I2 TURN=0"), "arc17 c=2,0 rot=-1 x=4 y=0 z=1 f=9");
  EXPECT_EQ(sinumerik_arc("G3 X2 Z1 AR=90"), "arc17 c=1,1 rot=1 x=2 y=0 z=1 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X4 Z1 I2 K0 TURN=1"), "axis-not-in-plane");
}

// From (27.5, 32.99) two turns and 210 degrees more; three turns and a half.
TEST(SinumerikArc, TurnsAndHelix) {
  EXPECT_EQ(
      sinumerik_arc("G3 X20 Y5 Z-20 I=AC(20) J=AC(20) TURN=2", "G0 X27.5 Y32.99 Z-5", kProgrammed),
      "arc17 c=20,20 rot=3 x=20 y=5 z=-20 f=9");
  EXPECT_EQ(sinumerik_arc("G3 X0 Y0 Z33 I0 J-25 TURN=3", "G0 X0 Y50 Z50"),
            "arc17 c=0,25 rot=4 x=0 y=0 z=33 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X6 CR=5 TURN=2"), "arc17 c=3,-4 rot=-3 x=6 y=0 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X4 A90 C-5 I2"), "arc17 c=2,0 rot=-1 x=4 y=0 a=90 c=-5 f=9");
}

// Y is 0.000113604 above the chord's end: the radii differ by 1.2e-9 mm, by hand 0.000113604^2 / 2
// / 5.403.
TEST(SinumerikArc, RadiiOfAReckonedPlaceAreComparedByWhatRoundingTook) {
  const char* strict = R"({"parameters":{"CIRCLE_ERROR_CONST":"0","CIRCLE_ERROR_FACTOR":"0"}})";
  const char* before = "G2 AR=0.001 J=AC(4.627) I6.509\nG1 X-5.403";
  EXPECT_EQ(sinumerik_arc("G3 AP=270 RP=5.403", before, strict), "arc-end-point");
  // X is 0.0001 sin(33.3) off: the chord is 7.5e-11 mm above the diameter.
  EXPECT_EQ(sinumerik_arc("G2 X0 Y-20 CR=10", "G3 J-0.0001 AR=33.3\nG0 Y0"), "arc-radius");
}

// SIE-ARC-07 before SIE-ARC-08: twenty decimals are more than the counts have.
TEST(SinumerikArc, ACentreBesideTheStartByLessThanACountIsNotTheStart) {
  EXPECT_EQ(sinumerik_arc("G2 X5 I0"), "arc-radius");
  EXPECT_EQ(sinumerik_arc("G2 X5 I0.00000000000000000001"), "arc-end-point");
  EXPECT_EQ(sinumerik_arc("G2 X5 I=AC(0.00000000000000000001)"), "arc-end-point");
}

TEST(SinumerikArc, Inches) {
  EXPECT_EQ(sinumerik_arc("G2 X2 I1", "G70"), "arc17 c=25.4,0 rot=-1 x=50.8 y=0 f=9");
  EXPECT_EQ(sinumerik_arc("G2 X2 CR=1", "G70"), "arc17 c=25.4,0 rot=-1 x=50.8 y=0 f=9");
}

// Half a turn about X0 Y0; in the plane of Z and X the chord is 20.6.
TEST(SinumerikArc, ToTwoAxesByCrAlone) {
  const std::string program = "G0 X10 Z5\nG3 X-10 Z0 CR=10 F9\n";
  EXPECT_EQ(motions_and_alarm(program, R"({"readings":{"sie.arc.plane":"helix"}})"),
            "rapid x=10 z=5\narc17 c=0,0 rot=1 x=-10 y=0 z=0 f=9\n");
  EXPECT_EQ(motions_and_alarm(program), "rapid x=10 z=5\narc-radius");
}

TEST(SinumerikArc, ToTwoAxesByOneCentreWord) {
  EXPECT_EQ(motions_and_alarm("G0 X10 Z5\nG2 X-10 Z0 I-10 F9\n",
                              R"({"readings":{"sie.arc.plane":"helix"}})"),
            "rapid x=10 z=5\narc17 c=0,0 rot=-1 x=-10 y=0 z=0 f=9\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
