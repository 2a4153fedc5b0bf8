// SPDX-License-Identifier: GPL-3.0-or-later
//
// G112 and G113 derived by hand from the manual, against the vectors. From the centre a
// semicircle of radius (I - D)/2 to the circle of radius I - D, on +p; one helix of L turns from
// the R plane to the bottom; a semicircle back.
#include <gtest/gtest.h>

#include "derived.hpp"

namespace gonogo::testing {
namespace {

TEST(DerivedG112, TheExampleOfTheManual) {
  // X70 is radius 35. I - D = 4: semicircles of radius 2 about Z72; five turns from Y30 to Y20.
  const Lines want = {"1 rapid x35 y30 z70",
                      "3 rapid x35 z70",
                      "3 rapid y30",
                      "3 arc G18 -1 cx35 cz72 x35 z74 f200",
                      "3 arc G18 -5 cx35 cz70 x35 y20 z74 f200",
                      "3 arc G18 -1 cx35 cz72 x35 z70 f200",
                      "3 rapid y30",
                      "end x35 y30 z70 a0 c0"};
  EXPECT_EQ(records_of("gsk.g112.000001"), want);
  // V-10 without R is the same bottom.
  EXPECT_EQ(records_of("gsk.g112.000003"), want);
}

TEST(DerivedG112, AnIncrementalDepthCountsFromTheRPlane) {
  // R plane 27; V-10: bottom 17.
  const Lines want = {"1 rapid x35 y30 z70",
                      "3 rapid x35 z70",
                      "3 rapid y27",
                      "3 arc G18 -1 cx35 cz72 x35 z74 f200",
                      "3 arc G18 -5 cx35 cz70 x35 y17 z74 f200",
                      "3 arc G18 -1 cx35 cz72 x35 z70 f200",
                      "3 rapid y30",
                      "end x35 y30 z70 a0 c0"};
  EXPECT_EQ(records_of("gsk.g112.000005"), want);
}

TEST(DerivedG112, TheClampIsPassedOnBeforeTheMotion) {
  Lines want = records_of("gsk.g112.000001");
  want.insert(want.begin() + 1, "3 m 35");
  EXPECT_EQ(records_of("gsk.g112.000007"), want);
}

// The pockets "X20 Y10 I6 D4" in G17: I - D = 2 about X10 Y10, semicircles of radius 1 about X11.
Lines pocket(const std::string& block, const std::string& x, const std::string& y,
             const std::string& turns, const std::string& r_plane, const std::string& bottom,
             const std::string& middle, const std::string& side, const std::string& sense) {
  const std::string plane = block + " arc G17 ";
  return {block + " rapid x" + x + " y" + y,
          block + " rapid z" + r_plane,
          plane + sense + " cx" + middle + " cy" + y + " x" + side + " y" + y + " f200",
          plane + turns + " cx" + x + " cy" + y + " x" + side + " y" + y + " z" + bottom + " f200",
          plane + sense + " cx" + middle + " cy" + y + " x" + x + " y" + y + " f200",
          block + " rapid z10"};
}
const Lines kFirstStart = {"1 rapid x20 y30 z10"};

TEST(DerivedG112, ADepthThatLDoesNotDivideInDecimals) {
  // 10 in three turns is one helix all the same.
  const Lines want = kFirstStart + pocket("2", "10", "10", "-3", "10", "0", "11", "12", "-1") +
                     Lines{"end x10 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g112.000079"), want);
}

TEST(DerivedG112, UpwardFromAnRPlane) {
  // R3: R plane 13, W4 to 17, two turns.
  const Lines want = kFirstStart + pocket("2", "10", "10", "-2", "13", "17", "11", "12", "-1") +
                     Lines{"end x10 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g112.000089"), want);
}

TEST(DerivedG112, HalfAnIncrementCounterclockwise) {
  // I9.357 D2.5: 6.857 in radius, semicircles of 3.4285. R plane 9, bottom 5.
  const Lines want = kFirstStart +
                     pocket("2", "10", "10", "2", "9", "5", "13.4285", "16.857", "1") +
                     Lines{"end x10 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g112.000098"), want);
}

TEST(DerivedG112, WithoutDepthNothingIsCut) {
  const Lines want =
      kFirstStart + Lines{"2 rapid x10 y10", "2 rapid z5", "2 rapid z10", "end x10 y10 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g112.000126"), want);
}

TEST(DerivedG112, InInch) {
  // X1 is radius 12.7. R plane 0.4 in = 10.16, bottom 0.1 in = 2.54; I - D = 0.1 in = 2.54.
  const Lines want = {"1 rapid x25.4 y25.4 z12.7",
                      "2 rapid x12.7 y12.7",
                      "2 rapid z10.16",
                      "2 arc G17 -1 cx13.97 cy12.7 x15.24 y12.7 f254",
                      "2 arc G17 -3 cx12.7 cy12.7 x15.24 y12.7 z2.54 f254",
                      "2 arc G17 -1 cx13.97 cy12.7 x12.7 y12.7 f254",
                      "2 rapid z12.7",
                      "end x12.7 y12.7 z12.7 a0 c0"};
  EXPECT_EQ(records_of("gsk.g112.000136"), want);
}

TEST(DerivedG112, LAndRHoldForTheirBlock) {
  // L2 R-1, then one turn from the initial plane, three, and one again.
  const Lines want = kFirstStart + pocket("2", "10", "10", "-2", "9", "5", "11", "12", "-1") +
                     pocket("3", "15", "5", "-1", "10", "6", "16", "17", "-1") +
                     pocket("4", "20", "5", "-3", "10", "6", "21", "22", "-1") +
                     pocket("5", "25", "5", "-1", "10", "6", "26", "27", "-1") +
                     Lines{"end x25 y5 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g112.000147"), want);
}

TEST(DerivedG112, G113KeepsIAndD) {
  const Lines want = kFirstStart + pocket("2", "10", "10", "-2", "9", "5", "11", "12", "-1") +
                     pocket("3", "15", "5", "2", "10", "6", "16", "17", "1") +
                     pocket("4", "20", "5", "1", "10", "6", "21", "22", "1") +
                     Lines{"end x20 y5 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.g112.000161"), want);
}

TEST(DerivedG112, AFullCircleAtTheBottom) {
  Lines want = kFirstStart + pocket("2", "10", "10", "-2", "9", "5", "11", "12", "-1") +
               Lines{"end x10 y10 z10 a0 c0"};
  want.insert(want.begin() + 5, "2 arc G17 -1 cx10 cy10 x12 y10 f200");
  EXPECT_EQ(records_of("gsk.reading.000008"), want);
}

TEST(DerivedG112, AModalL) {
  // are radii; W-3 from the initial plane is 7.
  const Lines want = kFirstStart + pocket("2", "10", "10", "-2", "9", "5", "11", "12", "-1") +
                     pocket("3", "-15", "5", "-2", "10", "6", "-14", "-13", "-1") +
                     pocket("4", "-30", "5", "-2", "10", "7", "-29", "-28", "-1") +
                     Lines{"end x-30 y5 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.reading.000015"), want);
}

TEST(DerivedG112, UAsATrueLengthInG19) {
  // X20 is radius 10; R plane 9, U-4 as a length: 5. p = Y, q = Z.
  const Lines want = {"1 rapid x10 y40 z30",
                      "2 rapid y20 z10",
                      "2 rapid x9",
                      "2 arc G19 -1 cy21 cz10 y22 z10 f200",
                      "2 arc G19 -2 cy20 cz10 x5 y22 z10 f200",
                      "2 arc G19 -1 cy21 cz10 y20 z10 f200",
                      "2 rapid x10",
                      "end x10 y20 z10 a0 c0"};
  EXPECT_EQ(records_of("gsk.reading.000044"), want);
}

}  // namespace
}  // namespace gonogo::testing
