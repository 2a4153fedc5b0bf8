// SPDX-License-Identifier: GPL-3.0-or-later
//
// What no text fixes of words from earlier blocks and of lone words: each alternative. The tool
// begins at X0 Z0, and X is a diameter.
#include <gtest/gtest.h>

#include <algorithm>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

// B lies I before C, at a radius of 10.
TEST(CarriedWords, TheSameCodeAgainKeepsTheWordsOrForgetsThem) {
  const Profile clear = hnc({{"hnc.rewrite", "clear"}});
  const char* taper = "G80 X20 Z-10 I-5 F100\nG80 X20 Z-10";
  EXPECT_EQ(path(taper).at(4), "rapid x5");
  EXPECT_EQ(path(taper, clear).at(4), "rapid x10");
  EXPECT_EQ(path("G80 X20 Z-10 I-5 F100\nG80 X20 Z-10 I-4", clear).at(4), "rapid x6");
  EXPECT_EQ(path("G80 X20 Z-10 I-5 F100\nX20 Z-10", clear).at(4), "rapid x5");
  const char* lead = "G82 X20 Z-10 F3\nG82 X20 Z-10";
  EXPECT_EQ(ending_of(lead), kEndAtOrigin);
  EXPECT_EQ(ending_of(lead, clear), "alarm b2 lead-missing");
  EXPECT_EQ(ending_of("G32 Z-10 F3\nG32 Z-20", clear), "end x0 y0 z-20 a0 c0");
}

TEST(CarriedWords, ABlockWithoutAxisWordsMovesNothingOrRunsTheCycleAgain) {
  const Profile repeat = hnc({{"hnc.empty-block", "repeat"}});
  const std::string turn = "G80 X20 Z-10 F100\n";
  for (const char* block : {"G80 F50", "F50", "G80", "I-2"}) {
    EXPECT_EQ(path(turn + block).size(), 4U) << block;
    EXPECT_EQ(path(turn + block, repeat).size(), 8U) << block;
  }
  EXPECT_EQ(path(turn + "G80 F50", repeat).at(5), "feed x10 z-10 f50");
  EXPECT_EQ(path(turn + "I-2", repeat).at(4), "rapid x8");
  EXPECT_EQ(path("G81 X20 Z-10 F100\nK-2", repeat).at(4), "rapid z-12");
  EXPECT_EQ(path("G74 Z-10 F50\nF60", repeat).at(2), "feed z-10 f60");
  for (const char* block : {"M08", "S300", "T0101", "G21"}) {
    EXPECT_EQ(path(turn + block, repeat).size(), 4U) << block;
  }
}

TEST(CarriedWords, ABlockWithoutAxisWordsNeedsACycleToRunAgain) {
  const Profile repeat = hnc({{"hnc.empty-block", "repeat"}});
  EXPECT_EQ(path("G80 F50\nX20 Z-10", repeat).size(), 4U);
  EXPECT_EQ(path("G75 X-20 F50\nF60", repeat).size(), 2U);
}

TEST(CarriedWords, XOfADrillHasNoEffectOrIsWhereItDrills) {
  const Profile first = hnc({{"hnc.g74.x", "first"}});
  EXPECT_EQ(path("G74 X20 Z-10 F50"), (Lines{"feed z-10 f50", "rapid z0"}));
  EXPECT_EQ(path("G74 X20 Z-10 F50", first), (Lines{"rapid x10", "feed z-10 f50", "rapid z0"}));
  EXPECT_EQ(ending_of("G74 U20 Z-10 F50", first), "end x10 y0 z0 a0 c0");
  EXPECT_EQ(touched("G74 X0 Z-10 F50"), Lines{});
  EXPECT_EQ(touched("G74 X20 Z-10 F50"), Lines{"hnc.g74.x"});
}

// Two steps are three plunges.
TEST(CarriedWords, AWidthOfZeroPlungesAtOnePlaceAsOftenOrOnce) {
  const Profile once = hnc({{"hnc.g75.zero-width", "once"}});
  const Lines each = path("G75 X-20 W0 I2 F50");
  EXPECT_EQ(std::ranges::count(each, "feed x-10 f50"), 3);
  const Lines single = path("G75 X-20 W0 I2 F50", once);
  EXPECT_EQ(std::ranges::count(single, "feed x-10 f50"), 1);
}

TEST(CarriedWords, SeveralStartsComeInOneOrderOrTheOther) {
  const Profile falling = hnc({{"hnc.g82.order", "falling"}});
  const char* program = "G82 X20 Z-10 C3 P120 F3";
  EXPECT_EQ(path(program).at(1), "thread x10 z-10 lead3 start0");
  EXPECT_EQ(path(program, falling).at(1), "thread x10 z-10 lead3 start240");
  EXPECT_EQ(path(program, falling).at(5), "thread x10 z-10 lead3 start120");
  EXPECT_EQ(path(program, falling).at(9), "thread x10 z-10 lead3 start0");
}

// 4 inches a minute are 101.6 mm, and 254 mm times 25.4 are 6451.6.
TEST(CarriedWords, OtherUnitsLeaveTheFeedOrItsNumber) {
  const Profile number = hnc({{"hnc.feed-units", "number"}});
  const char* metric = "G20 G01 X2 F4\nG21 X40";
  EXPECT_EQ(path(metric), (Lines{"feed x25.4 f101.6", "feed x20 f101.6"}));
  EXPECT_EQ(path(metric, number), (Lines{"feed x25.4 f101.6", "feed x20 f4"}));
  const char* imperial = "F254\nG20 G01 X2";
  EXPECT_EQ(path(imperial), Lines{"feed x25.4 f254"});
  EXPECT_EQ(path(imperial, number), Lines{"feed x25.4 f6451.6"});
  EXPECT_EQ(path("G20 F4\nG21 G01 X40 F5", number), Lines{"feed x20 f5"});
}

// 0.1 inch are 2.54 mm. The taper I ends 10 mm from the axis; the count of G75 is no length.
TEST(CarriedWords, OtherUnitsLeaveTheLengthsOfACycleOrTheirNumbers) {
  const Profile number = hnc({{"hnc.retained", "number"}});
  const std::string taper = "G20 G80 X1 Z-1 I-0.1 F4\nG21 X20 Z-10";
  EXPECT_EQ(path(taper).at(4), "rapid x7.46");
  EXPECT_EQ(path(taper, number).at(4), "rapid x9.9");
  EXPECT_EQ(path(taper + " I-3", number).at(4), "rapid x7");
  EXPECT_EQ(path("G74 Z-10 R1 Q6 F50\nG20 Z-10", number).at(4), "feed z-152.4 f50");
  EXPECT_EQ(path("G82 X20 Z-10 R-1 E1 F2\nG20 X1 Z-1", number).at(7),
            "thread x38.1 z-50.8 lead2 start0");
  EXPECT_EQ(path("G75 X-20 Z-2 I2 F50\nG20 X-1 Z-1", number),
            path("G75 X-20 Z-2 I2 F50\nG20 X-1 Z-1"));
  EXPECT_EQ(touched("G80 X20 Z-10 I-1 F50\nG20 G00 X1"), (Lines{"hnc.retained", "hnc.feed-units"}));
}

TEST(CarriedWords, AnotherKindOfFeedLeavesItsNumberOrTakesItAway) {
  const Profile deleted = hnc({{"hnc.feed-change", "deleted"}});
  const std::string moved = "end x10 y0 z0 a0 c0";
  EXPECT_EQ(path("F100\nG95 G01 X20"), Lines{"feed x10 f100/rev"});
  EXPECT_EQ(ending_of("F100\nG95 G01 X20", deleted), "alarm b2 feed-missing");
  EXPECT_EQ(ending_of("F100\nG95 G01 X20 F0.2", deleted), moved);
  EXPECT_EQ(ending_of("F100\nG94 G01 X20", deleted), moved);
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
