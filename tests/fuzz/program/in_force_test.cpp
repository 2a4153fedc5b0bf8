// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/in_force.hpp"

#include <gtest/gtest.h>

namespace gonogo::program {
namespace {

std::string in_force(const char* dialect, std::string_view program, std::uint64_t line) {
  const auto profile = std::get<reference::Profile>(reference::default_profile(dialect));
  return in_force_text(profile, program, line);
}

TEST(InForce, ARepeatedCycleHasItsCodeAndItsWordsFromEarlierLines) {
  EXPECT_EQ(in_force("rs274", "G0 Z10 F100\nG83 X1 R2 Z-5 Q1\nX2 Z-6\nX3\n", 4),
            "G83 of line 2 (NGC-MOD-01); Z-6 of line 3 (NGC-CYC-03); R2 Q1 of line 2 (NGC-CYC-03)");
}

TEST(InForce, AWordThatTheBlockWritesIsNotOneThatHolds) {
  EXPECT_EQ(in_force("rs274", "G81 X1 R2 Z-5\nG81 X2 R3\n", 2), "Z-5 of line 1 (NGC-CYC-03)");
}

TEST(InForce, AnotherCodeForgetsTheWords) {
  EXPECT_EQ(in_force("rs274", "G81 X1 R2 Z-5\nG82 X2 R3 Z-6 P1\nX3\n", 3),
            "G82 of line 2 (NGC-MOD-01); R3 Z-6 P1 of line 2 (NGC-CYC-03)");
}

TEST(InForce, TheThirdAxisOfThePlaneIsTheOneThatHolds) {
  EXPECT_EQ(in_force("rs274", "G18\nG81 X1 Z2 R2 Y-5\nX2\n", 3),
            "G81 of line 2 (NGC-MOD-01); R2 Y-5 of line 2 (NGC-CYC-03); G18 of line 1");
}

TEST(InForce, ModesThatAreNotThoseOfPowerOnHaveTheirClauses) {
  EXPECT_EQ(in_force("rs274", "G20 G91\nG90.1\nG2 X1 I1 F1\n", 3),
            "G90.1 of line 2 (NGC-DIS-01); G20 of line 1 (NGC-UNI-01); G91 of line 1 (NGC-DIS-01)");
  EXPECT_EQ(in_force("rs274", "G17 G90 G91.1\nG2 X1 I1 F1\n", 2), "");
  EXPECT_EQ(in_force("rs274", "G91\nG90\nG1 X1 F1\n", 3), "");
  EXPECT_EQ(in_force("rs274", "G91\nG90 G1 X1 F1\n", 2), "");
}

TEST(InForce, EachDialectHasItsClauses) {
  EXPECT_EQ(in_force("gsk988ta", "G0 X50 Z5\nG94 X20 Z-5 R-2 F100\nX10\n", 3),
            "G94 of line 2 (GSK-G94-06); Z-5 R-2 of line 2 (GSK-G94-06)");
  EXPECT_EQ(in_force("hnc21t", "G0 X50 Z5\nG80 X20 Z-5 I-2 F100\nX10 Z-6\n", 3),
            "G80 of line 2 (HNC-MOD-02); I-2 of line 2 (HNC-MOD-01)");
  EXPECT_EQ(in_force("sinumerik840d", "G70\nG1 X1 F100\nX2\n", 3),
            "G1 of line 2 (SIE-MOD-01); G70 of line 1 (SIE-MOD-04)");
}

TEST(InForce, WithoutSuchALineThereIsNothing) {
  EXPECT_EQ(in_force("rs274", "G91\nG1 X1 F1\n", 0), "");
  EXPECT_EQ(in_force("rs274", "G91\nG1 X1 F1\n", 9), "");
  EXPECT_EQ(in_force("rs274", "", 1), "");
}

}  // namespace
}  // namespace gonogo::program
