// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/coverage.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "hunting.hpp"

namespace gonogo::hunt::testing {
namespace {

constexpr std::size_t kMany = 1'000;

std::vector<std::uint64_t> features(const char* program) {
  return coverage_of(gsk(program), kMany).value().features;
}

// Whether the first has something that the second has not.
bool shows_more(const char* first, const char* second) {
  return !std::ranges::includes(features(second), features(first));
}

TEST(Coverage, TheSameProgramShowsTheSame) {
  EXPECT_EQ(features("G00 X100 Z5\nG94 X50 Z-10 F100\n"),
            features("G00 X100 Z5\nG94 X50 Z-10 F100\n"));
}

TEST(Coverage, OtherValuesOfTheSameSignsAndOrderShowTheSame) {
  EXPECT_FALSE(shows_more("G00 X100 Z5\nG94 X57 Z-12 F100\n", "G00 X100 Z5\nG94 X53 Z-11 F100\n"));
}

TEST(Coverage, ATravelTheOtherWayIsNew) {
  EXPECT_TRUE(shows_more("G00 X100 Z5\nG94 X150 Z-12 F100\n", "G00 X100 Z5\nG94 X53 Z-12 F100\n"));
}

TEST(Coverage, AnAlarmIsNew) {
  EXPECT_TRUE(
      shows_more("G00 X100 Z5\nG94 X50 Z-10 R20 F100\n", "G00 X100 Z5\nG94 X50 Z-10 F100\n"));
}

TEST(Coverage, TheCodeBeforeIsNew) {
  EXPECT_TRUE(
      shows_more("G00 X100 Z5\nG98\nG94 X50 Z-10 F100\n", "G00 X100 Z5\n\nG94 X50 Z-10 F100\n"));
}

// I = D is where the rule of the tool's size turns over; 5.001 is one increment beside it.
TEST(Coverage, EachSideOfAnEqualityIsNew) {
  constexpr const char* kBelow = "G18 G0 Y50\nG110 X0 Z0 Y20 I5.001 L1 Q9 D5.002 F1\n";
  constexpr const char* kOn = "G18 G0 Y50\nG110 X0 Z0 Y20 I5.001 L1 Q9 D5.001 F1\n";
  EXPECT_TRUE(shows_more(kOn, kBelow));
  EXPECT_TRUE(shows_more(kBelow, kOn));
}

TEST(Coverage, AnotherMachineIsNew) {
  generate::GeneratedProgram radius = gsk("G00 X100 Z5\n");
  radius.profile.x_diameter = false;
  EXPECT_NE(coverage_of(radius, kMany).value().features, features("G00 X100 Z5\n"));
}

TEST(Coverage, AProgramThatGoesOnForEverIsGivenUp) {
  const generate::GeneratedProgram pecks{defaults("hnc21t"),
                                         "G00 X0 Z0\nG74 Z-1000 R0.0005 Q0.001 F100\n"};
  EXPECT_FALSE(coverage_of(pecks, kMany));
}

// Four records, and a pocket of three levels beside: Q 2 from the plane at 0 to -6.
TEST(Coverage, ALevelOfAPocketCostsMoreThanARecord) {
  const std::size_t moves = coverage_of(gsk("G00 X1\nG00 X2\nG00 X3\n"), kMany)->cost;
  const std::size_t pocket =
      coverage_of(gsk("G00 X0 Y0 Z5\nG17 G110 X0 Y0 Z-6 R0 I20 L0.5 Q2 D5 F100\n"), kMany)->cost;
  EXPECT_LE(moves, 4U);
  EXPECT_GT(pocket, 3 * 10U);
}

}  // namespace
}  // namespace gonogo::hunt::testing
