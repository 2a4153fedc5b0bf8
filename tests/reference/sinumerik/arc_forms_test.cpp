// SPDX-License-Identifier: GPL-3.0-or-later
//
// CR= and AR=, and the worked examples of the manual in all their forms.
#include <gtest/gtest.h>

#include "sie_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

// A 3-4-5 triangle: half the chord 3, radius 5, so 4 off the chord. Clockwise the short arc has its
// centre on the right, which is below.
TEST(SieArcForms, TheSignOfCrChoosesTheArc) {
  EXPECT_EQ(line("G2 X6 CR=5 F9", 0), "arc x6 y0 c3,-4 rot-1 f9");
  EXPECT_EQ(line("G2 X6 CR=+5 F9", 0), "arc x6 y0 c3,-4 rot-1 f9");
  EXPECT_EQ(line("G2 X6 CR=-5 F9", 0), "arc x6 y0 c3,4 rot-1 f9");
  EXPECT_EQ(line("G3 X6 CR=5 F9", 0), "arc x6 y0 c3,4 rot1 f9");
  EXPECT_EQ(line("G3 X6 CR=-5 F9", 0), "arc x6 y0 c3,-4 rot1 f9");
  EXPECT_EQ(clauses("G3 X6 CR=-5 F9"), Lines{"SIE-ARC-04"});
}

TEST(SieArcForms, AChordOfTwiceCrIsHalfATurn) {
  for (const char* radius : {"5", "-5"}) {
    const std::string block = std::string(" X10 F9 CR=") + radius;
    EXPECT_EQ(line("G2" + block, 0), "arc x10 y0 c5,0 rot-1 f9");
    EXPECT_EQ(line("G3" + block, 0), "arc x10 y0 c5,0 rot1 f9");
  }
  EXPECT_EQ(outcome("G2 X10.001 CR=5"), "arc-radius CR");
  EXPECT_EQ(outcome("G2 X10.001 CR=-5"), "arc-radius CR");
  // 25 - 4.9995^2 = 0.00499975, whose root is 0.070708910...
  EXPECT_EQ(centre(last_motion("G3 X9.999 CR=5 F9")), "4.999500000,0.070708910");
}

TEST(SieArcForms, HowFarAChordMayExceedTwiceCrIsAReading) {
  const Profile lenient = sie({{"sie.cr.tolerance", "const"}});
  EXPECT_EQ(line("G2 X10.01 CR=5 F9", 0, lenient), "arc x10.01 y0 c5.005,0 rot-1 f9");
  EXPECT_EQ(outcome("G2 X10.011 CR=5", lenient), "arc-radius CR");
  EXPECT_EQ(touched("F9 S1 M3\nG2 X10 CR=5"), Lines{});
  EXPECT_EQ(touched("F9 S1 M3\nG2 X10.01 CR=5"), Lines{"sie.cr.tolerance"});
  EXPECT_EQ(touched("F9 S1 M3\nG2 X10.011 CR=5"), Lines{});
}

TEST(SieArcForms, CrMakesNoFullCircleAndIsNotZero) {
  EXPECT_EQ(outcome("G2 X0 Y0 CR=5"), "arc-end-point CR");
  EXPECT_EQ(outcome("G2 Z5 CR=5"), "arc-end-point CR");
  EXPECT_EQ(outcome("G2 X5 CR=0"), "arc-radius CR");
}

// On a chord of 10 an angle of 90 stands 5 off it, one of 60 5 sqrt(3).
TEST(SieArcForms, AnAngleWithAnEndPoint) {
  EXPECT_EQ(line("G3 X10 AR=90 F9", 0), "arc x10 y0 c5,5 rot1 f9");
  EXPECT_EQ(line("G2 X10 AR=90 F9", 0), "arc x10 y0 c5,-5 rot-1 f9");
  EXPECT_EQ(line("G3 X10 AR=270 F9", 0), "arc x10 y0 c5,-5 rot1 f9");
  EXPECT_EQ(line("G3 X10 AR=180 F9", 0), "arc x10 y0 c5,0 rot1 f9");
  EXPECT_EQ(centre(last_motion("G3 X10 AR=60 F9")), "5.000000000,8.660254038");
  EXPECT_EQ(last_motion("G3 X10 AR=60 F9").centre[1], Number::root(0, 5, 3));
  EXPECT_EQ(outcome("G2 X0 AR=90"), "arc-end-point AR");
  EXPECT_EQ(clauses("G3 X10 AR=60 F9"), Lines{"SIE-ARC-05"});
}

// About (5,0) from the origin: clockwise a quarter is up at (5,5).
TEST(SieArcForms, AnAngleWithACentre) {
  EXPECT_EQ(line("G2 I5 AR=90 F9", 0), "arc x5 y5 c5,0 rot-1 f9");
  EXPECT_EQ(line("G3 I5 AR=90 F9", 0), "arc x5 y-5 c5,0 rot1 f9");
  EXPECT_EQ(line("G2 I5 AR=270 F9", 0), "arc x5 y-5 c5,0 rot-1 f9");
  EXPECT_EQ(line("G2 I5 AR=180 Z3 F9", 0), "arc x10 y0 z3 c5,0 rot-1 f9");
  EXPECT_EQ(last_motion("G2 I5 AR=45 F9").to[Axis::y], Number::root(0, num("2.5"), 2));
}

TEST(SieArcForms, AnAngleIsAboveZeroAndBelowATurn) {
  EXPECT_EQ(outcome("G2 I5 AR=0.001"), "end");
  EXPECT_EQ(outcome("G2 I5 AR=359.999"), "end");
  EXPECT_EQ(outcome("G2 X10 AR=359.999"), "end");
  const Profile refuses = sie({{"sie.ar.zero", "alarm"}});
  EXPECT_EQ(outcome("G2 I5 AR=0", refuses), "value-out-of-range AR");
  EXPECT_EQ(outcome("G2 X0 AR=0", refuses), "value-out-of-range AR");
  const Profile stays = sie({{"sie.ar.zero", "none"}});
  EXPECT_EQ(path("G2 I5 AR=0 F9\nG1 X3", stays), Lines{"feed x3 f9"});
  EXPECT_EQ(path("G2 X0 AR=0 F9\nG1 X3", stays), Lines{"feed x3 f9"});
  EXPECT_EQ(outcome("G2 X0.001 AR=0", stays), "value-out-of-range AR");
  EXPECT_EQ(outcome("G2 I5 Z1 AR=0", stays), "value-out-of-range AR");
  EXPECT_EQ(outcome("G2 X10 AR=360"), "value-out-of-range AR");
  EXPECT_EQ(outcome("G2 I5 AR=-1"), "value-out-of-range AR");
}

constexpr const char* kSampleA = "G0 X67.5 Y80.211\nG111 X50 Y50\nF500\nG3 ";
constexpr const char* kSampleB = "G0 X133 Y44.48\nF1000\nG2 ";

std::string sample(const char* before, const std::string& form) {
  return before + form;
}

// The first arc of the manual about (50,50), from the computed values of its forms.
TEST(SieArcForms, TheFirstArcOfTheManualInAllForms) {
  const std::string end = "X17.203 Y38.029 ";
  const Record cr = last_motion(sample(kSampleA, end + "CR=34.913"));
  EXPECT_EQ(centre(cr), "49.999127587,50.001116952");
  const Record ar = last_motion(sample(kSampleA, end + "AR=140.134"));
  EXPECT_EQ(centre(ar), "50.000077645,49.999984121");
  const Record ar_centre = last_motion(sample(kSampleA, "I-17.5 J-30.211 AR=140.134"));
  EXPECT_EQ(centre(ar_centre), "50.000000000,50.000000000");
  EXPECT_EQ(end_in_plane(ar_centre), "17.202872937,38.029077837");
  const Record polar = last_motion(sample(kSampleA, "RP=34.913 AP=200.052"));
  EXPECT_EQ(end_in_plane(polar), "17.203362302,38.029280526");
  EXPECT_EQ(centre(polar), "50.000714375,49.999586203");
}

TEST(SieArcForms, TheCentreOfTheFirstArcIsCorrectedUnderEachReading) {
  for (const char* form :
       {"X17.203 Y38.029 I-17.5 J-30.211", "X17.203 Y38.029 I=AC(50) J=AC(50)"}) {
    const std::string program = sample(kSampleA, form);
    EXPECT_EQ(centre(last_motion(program)), "50.000125102,49.999927534");
    EXPECT_EQ(centre(last_motion(program, sie({{"sie.arc.correct", "project"}}))),
              "50.000037766,50.000031672");
    EXPECT_EQ(centre(last_motion(program, sie({{"sie.arc.correct", "programmed"}}))),
              "50.000000000,50.000000000");
  }
}

TEST(SieArcForms, TheSecondArcOfTheManualInAllForms) {
  const std::string end = "X115 Y113.3 ";
  EXPECT_EQ(centre(last_motion(sample(kSampleB, end + "CR=-50"))), "90.001780412,69.997701939");
  EXPECT_EQ(centre(last_motion(sample(kSampleB, end + "CR=50"))), "157.998219588,87.782298061");
  EXPECT_EQ(centre(last_motion(sample(kSampleB, end + "AR=269.31"))), "90.001916449,69.997737519");
  EXPECT_EQ(end_in_plane(last_motion(sample(kSampleB, "I-43 J25.52 AR=269.31"))),
            "115.000322788,113.304206037");
  const std::string by_centre = sample(kSampleB, end + "I-43 J25.52");
  EXPECT_EQ(centre(last_motion(by_centre)), "89.998058560,69.996728481");
  EXPECT_EQ(centre(last_motion(by_centre, sie({{"sie.arc.correct", "project"}}))),
            "90.000676575,69.997413228");
}

// As printed with G91: the end is (248,157.78).
TEST(SieArcForms, TheSecondArcAsPrintedAlarms) {
  const std::string before = "G0 G91 X133 Y44.48\nF1000\nG2 ";
  EXPECT_EQ(outcome_of_program(before + "X115 Y113.3 I-43 J25.52"), "arc-end-point I");
  EXPECT_EQ(outcome_of_program(before + "X115 Y113.3 I=AC(90) J=AC(70)"), "arc-end-point I");
  EXPECT_EQ(outcome_of_program(before + "X115 Y113.3 CR=-50"), "arc-radius CR");
  EXPECT_EQ(outcome_of_program(before + "X115 Y113.3 AR=269.31"), "end");
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
