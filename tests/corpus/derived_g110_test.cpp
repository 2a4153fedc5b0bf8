// SPDX-License-Identifier: GPL-3.0-or-later
//
// G110 and G111 derived by hand from the manual, against the vectors. The path by semicircles:
// they end at alternating sides of the centre on p, k L/2 away and at most I - D, each about the
// middle of its chord; then a full circle of radius I - D.
#include <gtest/gtest.h>

#include "derived.hpp"

namespace gonogo::testing {
namespace {

TEST(DerivedG110, TheExampleOfTheManual) {
  // X70 and X50 are radii 35 and 25. R plane 50 - 5 = 45; 45 to 20 in layers of 5. I - D = 12 and
  // L/2 = 1.5: eight semicircles about Z50, centres at Z50.75 and Z49.25 in turn. P1: re-entry one
  // above the last depth.
  Lines want = {"1 rapid x35 y50 z70", "2 rapid x25 z50", "2 rapid y45"};
  const Lines cleared = {"2 arc G18 -1 cx25 cz50.75 x25 z51.5 f800",
                         "2 arc G18 -1 cx25 cz49.25 x25 z47 f800",
                         "2 arc G18 -1 cx25 cz50.75 x25 z54.5 f800",
                         "2 arc G18 -1 cx25 cz49.25 x25 z44 f800",
                         "2 arc G18 -1 cx25 cz50.75 x25 z57.5 f800",
                         "2 arc G18 -1 cx25 cz49.25 x25 z41 f800",
                         "2 arc G18 -1 cx25 cz50.75 x25 z60.5 f800",
                         "2 arc G18 -1 cx25 cz49.25 x25 z38 f800",
                         "2 arc G18 -1 cx25 cz50 x25 z38 f800",
                         "2 rapid y45",
                         "2 rapid x25 z50"};
  want = want + Lines{"2 feed y40 f800"} + cleared;
  want = want + Lines{"2 rapid y41", "2 feed y35 f800"} + cleared;
  want = want + Lines{"2 rapid y36", "2 feed y30 f800"} + cleared;
  want = want + Lines{"2 rapid y31", "2 feed y25 f800"} + cleared;
  want = want + Lines{"2 rapid y26", "2 feed y20 f800"} + cleared;
  want = want + Lines{"2 rapid y50", "end x25 y50 z50 a0 c0"};
  EXPECT_EQ(records_of("gsk.g110.000001"), want);
  // The incremental depth counts from the R plane: V-25 is the same bottom.
  EXPECT_EQ(records_of("gsk.g110.000003"), want);
}

TEST(DerivedG110, IMinusDNoMultipleOfHalfAStep) {
  // I - D = 8, L/2 = 1.5: 1.5, -3, 4.5, -6, 7.5 and then -8; the last centre is (7.5 - 8)/2 = -0.25
  // away. The centre is X20 = radius 10.
  const Lines want = {"1 rapid x20 y30 z10",
                      "2 rapid x10 y10",
                      "2 rapid z10",
                      "2 feed z8 f200",
                      "2 arc G17 -1 cx10.75 cy10 x11.5 y10 f200",
                      "2 arc G17 -1 cx9.25 cy10 x7 y10 f200",
                      "2 arc G17 -1 cx10.75 cy10 x14.5 y10 f200",
                      "2 arc G17 -1 cx9.25 cy10 x4 y10 f200",
                      "2 arc G17 -1 cx10.75 cy10 x17.5 y10 f200",
                      "2 arc G17 -1 cx9.75 cy10 x2 y10 f200",
                      "2 arc G17 -1 cx10 cy10 x2 y10 f200",
                      "2 rapid z10",
                      "2 rapid x10 y10",
                      "2 rapid z10",
                      "end x10 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g110.000098"), want);
}

// The pockets "X20 Y10 I6 L4 D4" in G17: I - D = 2 = L/2, one semicircle to radius 10 + 2 and the
// circle; then the R plane and the centre.
Lines small_layer(const std::string& r_plane) {
  return {"2 arc G17 -1 cx11 cy10 x12 y10 f200", "2 arc G17 -1 cx10 cy10 x12 y10 f200",
          "2 rapid z" + r_plane, "2 rapid x10 y10"};
}
const Lines kSmallStart = {"1 rapid x20 y30 z10", "2 rapid x10 y10"};

TEST(DerivedG110, ADepthOf21InLayersOf7IsThreeLayers) {
  const Lines want = kSmallStart + Lines{"2 rapid z10", "2 feed z9.3 f200"} + small_layer("10") +
                     Lines{"2 rapid z9.4", "2 feed z8.6 f200"} + small_layer("10") +
                     Lines{"2 rapid z8.7", "2 feed z7.9 f200"} + small_layer("10") +
                     Lines{"2 rapid z10", "end x10 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g110.000066"), want);
}

TEST(DerivedG110, ALastLayerOfOneIncrement) {
  // 6.001 in layers of 2: 8, 6, 4 and 3.999; P1: 9, 7, 5.
  const Lines want = kSmallStart + Lines{"2 rapid z10", "2 feed z8 f200"} + small_layer("10") +
                     Lines{"2 rapid z9", "2 feed z6 f200"} + small_layer("10") +
                     Lines{"2 rapid z7", "2 feed z4 f200"} + small_layer("10") +
                     Lines{"2 rapid z5", "2 feed z3.999 f200"} + small_layer("10") +
                     Lines{"2 rapid z10", "end x10 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g110.000071"), want);
}

// W-6 R-2 Q2: R plane 8, layers at 6, 4, 2; the two re-entries are what P says.
Lines clearance_pocket(const std::string& first, const std::string& second) {
  return kSmallStart + Lines{"2 rapid z8", "2 feed z6 f200"} + small_layer("8") +
         Lines{"2 rapid z" + first, "2 feed z4 f200"} + small_layer("8") +
         Lines{"2 rapid z" + second, "2 feed z2 f200"} + small_layer("8") +
         Lines{"2 rapid z10", "end x10 y10 z10 a0 c0"};
}

TEST(DerivedG110, TheReEntryIsHeldAtTheRPlane) {
  EXPECT_EQ(records_of("gsk.g110.000084"), clearance_pocket("6", "4"));      // P omitted: 0
  EXPECT_EQ(records_of("gsk.g110.000088"), clearance_pocket("8", "6"));      // P2
  EXPECT_EQ(records_of("gsk.g110.000089"), clearance_pocket("8", "6.001"));  // 6 + 2.001 > 8
  EXPECT_EQ(records_of("gsk.g110.000090"), clearance_pocket("8", "7"));      // 6 + 3 > 8
  EXPECT_EQ(records_of("gsk.g110.000091"), clearance_pocket("8", "8"));      // P100
}

TEST(DerivedG110, ANegativePCountsByItsAbsoluteValue) {
  EXPECT_EQ(records_of("gsk.g110.000092"), clearance_pocket("6.5", "4.5"));
}

TEST(DerivedG110, Upward) {
  // R2: R plane 12; W6 to 18. P3: 14 - 3 lies below the R plane, 16 - 3 = 13 does not.
  const Lines want = kSmallStart + Lines{"2 rapid z12", "2 feed z14 f200"} + small_layer("12") +
                     Lines{"2 rapid z12", "2 feed z16 f200"} + small_layer("12") +
                     Lines{"2 rapid z13", "2 feed z18 f200"} + small_layer("12") +
                     Lines{"2 rapid z10", "end x10 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g110.000095"), want);
}

TEST(DerivedG110, WithoutDepthNothingIsCut) {
  const Lines want = kSmallStart + Lines{"2 rapid z5", "2 rapid z10", "end x10 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g110.000120"), want);
}

TEST(DerivedG110, TheInitialPlaneStaysFromPocketToPocket) {
  // Every pocket ends at Z10, the initial plane, and R counts from there: R-1 is 9, R-3 is 7.
  // Pockets 2 and 3 stand at radius 15 and 20; P of the first holds no more: re-entry at the depth.
  Lines want = kSmallStart + Lines{"2 rapid z9", "2 feed z7 f200"} + small_layer("9") +
               Lines{"2 rapid z7.5", "2 feed z5 f200"} + small_layer("9") + Lines{"2 rapid z10"};
  const Lines second = {"3 arc G17 -1 cx16 cy5 x17 y5 f200", "3 arc G17 -1 cx15 cy5 x17 y5 f200",
                        "3 rapid z7", "3 rapid x15 y5"};
  want = want + Lines{"3 rapid x15 y5", "3 rapid z7", "3 feed z5 f200"} + second +
         Lines{"3 rapid z5", "3 feed z3 f200"} + second + Lines{"3 rapid z3", "3 feed z2 f200"} +
         second + Lines{"3 rapid z10"};
  const Lines third = {"4 arc G17 -1 cx21 cy5 x22 y5 f200", "4 arc G17 -1 cx20 cy5 x22 y5 f200",
                       "4 rapid z7", "4 rapid x20 y5"};
  want = want + Lines{"4 rapid x20 y5", "4 rapid z7", "4 feed z5 f200"} + third +
         Lines{"4 rapid z5", "4 feed z3 f200"} + third + Lines{"4 rapid z3", "4 feed z1 f200"} +
         third + Lines{"4 rapid z10", "end x20 y5 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g110.000134"), want);
}

TEST(DerivedG110, InInch) {
  // Centre X1 = radius 12.7, Y0.5 = 12.7; initial 12.7, R plane 10.16, layers of 2.54 down to 2.54,
  // P0.02 = 0.508. I - D = 0.1 in = 2.54, L/2 = 0.075 in = 1.905: semicircles to 12.7 + 1.905 and
  // 12.7 - 2.54, centres 12.7 + 1.905/2 and 12.7 + (1.905 - 2.54)/2. F10 = 254.
  const Lines layer = {"2 arc G17 -1 cx13.6525 cy12.7 x14.605 y12.7 f254",
                       "2 arc G17 -1 cx12.3825 cy12.7 x10.16 y12.7 f254",
                       "2 arc G17 -1 cx12.7 cy12.7 x10.16 y12.7 f254", "2 rapid z10.16",
                       "2 rapid x12.7 y12.7"};
  const Lines want = Lines{"1 rapid x25.4 y25.4 z12.7", "2 rapid x12.7 y12.7", "2 rapid z10.16",
                           "2 feed z7.62 f254"} +
                     layer + Lines{"2 rapid z8.128", "2 feed z5.08 f254"} + layer +
                     Lines{"2 rapid z5.588", "2 feed z2.54 f254"} + layer +
                     Lines{"2 rapid z12.7", "end x12.7 y12.7 z12.7 a0 c0"};
  EXPECT_EQ(records_of("gsk.g110.000125"), want);
}

TEST(DerivedG110, XAsDepthIsADiameterOrALength) {
  // G19: p = Y, q = Z, d = X. X40 is 20; R-1: R plane 19. U-20 is 10 deep as a diameter (two layers
  // of 5), 20 deep as a length (four). I - D = 2 about Y20, Z5; P1.
  const Lines start = {"1 rapid x20 y30 z10", "2 rapid y20 z5", "2 rapid x19", "2 feed x14 f200"};
  const Lines layer = {"2 arc G19 -1 cy21 cz5 y22 z5 f200", "2 arc G19 -1 cy20 cz5 y22 z5 f200",
                       "2 rapid x19", "2 rapid y20 z5"};
  const Lines end = {"2 rapid x20", "end x20 y20 z5 a0 c0"};
  const Lines diameter = start + layer + Lines{"2 rapid x15", "2 feed x9 f200"} + layer + end;
  const Lines length = start + layer + Lines{"2 rapid x15", "2 feed x9 f200"} + layer +
                       Lines{"2 rapid x10", "2 feed x4 f200"} + layer +
                       Lines{"2 rapid x5", "2 feed x-1 f200"} + layer + end;
  EXPECT_EQ(records_of("gsk.g110.reading.000033", 0), diameter);
  EXPECT_EQ(records_of("gsk.g110.reading.000033", 1), length);
}

TEST(DerivedG110, ConcentricCircles) {
  // I - D = 8, L = 3: radii 3, 6 and 8 about X10 Y10. R plane 9, layers 7 and 5, P0.5.
  const Lines layer = {"2 feed x13 y10 f200", "2 arc G17 -1 cx10 cy10 x13 y10 f200",
                       "2 feed x16 y10 f200", "2 arc G17 -1 cx10 cy10 x16 y10 f200",
                       "2 feed x18 y10 f200", "2 arc G17 -1 cx10 cy10 x18 y10 f200",
                       "2 rapid z9",          "2 rapid x10 y10"};
  const Lines want = kSmallStart + Lines{"2 rapid z9", "2 feed z7 f200"} + layer +
                     Lines{"2 rapid z7.5", "2 feed z5 f200"} + layer +
                     Lines{"2 rapid z10", "end x10 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g110.reading.000004"), want);
}

TEST(DerivedG110, TheLiteralEndIsTheRPlane) {
  const Lines want = kSmallStart + Lines{"2 rapid z9", "2 feed z7 f200"} + small_layer("9") +
                     Lines{"2 rapid z7.5", "2 feed z5 f200"} + small_layer("9") +
                     Lines{"end x10 y10 z9 a0 c0"};
  EXPECT_EQ(records_of("gsk.g110.reading.000009"), want);
}

}  // namespace
}  // namespace gonogo::testing
