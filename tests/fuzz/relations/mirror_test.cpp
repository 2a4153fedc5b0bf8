// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mirrored program, word by word: places and ways along the axis change their sign, and G2 is G3
// in the planes that hold it.
#include <gtest/gtest.h>

#include "related.hpp"
#include "fuzz/relations/related_lines.hpp"

namespace gonogo::relations::testing {
namespace {

constexpr std::size_t kX = 0;
constexpr std::size_t kY = 1;
constexpr std::size_t kZ = 2;

std::string mirrored_text(std::string_view dialect, std::string text, std::size_t axis) {
  const std::optional<Related> related = mirrored(program_of(dialect, std::move(text)), axis);
  return related ? related->program.text : "none";
}

TEST(Mirror, ChangesTheSignsAlongOneAxis) {
  EXPECT_EQ(mirrored_text("rs274", "G0 X1 Y-2 Z+3\n", kX), "G0 X-1 Y-2 Z+3\n");
  EXPECT_EQ(mirrored_text("rs274", "G0 X1 Y-2 Z+3\n", kY), "G0 X1 Y2 Z+3\n");
  EXPECT_EQ(mirrored_text("rs274", "G91 G0 Z+3\n", kZ), "G91 G0 Z-3\n");
}

// G17 holds X and Y, G18 Z and X, G19 Y and Z.
TEST(Mirror, TurnsArcsRoundInThePlanesOfTheAxis) {
  EXPECT_EQ(mirrored_text("rs274", "G17 G2 X1 I5 J3 F9\n", kX), "G17 G3 X-1 I-5 J3 F9\n");
  EXPECT_EQ(mirrored_text("rs274", "G17 G2 X1 I5 J3 F9\n", kZ), "G17 G2 X1 I5 J3 F9\n");
  EXPECT_EQ(mirrored_text("rs274", "G19 G03 Y1 R5 F9\n", kZ), "G19 G2 Y1 R5 F9\n");
}

// A modal G2 would turn the other way in one of the two planes only.
TEST(Mirror, LeavesProgramsAloneWhoseArcsWouldNotAllTurn) {
  EXPECT_EQ(mirrored_text("rs274", "G17 G2 X1 I5 F9\nG19 Y1 J5\n", kX), "none");
  EXPECT_NE(mirrored_text("rs274", "G17 G2 X1 I5 F9\nG18 Z1 K5\n", kX), "none");
}

// G90 (gsk988ta): R is a difference of radii, along X; that of an arc has no direction.
TEST(Mirror, KnowsWhatRMeans) {
  EXPECT_EQ(mirrored_text("gsk988ta", "G90 X20 Z-5 R-2 F9\n", kX), "G90 X-20 Z-5 R2 F9\n");
  EXPECT_EQ(mirrored_text("gsk988ta", "G90 X20 Z-5 R-2 F9\n", kZ), "G90 X20 Z5 R-2 F9\n");
  EXPECT_EQ(mirrored_text("gsk988ta", "G94 X20 Z-5 R-2 F9\n", kZ), "G94 X20 Z5 R2 F9\n");
  EXPECT_EQ(mirrored_text("gsk988ta", "G02 X20 R5 F9\n", kX), "G3 X-20 R5 F9\n");
  EXPECT_EQ(mirrored_text("gsk988ta", "G17 G90 X20 Y-5 R-2 F9\n", kY), "G17 G90 X20 Y5 R2 F9\n");
  EXPECT_EQ(mirrored_text("gsk988ta", "G90 X20 Z-5 R-2 F9\nG17 X10\n", kX), "none");
  EXPECT_EQ(mirrored_text("hnc21t", "G82 X30 Z-9 I-2 R-3 E1 P90 F2\n", kX),
            "G82 X-30 Z-9 I2 R-3 E-1 P90 F2\n");
  EXPECT_EQ(mirrored_text("hnc21t", "G74 Z-9 R1 Q3 F2\n", kZ), "G74 Z9 R1 Q3 F2\n");
  EXPECT_EQ(mirrored_text("gsk988ta", "G110 X0 Z0 Y-9 R1 I16 L3 Q5 D4 F8\n", kX), "none");
}

TEST(Mirror, PutsExpressionsOfSinumerikIntoBrackets) {
  EXPECT_EQ(mirrored_text("sinumerik840d", "G1 X=R1+2 Y=IC(3) F9\n", kX),
            "G1 X=-(R1+2) Y=IC(3) F9\n");
  EXPECT_EQ(mirrored_text("sinumerik840d", "G1 X=R1+2 Y=IC(3) F9\n", kY),
            "G1 X=R1+2 Y=IC(-(3)) F9\n");
  EXPECT_EQ(mirrored_text("sinumerik840d", "CIP X1 I1=2 J1=IC(3)\n", kX),
            "CIP X-1 I1=-(2) J1=IC(3)\n");
  EXPECT_EQ(mirrored_text("sinumerik840d", "G1 AP=30 RP=5 F9\n", kX), "none");
  // The arc lies in G19 in any plane in force.
  EXPECT_EQ(mirrored_text("sinumerik840d", "G17 G2 Y5 Z5 CR=9 F9\n", kX), "none");
}

TEST(Mirror, MirrorsTheMachine) {
  generate::GeneratedProgram program = program_of("rs274", "X1\n");
  program.profile.initial.at[reference::Axis::x] = 5;
  program.profile.initial.motion = 2;
  program.profile.initial.plane = reference::Plane::g17;
  const Related related = mirrored(program, kX).value();
  EXPECT_EQ(related.program.profile.initial.at[reference::Axis::x], Number(-5));
  EXPECT_EQ(related.program.profile.initial.motion, 3);
}

// A quarter about (0, 10) from (0, 0) to (10, 10), counterclockwise: mirrored along X it goes
// clockwise to (-10, 10).
TEST(Mirror, OfAPathIsThePathOfTheMirror) {
  generate::GeneratedProgram program = program_of("rs274", "G17 G3 X10 Y10 J10 F9\n");
  const Related related = mirrored(program, kX).value();
  const oracle::ReferenceRun first = oracle::run_reference(program.profile, program.text, 10);
  const oracle::ReferenceRun other =
      oracle::run_reference(related.program.profile, related.program.text, 10);
  EXPECT_EQ(first.records.at(0).rot, 1);
  EXPECT_EQ(other.records.at(0).rot, -1);
  EXPECT_EQ(other.records.at(0).to[reference::Axis::x], Number(-10));
  EXPECT_FALSE(first_difference(trace_of(first), trace_of(other), related, 0));
  // Not mirrored, it is another one.
  Related plain = related;
  plain.mirrored[kX] = false;
  EXPECT_TRUE(first_difference(trace_of(first), trace_of(other), plain, 0));
}

}  // namespace
}  // namespace gonogo::relations::testing
