// SPDX-License-Identifier: GPL-3.0-or-later
//
// @ and ^ (NGC-POL). LinuxCNC's page prints the square and what becomes of it with a distance.
#include <gtest/gtest.h>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

TEST(NgcPolarWords, DistanceAndAngleAreXAndY) {
  EXPECT_EQ(path("F100 G1 @1 ^90"), Lines{"feed x0 y1 f100"});
  EXPECT_EQ(path("G0 @10 ^180 Z5"), Lines{"rapid x-10 y0 z5"});
  EXPECT_EQ(path("G20 G0 @2 ^-90"), Lines{"rapid x0 y-50.8"});
}

// The page: four steps of 90 degrees are a square; with 0.5 more each time a spiral.
TEST(NgcPolarWords, UnderG91TheyAdd) {
  EXPECT_EQ(path("F100 G1 @.5 ^90\nG91 ^90\n^90\n^90\n^90"),
            (Lines{"feed x0 y0.5 f100", "feed x-0.5 y0 f100", "feed x0 y-0.5 f100",
                   "feed x0.5 y0 f100", "feed x0 y0.5 f100"}));
  EXPECT_EQ(
      path("F100 G1 @.5 ^90\nG91 @.5 ^90\n@.5 ^90\n@.5 ^90"),
      (Lines{"feed x0 y0.5 f100", "feed x-1 y0 f100", "feed x0 y-1.5 f100", "feed x2 y0 f100"}));
}

// 3-4-5: 5 mm more along (3, 4) is (6, 8); 5 mm back from there is (3, 4).
TEST(NgcPolarWords, ADistanceAloneKeepsTheDirection) {
  EXPECT_EQ(path("G0 X3 Y4\n@10\nG91 @-5"), (Lines{"rapid x3 y4", "rapid x6 y8", "rapid x3 y4"}));
  EXPECT_EQ(path("G0 X3 Y4\n^0\n^270"), (Lines{"rapid x3 y4", "rapid x5 y0", "rapid x0 y-5"}));
}

// Four times 22.5 degrees are 90, and no rounding of three places between adds up.
TEST(NgcPolarWords, AddUpExactly) {
  EXPECT_EQ(path("G0 X10\nG91 ^22.5\n^22.5\n(a comment)\nG4 P0\n^22.5\n^22.5").back(),
            "rapid x0 y10");
  EXPECT_EQ(path("G0 X10\nG91 @1 ^45\n@1 ^45\nX5\n@-5").at(2), "rapid x0 y12");
  // 33 and 57 degrees are 90.
  EXPECT_EQ(path("G0 @10 ^33\nG91 ^57").at(1), "rapid x0 y10");
  EXPECT_EQ(path("F9 G0 X10\nG91 G81 ^15 L3 R-1 Z-1\nG0 ^45").back(), "rapid x0 y10");
}

// 3-4-5: ten back from 5 is 5 beyond the origin, and one more is 6.
TEST(NgcPolarWords, BeyondTheOriginADistanceGrowsAgain) {
  EXPECT_EQ(path("G0 X3 Y4\nG91 @-10\n@1"),
            (Lines{"rapid x3 y4", "rapid x-3 y-4", "rapid x-3.6 y-4.8"}));
}

// NGC-OFS-01: from the origin of the program, which G92 puts at the machine's (10, 0).
TEST(NgcPolarWords, CountFromTheOriginOfTheProgram) {
  EXPECT_EQ(path("G0 X10\nG92 X0\nG0 @5 ^90"), (Lines{"rapid x10", "rapid x10 y5"}));
}

// Half a turn about the centre (0, 0), from (5, 0) to (-5, 0).
TEST(NgcPolarWords, AreTheEndOfAnArc) {
  EXPECT_EQ(path("G0 X5\nG3 @5 ^180 I-5 F100").at(1), "arc x-5 y0 c0,0 rot1 f100");
}

// Holes at 90, 180 and 270 degrees; then three in a row, each 5 mm farther along +X.
TEST(NgcPolarWords, PlaceEachHoleOfACycle) {
  const char* const circle =
      "F100 G0 X10 Z2\n"
      "G91 G98 G81 ^90 L3 R-1 Z-3";
  EXPECT_EQ(path(circle),
            (Lines{"rapid x10 z2", "rapid x0 y10", "rapid z1", "feed z-2 f100", "rapid z2",
                   "rapid x-10 y0", "rapid z1", "feed z-2 f100", "rapid z2", "rapid x0 y-10",
                   "rapid z1", "feed z-2 f100", "rapid z2"}));
  EXPECT_EQ(path("F100 G0 X10 Z2\nG91 G99 G81 @5 L2 R-1 Z-3"),
            (Lines{"rapid x10 z2", "rapid x15 y0", "rapid z1", "feed z-2 f100", "rapid z1",
                   "rapid x20 y0", "feed z-2 f100", "rapid z1"}));
}

TEST(NgcPolarWords, StandBesideNeitherXNorY) {
  EXPECT_EQ(ending_of("G0 @5 ^30 X1"), "alarm b1 conflicting-words");
  EXPECT_EQ(ending_of("G0 ^30 Y1"), "alarm b1 conflicting-words");
  EXPECT_EQ(ending_of("@5 ^30"), "alarm b1 missing-word");
}

TEST(NgcPolarWords, CountNoAngleFromTheOrigin) {
  EXPECT_EQ(ending_of("G0 @5"), "not-covered b1 polar-word");
  EXPECT_EQ(ending_of("G91 G0 @5 ^90"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G91 G0 ^90"), "alarm b1 missing-word");
  EXPECT_EQ(clauses("G91 G0 ^90"), Lines{"NGC-POL-03"});
  EXPECT_EQ(ending_of("G0 ^90"), "end x0 y0 z0 a0 c0");
  // Back by the same distance is the origin itself, at an angle that no root says, too.
  EXPECT_EQ(ending_of("G0 @5 ^33\nG91 @-5\n^10"), "alarm b3 missing-word");
  EXPECT_EQ(ending_of("G0 @5 ^33\n@0\n@1"), "not-covered b3 polar-word");
  EXPECT_EQ(ending_of("G0 @5 ^33\n^20\n@2\nG91 @-2\n@1"), "alarm b5 missing-word");
}

TEST(NgcPolarWords, OfOtherCodesAreNotRead) {
  for (const char* block :
       {"G28 @5", "G92 @5 ^0", "G53 G0 @5 ^0", "G7 G0 @5 ^0", "G18 F9 G81 @5 ^0 Y-1 R1",
        "M3 S9 G33 @5 ^0 K1", "G0 @5 @6 ^30", "G18 G0 @5 ^0", "G19 G3 @5 ^0 J1 F9"}) {
    EXPECT_EQ(ending_of(block), "not-covered b1 polar-word") << block;
  }
  EXPECT_EQ(ending_of("G18\nG17 G0 @5 ^0"), "not-covered b2 polar-word");
  // At the origin, which has no angle; found by a hunt.
  EXPECT_EQ(ending_of("G19 G91 G83 X-4 @5 L2 Q4 R-10 ^-75 F500"), "not-covered b1 polar-word");
  EXPECT_EQ(ending_of("F9 G0 X10\nG91 G81 @-5 L4 R-1 Z-1"), "not-covered b2 polar-word");
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
