// SPDX-License-Identifier: GPL-3.0-or-later
//
// G90 and G92 derived by hand, against the vectors. A is where the tool stands, C the end point;
// B lies R beyond C along q, level with A on p: rapid to B, cut to C, out to D along q, rapid to A.
#include <gtest/gtest.h>

#include "derived.hpp"

namespace gonogo::testing {
namespace {

// One cylinder in G18 from X65 Z3 (a radius), to `x` and `z`.
Lines cylinder(const std::string& block, const std::string& x, const std::string& z) {
  return {block + " rapid x" + x, block + " feed x" + x + " z" + z + " f200",
          block + " feed x65 f200", block + " rapid z3"};
}

// One taper from X60 Z-30 with no travel along X: B lies at `b`, C and D at X60.
Lines taper(const std::string& block, const std::string& b, const std::string& z) {
  return {block + " rapid x" + b, block + " feed x60 z" + z + " f150", block + " feed x60 f150",
          block + " rapid z-30"};
}

TEST(DerivedG90, CylindersAndACone) {
  // X are diameters, R a radius: X120 with begins at radius 52.5. Z-30 is retained.
  const Lines want =
      Lines{"1 m 3", "2 rapid x65 z3"} + cylinder("3", "60", "-110") + cylinder("4", "55", "-30") +
      cylinder("5", "50", "-30") + cylinder("6", "45", "-30") + cylinder("7", "40", "-30") +
      cylinder("8", "35", "-30") + cylinder("9", "30", "-30") + Lines{"10 rapid x60 z-30"} +
      taper("11", "52.5", "-44") + taper("12", "45", "-56") + taper("13", "37.5", "-68") +
      taper("14", "30", "-80") + Lines{"15 m 30", "end x60 y0 z-30 a0 c0"};
  EXPECT_EQ(records_of("gsk.g90.000001"), want);
}

// G92 from X32.5 Z5 to `x` and Z-28 with the lead 3.
Lines thread(const std::string& block, const std::string& x) {
  return {block + " rapid x" + x, block + " thread x" + x + " z-28 lead3", block + " rapid x32.5",
          block + " rapid z5"};
}

TEST(DerivedG92, FourPassesOfAThread) {
  const Lines want = Lines{"1 rapid x32.5 z5"} + thread("2", "29.35") + thread("3", "28.85") +
                     thread("4", "28.5") + thread("5", "28.45") + Lines{"end x32.5 y0 z5 a0 c0"};
  EXPECT_EQ(records_of("gsk.g92.000001"), want);
}

TEST(DerivedG92, InInchTheLeadIsALength) {
  // X4 Z2 is 50.8 50.8; to X3.5 = 44.45 and X3.45 = 43.815, Z1 = 25.4; F0.05 = 1.27.
  const Lines want = {"1 rapid x50.8 z50.8",
                      "2 rapid x44.45",
                      "2 thread x44.45 z25.4 lead1.27",
                      "2 rapid x50.8",
                      "2 rapid z50.8",
                      "3 rapid x43.815",
                      "3 thread x43.815 z25.4 lead1.27",
                      "3 rapid x50.8",
                      "3 rapid z50.8",
                      "end x50.8 y0 z50.8 a0 c0"};
  EXPECT_EQ(records_of("gsk.g92.000070"), want);
}

}  // namespace
}  // namespace gonogo::testing
