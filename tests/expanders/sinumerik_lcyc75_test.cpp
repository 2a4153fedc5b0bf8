// SPDX-License-Identifier: GPL-3.0-or-later
// LCYC75 in the expander of sinumerik802s.
#include <gtest/gtest.h>

#include "sinumerik_motions.hpp"

namespace gonogo::expanders::testing {
namespace {

constexpr const char* kTools = R"("tools":{"1":{"radius":"5"},"2":{"radius":"2"}})";

std::string profile(const std::string& readings = "") {
  return "{" + std::string(kTools) + (readings.empty() ? "" : ",\"readings\":" + readings) + "}";
}

Outcome milled(const std::string& program, const std::string& readings = "") {
  return run_sinumerik802s(program, profile(readings));
}

std::string pocket_alarm(const std::string& program, const std::string& readings = "") {
  const Outcome outcome = milled(program, readings);
  return outcome.alarms == 0 ? "" : outcome.alarm;
}

// With R103=0 for the misprinted 9.
const std::string kFirst =
    "G0 G17 G90 F200 S300 M3 T1 D1\nR101=5 R102=2 R103=0 R104=-17.5 R105=2\n"
    "R116=60 R117=40 R118=60 R119=40 R120=8\nR121=4 R122=120 R123=300 R124=0.75 R125=0.5\n"
    "R126=2 R127=1\n";
const std::string kSmallPocket =
    "T1 S1 M3\nR101=5 R102=1 R104=-2 R118=10 R119=10 R120=5 R121=2 R122=20 R123=30 R126=2 "
    "R127=1\n";

using Depths = std::vector<double>;

TEST(SinumerikPocket, LevelsOfTheFirstExample) {
  EXPECT_EQ(plunges(milled(kFirst + "LCYC75\n")), (Depths{-3.4, -6.8, -10.2, -13.6, -17}));
  EXPECT_EQ(plunges(milled(kFirst + "LCYC75\n", R"({"sie.infeed-from":"clearance"})")),
            (Depths{-1.8, -5.6, -9.4, -13.2, -17}));
  EXPECT_EQ(plunges(milled(kFirst + "LCYC75\n", R"({"sie.infeed":"max-rest"})")),
            (Depths{-4, -8, -12, -16, -17}));
  EXPECT_EQ(plunges(milled(kFirst + "LCYC75\n",
                           R"({"sie.infeed":"max-rest","sie.infeed-from":"clearance"})")),
            (Depths{-2, -6, -10, -14, -17}));
  EXPECT_EQ(plunges(milled(kFirst + "R127=2\nLCYC75\n")), (Depths{-3.5, -7, -10.5, -14, -17.5}));
}

TEST(SinumerikPocket, LevelsThatAreThirds) {
  // 19 by 19/3 is three levels, though binary64 rounds the third.
  EXPECT_EQ(plunges(milled(kSmallPocket + "R104=-19 R121=19/3\nLCYC75\n")).size(), 3u);
  EXPECT_EQ(plunges(milled(kSmallPocket + "R104=-17 R121=17/3\nLCYC75\n")).size(), 3u);
  EXPECT_EQ(plunges(milled(kSmallPocket + "R104=-19 R121=6.333\nLCYC75\n")).size(), 4u);
}

// (0, 40) as printed has R126=0.
TEST(SinumerikPocket, TheSecondExample) {
  const std::string program =
      "G0 G19 G90 S200 M3 T1 D1\nZ60 X40 Y5\nR101=4 R102=2 R103=0 R104=-20 R116=50 R117=50\n"
      "R118=50 R119=50 R120=50 R121=4 R122=100\nR123=200 R124=0 R125=0R126=0 R127=1\n";
  EXPECT_EQ(pocket_alarm(program + "LCYC75\n"), "direction-parameter");
  const Outcome outcome = milled(program + "R126=3\nLCYC75\n");
  EXPECT_EQ(plunges(outcome, 0), (Depths{-4, -8, -12, -16, -20}));
  const std::vector<Motion> motions = motions_of(outcome);
  EXPECT_EQ(motions[1].text, "rapid x=4 y=50 z=50\n");
  EXPECT_EQ(motions.back().text, "rapid x=4\n");
}

TEST(SinumerikPocket, WithoutADirectionItGoesRoundAsTheReadingSays) {
  const auto round = [](const char* direction, const std::string& readings = "") {
    return moving(milled(kSmallPocket + "R118=12 R119=12\n" + direction + "\nLCYC75\n", readings));
  };
  EXPECT_EQ(round("R126=0", R"({"sie.lc75.no-sense":"g2"})"), round("R126=2"));
  EXPECT_EQ(round("R126=0", R"({"sie.lc75.no-sense":"g3"})"), round("R126=3"));
  EXPECT_NE(round("R126=2"), round("R126=3"));
}

// The tool's centre reaches 25. A strip of 10 in sharp corners is 1.5 more than one pass takes of
// it, 1.7 radii of 5: another pass goes round 1.3 radii farther in, at 18.5. One of 20 is 11.5
// more, and takes two: at 18.5 and 12.
TEST(SinumerikPocket, AnAllowanceAboveTheToolIsFinishedInSeveralPasses) {
  const std::string none = R"({"sie.lc75.finish-limit":"none"})";
  const auto finished = [&](const char* allowance, const std::string& readings) {
    const std::string ways = "R118=60 R119=60 R125=0 R127=2 ";
    return milled(kSmallPocket + ways + allowance + "\nLCYC75\n", readings);
  };
  EXPECT_EQ(finished("R124=10", "").alarm, "allowance-too-large");
  const std::string ten = moving(finished("R124=10", none));
  EXPECT_NE(ten.find("feed z=-2 f=20\nfeed y=-18.5 f=30\nfeed x=-18.5 f=30\n"), std::string::npos);
  const std::string twenty = moving(finished("R124=20", none));
  EXPECT_NE(twenty.find("feed z=-2 f=20\nfeed y=-12 f=30\nfeed x=-12 f=30\n"), std::string::npos);
  EXPECT_NE(twenty.find("feed y=-18.5 f=30\n"), std::string::npos);
}

TEST(SinumerikPocket, TheThirdExampleMillsItsSlots) {
  const std::string program =
      "G0 G19 G90 T1 D1 S400 M3\nR101=5 R102=1 R103=0 R104=-23 R116=35 R117=0\n"
      "R118=30 R119=15 R120=15 R121=6 R122=200\nR123=300 R124=0 R125=0 R126=2 R127=1\n"
      "G158 Y40 Z45\nG259 RPL45\nLCYC75\nG259 RPL90\nLCYC75\n";
  const Outcome outcome = milled(program);
  EXPECT_EQ(plunges(outcome, 0), (Depths{-5.75, -11.5, -17.25, -23, -5.75, -11.5, -17.25, -23}));
  EXPECT_EQ(motions_of(outcome).front().text, "rapid x=5 y=64.748737342 z=69.748737342\n");
}

// Half sides 1: the tool goes round a square, clockwise, from the centre and back to it.
TEST(SinumerikPocket, ASmallSquare) {
  EXPECT_EQ(moving(milled(kSmallPocket + "R118=12 R119=12 R116=7\nLCYC75\n")),
            "rapid x=7 z=5\nrapid z=1\nfeed z=-2 f=20\nfeed y=-1 f=30\nfeed x=6 f=30\n"
            "feed y=1 f=30\nfeed x=8 f=30\nfeed y=-1 f=30\nfeed x=7 f=30\nfeed y=0 f=30\n"
            "rapid z=5\n");
}

TEST(SinumerikPocket, ALineAndAPoint) {
  EXPECT_EQ(moving(milled(kSmallPocket + "LCYC75\n")),
            "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nrapid z=5\n");
  EXPECT_EQ(moving(milled(kSmallPocket + "R119=14\nLCYC75\n")),
            "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nfeed y=2 f=30\nfeed y=-2 f=30\n"
            "feed y=0 f=30\nrapid z=5\n");
}

TEST(SinumerikPocket, RulesOfItsNumbers) {
  const std::vector<std::pair<const char*, const char*>> cases = {
      {"", ""},
      {"R127=0", "machining-type"},
      {"R127=1.5", "machining-type"},
      {"R126=4", "direction-parameter"},
      {"R101=0.9", "reference-plane"},
      {"R101=1", ""},
      {"R103=-2", "reference-plane"},
      {"R121=0", "value-sign"},
      {"R118=0", "pocket-size"},
      {"R119=-1", "pocket-size"},
      {"R118=40 R119=40 R124=10", "allowance-too-large"},
      {"R124=10 R127=2", "allowance-too-large"},
      {"R124=9.9 R127=2", ""},
      {"R120=-1", "value-sign"},
      {"R120=0", ""},
      {"R124=-1", "value-sign"},
      {"R125=-1", "value-sign"},
      {"R125=2", "allowance-too-large"},
      {"R125=2 R127=2", ""},
      {"R125=1.9", ""},
      {"R122=0", "feed-missing"},
      {"R123=-1", "feed-missing"},
      {"R118=9.999", "tool-too-large"},
      {"R124=0.001", "tool-too-large"},
      {"R124=0.001 R127=2", ""},
      {"M5", "spindle-stopped"},
      {"S0", "spindle-stopped"},
      {"T0", "no-tool"},
      {"D0", "no-tool"},
      {"D0\nT2", ""},
      {"T3", "no-tool"},
  };
  for (const auto& [words, expected] : cases) {
    EXPECT_EQ(pocket_alarm(kSmallPocket + words + "\nLCYC75\n"), expected) << words;
  }
  EXPECT_EQ(
      pocket_alarm("S1 M3\nR101=5 R104=-2 R118=10 R119=10 R121=2 R122=20 R123=30 R126=2 R127=1\n"
                   "LCYC75\n"),
      "no-tool");
  EXPECT_EQ(pocket_alarm("LCYC75\n").empty(), false);
}

TEST(SinumerikPocket, LargeCorners) {
  const char* reject = R"({"sie.corner":"reject"})";
  EXPECT_EQ(pocket_alarm(kSmallPocket + "R120=5.001\nLCYC75\n"), "");
  EXPECT_EQ(pocket_alarm(kSmallPocket + "R120=5.001\nLCYC75\n", reject), "pocket-size");
  EXPECT_EQ(pocket_alarm(kSmallPocket + "R120=5\nLCYC75\n", reject), "");
}

TEST(SinumerikPocket, LeavesModesAsTheyWere) {
  EXPECT_EQ(moving(milled("G1 F9 G91\n" + kSmallPocket + "LCYC75\nX1 Y=R104\n")),
            "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nrapid z=5\nfeed x=1 y=-2 f=9\n");
}

// R123 is 30, and counts millimetres.
TEST(SinumerikPocket, LeavesItsFeedUnderTheReading) {
  const std::string pocket = "F9\n" + kSmallPocket + "LCYC75\n";
  const std::string way = "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nrapid z=5\n";
  const char* of_cycle = R"({"sie.lc75.feed-after":"of-cycle","sie.g70.f":"inch"})";
  EXPECT_EQ(moving(milled(pocket + "G1 X1\n", of_cycle)), way + "feed x=1 f=30\n");
  EXPECT_EQ(moving(milled(pocket + "G1 X1 F7\nX2\n", of_cycle)),
            way + "feed x=1 f=7\nfeed x=2 f=7\n");
  EXPECT_EQ(moving(milled(pocket + "G70\nG1 X1\n", of_cycle)), way + "feed x=25.4 f=30\n");
}

// R101=5, R103+R102=1, R104=-2 and R122=20 of the small pocket.
TEST(SinumerikPocket, CountsInchesUnderTheReading) {
  const std::string pocket = "G70\n" + kSmallPocket + "LCYC75\n";
  const auto way = [&](const char* readings) { return moving(milled(pocket, readings)); };
  EXPECT_EQ(way(R"({"sie.lcyc.unit":"mm"})"), "rapid z=5\nrapid z=1\nfeed z=-2 f=20\nrapid z=5\n");
  const std::string inches = "rapid z=127\nrapid z=25.4\nfeed z=-50.8 f=";
  EXPECT_NE(way(R"({"sie.lcyc.unit":"inch"})").find(inches + "20\n"), std::string::npos);
  EXPECT_NE(way(R"({"sie.lcyc.unit":"inch-with-feeds"})").find(inches + "508\n"),
            std::string::npos);
}

TEST(SinumerikPocket, OnlyItsOwnPathIsOffered) {
  const std::string refused = profile(R"({"sie.pocket.path":"contour-parallel"})");
  EXPECT_EQ(Session(refused, {}, "sinumerik802s").outcome().create, GONOGO_UNSUPPORTED);
  EXPECT_FALSE(Session(refused, {}, "sinumerik802s").outcome().note.empty());
  const std::string any = profile(
      R"({"sie.pocket.path":"any","sie.infeed":"any","sie.infeed-from":"any","sie.finish.levels":"split"})");
  EXPECT_EQ(Session(any, {}, "sinumerik802s").outcome().create, GONOGO_OK);
}

}  // namespace
}  // namespace gonogo::expanders::testing
