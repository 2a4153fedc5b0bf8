// SPDX-License-Identifier: GPL-3.0-or-later
//
// G81. Points of the sources are diameters; records are radii.
#include <gtest/gtest.h>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

Lines facing_rectangle(const std::string& b, const std::string& c_x, const std::string& c_z,
                       const std::string& a_x, const std::string& a_z, const std::string& f) {
  return {"rapid z" + b, "feed x" + c_x + " z" + c_z + " f" + f, "feed z" + a_z + " f" + f,
          "rapid x" + a_x};
}

// The textbook's example 10, A X56 Z45, K -6: B at Z 31, 28, 25, 24.
TEST(G81, CutsTheTaperFaceOfTheTextbook) {
  Lines want;
  for (const Lines& block : {facing_rectangle("31", "10", "37", "28", "45", "100"),
                             facing_rectangle("28", "10", "34", "28", "45", "100"),
                             facing_rectangle("25", "10", "31", "28", "45", "100"),
                             facing_rectangle("24", "10", "30", "28", "45", "40")}) {
    want.insert(want.end(), block.begin(), block.end());
  }
  want.push_back("rapid x40 z100");
  EXPECT_EQ(cycle("N2 G90 G00 X56 Z45 M03",
                  "N3 G81 X20 Z37 K-6 F100\nX20 Z34 K-6\nX20 Z31 K-6\nX20 Z30 K-6 F40\n"
                  "N7 G00 X80 Z100\nM30"),
            want);
}

// Another textbook, A X60 Z45: B at Z 28, 26, 24, 22.
TEST(G81, CutsATaperFaceWithTheCodeInEveryBlock) {
  const Lines got = cycle("G54 G90 G00 X60 Z45 M03",
                          "G81 X25 Z31.5 K-3.5 F100\nG81 X25 Z29.5 K-3.5\nG81 X25 Z27.5 K-3.5\n"
                          "G81 X25 Z25.5 K-3.5\nM05\nM30");
  EXPECT_EQ(Lines(got.begin(), got.begin() + 4),
            facing_rectangle("28", "12.5", "31.5", "30", "45", "100"));
  EXPECT_EQ(got.at(4), "rapid z26");
  EXPECT_EQ(got.at(8), "rapid z24");
  EXPECT_EQ(got.at(12), "rapid z22");
}

// Each pass is measured from the same A: 3 mm apart.
TEST(G81, RepeatsFromAInIncrements) {
  Lines want;
  for (const Lines& block : {facing_rectangle("-8", "-7.5", "-8", "0", "0", "37"),
                             facing_rectangle("-11", "-7.5", "-11", "0", "0", "37"),
                             facing_rectangle("-14", "-7.5", "-14", "0", "0", "37")}) {
    want.insert(want.end(), block.begin(), block.end());
  }
  EXPECT_EQ(path("N1 G91 G81 X-15 Z-8 F37 M03\nN2 G81 X-15 Z-11\nN3 G81 X-15 Z-14\nM05\nM30"),
            want);
}

TEST(G81, RetainsK) {
  EXPECT_EQ(cycle("G00 X56 Z45", "G81 X20 Z37 K-6 F100\nX20 Z34").at(4), "rapid z28");
}

TEST(G81, TakesKInInches) {
  EXPECT_EQ(path("G20 G81 X1 Z-1 K-1 F1").at(0), "rapid z-50.8");
}

TEST(G81, NamesItsClause) {
  EXPECT_EQ(clauses("G81 X60 Z-10 F100"),
            (Lines{"HNC-G81-01", "HNC-G81-01", "HNC-G81-01", "HNC-G81-01"}));
}

TEST(G81, NeedsBothAxesAndAFeed) {
  EXPECT_EQ(ending_of("G81 X60 Z-10"), "alarm b1 feed-missing");
  EXPECT_EQ(ending_of("G81 X60 F100"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G81 Z6"), "alarm b1 missing-word feed-missing");
}

// I and R are words of other cycles.
TEST(G81, TakesInWordsThatItDoesNotUse) {
  EXPECT_EQ(path("G81 X20 Z-10 I5 R-1 Q-1 C1.5 E3 A30 P-2 J-1 F100"),
            facing_rectangle("-10", "10", "-10", "0", "0", "100"));
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
