// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program is moved by 25.4, -50.8, 76.2 mm: one, minus two, three inches.
#include <gtest/gtest.h>

#include "related.hpp"

namespace gonogo::relations::testing {
namespace {

std::string moved(std::string_view dialect, std::string text) {
  const std::optional<Related> related = translated(program_of(dialect, std::move(text)));
  return related ? related->program.text : "none";
}

TEST(Translation, MovesTheAbsoluteWordsOfRs274) {
  EXPECT_EQ(moved("rs274", "G0 X1 Y2 Z-3.50\n"), "G0 X26.4 Y-48.8 Z72.70\n");
  EXPECT_EQ(moved("rs274", "G91 G0 X1\nG90 X1\n"), "G91 G0 X1\nG90 X26.4\n");
  EXPECT_EQ(moved("rs274", "G20 G0 X1 Y.5\n"), "G20 G0 X2 Y-1.5\n");
  EXPECT_EQ(moved("rs274", "G2 X1 I5 F9 A90\n"), "G2 X26.4 I5 F9 A90\n");
  EXPECT_EQ(moved("rs274", "G90.1 G2 X1 I5 J0\n"), "G90.1 G2 X26.4 I30.4 J-50.8\n");
}

// G91.0001 counts as G91 under a reading (ngc.whole), and X is no place then. What is not written
// as a code is not looked into.
TEST(Translation, LeavesCodesAloneThatAreOnlyNearlyOnes) {
  EXPECT_EQ(moved("rs274", "G91.000100 G03 X1 R19 F1\n"), "none");
  EXPECT_EQ(moved("rs274", "G91.100 G0 X1\n"), "none");
}

TEST(Translation, CountsXAsADiameterWhereItIsOne) {
  EXPECT_EQ(moved("gsk988ta", "G00 X10 Z5 U3\n"), "G00 X60.8 Z81.2 U3\n");
  EXPECT_EQ(moved("gsk988ta", "G94 X0 Z0 R-10 F9\n"), "G94 X50.8 Z76.2 R-10 F9\n");
}

TEST(Translation, LeavesTimesAndTheDepthAxisOfMillingCycles) {
  EXPECT_EQ(moved("gsk988ta", "G04 X2\n"), "G04 X2\n");
  // G18: the depth axis is Y.
  EXPECT_EQ(moved("gsk988ta", "G110 X0 Z0 Y-9 R1 I16 L3 Q5 D4 F8\n"),
            "G110 X50.8 Z76.2 Y-9 R1 I16 L3 Q5 D4 F8\n");
  EXPECT_EQ(moved("gsk988ta", "G17 G110 X0 Y0 Z-9 R1 I16 L3 Q5 D4 F8\n"),
            "G17 G110 X50.8 Y-50.8 Z-9 R1 I16 L3 Q5 D4 F8\n");
  EXPECT_EQ(moved("gsk988ta", "G18 G00 X1\nG17 G110 X0 Y0 Z-9 R1 I16 L3 Q5 D4 F8\n"), "none");
}

TEST(Translation, MovesWordsOfSinumerikByWhatTheyMean) {
  EXPECT_EQ(moved("sinumerik840d", "G1 X1 Y=2 F9\n"), "G1 X26.4 Y=2+(-50.8) F9\n");
  EXPECT_EQ(moved("sinumerik840d", "G91 X1 Y=AC(2) Z=IC(3)\n"), "G91 X1 Y=AC(2+(-50.8)) Z=IC(3)\n");
  EXPECT_EQ(moved("sinumerik840d", "G2 X1 I5 J=AC(R1+2)\n"), "G2 X26.4 I5 J=AC(R1+2+(-50.8))\n");
  EXPECT_EQ(moved("sinumerik840d", "CIP X1 I1=2 J1=IC(3)\n"), "CIP X26.4 I1=2+(25.4) J1=IC(3)\n");
  EXPECT_EQ(moved("sinumerik840d", "G70 X1 R5=3\n"), "G70 X2 R5=3\n");
}

// Poles are about the workpiece zero unless a code puts them elsewhere.
TEST(Translation, LeavesPolarProgramsAlone) {
  EXPECT_EQ(moved("sinumerik840d", "G1 AP=30 RP=5 F9\n"), "none");
  EXPECT_EQ(moved("sinumerik840d", "G111 X1 Y1\n"), "none");
}

TEST(Translation, MovesByOffsetsOrFramesWhereTheDialectHasThem) {
  EXPECT_EQ(moved("hnc21t", "%0001\nG00 X10\n"), "%0001\nG54\nG00 X10\n");
  EXPECT_EQ(moved("sinumerik802s", "G1 AP=30 RP=5 F9\n"),
            "G158 X25.4 Y-50.8 Z76.2\nG1 AP=30 RP=5 F9\n");
  EXPECT_EQ(moved("sinumerik802s", "G1 X5 F9\nG158 X5\n"), "none");
  // Whether an increment goes the translation is open: the words are moved (SIE-FRM-06).
  EXPECT_EQ(moved("sinumerik802s", "G0 X1\nG91 Y5\n"), "G0 X26.4\nG91 Y5\n");
  EXPECT_EQ(moved("sinumerik802s", "G0 X1 Y=IC(5)\n"), "G0 X26.4 Y=IC(5)\n");
  const auto related = translated(program_of("hnc21t", "G00 X10\n"));
  EXPECT_EQ(related->program.profile.offsets.at("G59")[reference::Axis::x],
            Number::millionths(25'400'000));
  EXPECT_EQ(related->shift[1], Number(0));  // a lathe has no Y
}

// What stands behind the blank belongs to the word.
TEST(Translation, LeavesProgramsWithBlanksInTheirWordsAlone) {
  EXPECT_EQ(moved("sinumerik840d", "G1 X= AC(1) F9\n"), "none");
  EXPECT_EQ(moved("sinumerik840d", "G1 X=1 + 2 F9\n"), "none");
  EXPECT_EQ(moved("rs274", "G 91 X1\n"), "none");
}

// The machine stands where the program begins.
TEST(Translation, MovesTheMachine) {
  const auto related = translated(program_of("rs274", "G0 Y1\n"));
  EXPECT_EQ(related->program.profile.initial.at[reference::Axis::x],
            Number::millionths(25'400'000));
}

// Modes of a block that is skipped do not hold.
TEST(Translation, LeavesOutWhatTheMachineLeavesOut) {
  generate::GeneratedProgram program = program_of("rs274", "/ G91 X1\nG0 X1\n");
  ASSERT_TRUE(translated(program));
  EXPECT_EQ(translated(program)->program.text, "/ G91 X1\nG0 X1\n");
  program.profile.block_skip = true;
  EXPECT_EQ(translated(program)->program.text, "/ G91 X1\nG0 X26.4\n");
}

TEST(Translation, LeavesWordsWithoutRoomAlone) {
  EXPECT_EQ(moved("gsk988ta", "G00 X9001\n"), "none");
  EXPECT_EQ(moved("rs274", "G0 X1234567890123456789\n"), "none");
}

}  // namespace
}  // namespace gonogo::relations::testing
