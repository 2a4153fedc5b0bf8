// SPDX-License-Identifier: GPL-3.0-or-later
// LCYC75 in the expander of sinumerik802s.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

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
  // 19 by 19/3 is three levels, whatever binary64 makes of the third.
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

TEST(SinumerikPocket, OnlyItsOwnPathIsOffered) {
  const std::string refused = profile(R"({"sie.pocket.path":"contour-parallel"})");
  EXPECT_EQ(Session(refused, {}, "sinumerik802s").outcome().create, GONOGO_UNSUPPORTED);
  EXPECT_FALSE(Session(refused, {}, "sinumerik802s").outcome().note.empty());
  const std::string any = profile(
      R"({"sie.pocket.path":"any","sie.infeed":"any","sie.infeed-from":"any","sie.finish.levels":"split"})");
  EXPECT_EQ(Session(any, {}, "sinumerik802s").outcome().create, GONOGO_OK);
}

// ---- what is cut, by sampling ----

struct Place {
  double x;
  double y;
};

/// A rectangle about the zero point with rounded corners.
struct Rounded {
  double a;
  double b;
  double corner;
  /// Distance from the rectangle; not above 0 inside.
  double distance(Place p) const {
    const double x = std::fabs(p.x) - (a - corner);
    const double y = std::fabs(p.y) - (b - corner);
    if (x <= 0 || y <= 0) return std::max(x, y) - corner;
    return std::hypot(x, y) - corner;
  }
};

double distance(Place p, Place from, Place to) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double square = dx * dx + dy * dy;
  const double along = square == 0 ? 0 : ((p.x - from.x) * dx + (p.y - from.y) * dy) / square;
  const double t = std::clamp(along, 0., 1.);
  return std::hypot(p.x - from.x - t * dx, p.y - from.y - t * dy);
}

using Path = std::vector<Place>;

// The plane motions of the last level as short lines.
Path last_level(const Outcome& outcome) {
  Path path;
  for (const Motion& motion : motions_of(outcome)) {
    if (motion.kind == 'r') continue;
    if (motion.to[2] != motion.from[2]) path.clear();
    if (motion.kind == 'a') {
      const double radius =
          std::hypot(motion.from[0] - motion.centre[0], motion.from[1] - motion.centre[1]);
      const double start =
          std::atan2(motion.from[1] - motion.centre[1], motion.from[0] - motion.centre[0]);
      for (int i = 1; i < 16; ++i) {  // a quarter each
        const double angle = start + motion.rot * i * std::numbers::pi / 32;
        path.push_back({motion.centre[0] + radius * std::cos(angle),
                        motion.centre[1] + radius * std::sin(angle)});
      }
    }
    path.push_back({motion.to[0], motion.to[1]});
  }
  return path;
}

struct PocketShape {
  double length;
  double width;
  double corner;
  double allowance;
};

std::string program_of(const PocketShape& s, int type, double bottom_allowance) {
  auto number = [](double value) { return std::to_string(value); };
  return "T2 S1 M3\nR101=5 R102=1 R104=-2 R121=2 R122=20 R123=30 R126=3\nR118=" + number(s.length) +
         " R119=" + number(s.width) + " R120=" + number(s.corner) + " R124=" + number(s.allowance) +
         " R125=" + number(bottom_allowance) + " R127=" + number(type) + "\nLCYC75\n";
}

/// Where the middle of a tool of radius 2 may be when `allowance` is left.
Rounded room(const PocketShape& s, double allowance) {
  const double off = allowance + 2;
  return {s.length / 2 - off, s.width / 2 - off, std::max(s.corner - off, 0.)};
}

// Places that the tool can reach, that `rest` does not hold already and that are not cut.
int uncut(const Path& path, const Rounded& area, const Rounded* rest) {
  constexpr int kSteps = 60;
  int count = 0;
  for (int i = -kSteps; i <= kSteps; ++i) {
    for (int j = -kSteps; j <= kSteps; ++j) {
      const Place p{(area.a + 2) * i / kSteps, (area.b + 2) * j / kSteps};
      if (area.distance(p) > 2 - 0.01 || (rest != nullptr && rest->distance(p) < 2)) continue;
      double nearest = std::hypot(p.x, p.y);
      for (std::size_t k = 1; k < path.size(); ++k) {
        nearest = std::min(nearest, distance(p, path[k - 1], path[k]));
      }
      if (nearest > 2 + 1e-3) ++count;
    }
  }
  return count;
}

// All of it is cut, and nothing beyond.
void check(const Path& path, const Rounded& area, const Rounded* rest, const std::string& name) {
  for (const Place& p : path) ASSERT_LE(area.distance(p), 1e-3) << name << " " << p.x << " " << p.y;
  EXPECT_EQ(uncut(path, area, rest), 0) << name;
}

const PocketShape kShapes[] = {{60, 40, 8, 0.75}, {40, 60, 8, 0.75}, {50, 50, 25, 0},
                               {30, 15, 7.5, 0},  {15, 30, 7.5, 1},  {20, 20, 0, 1.9},
                               {20, 20, 2, 3.9},  {13, 40, 3, 2.5},  {20, 11, 5, 3.4},
                               {9, 8.5, 1, 2.2},  {12, 12, 6, 3.9},  {24, 16, 4.5, 3}};

TEST(SinumerikPocket, RoughingClearsTheInsetPocketAndNoMore) {
  for (const PocketShape& shape : kShapes) {
    const std::string program = program_of(shape, 1, 0.5);
    if (shape.width < 2 * (shape.allowance + 2)) continue;
    const Rounded area = room(shape, shape.allowance);
    if (area.a < 0 || area.b < 0) continue;
    const Outcome outcome = milled(program);
    ASSERT_EQ(outcome.alarms, 0u) << program;
    EXPECT_EQ(plunges(outcome), Depths{-1.5});
    check(last_level(outcome), area, nullptr, program);
  }
}

TEST(SinumerikPocket, FinishingClearsTheWholeFloor) {
  for (const PocketShape& shape : kShapes) {
    const std::string program = program_of(shape, 2, 0.5);
    const Outcome outcome = milled(program);
    ASSERT_EQ(outcome.alarms, 0u) << program;
    check(last_level(outcome), room(shape, 0), nullptr, program);
  }
}

TEST(SinumerikPocket, ContourOnlyClearsWhatRoughingHasLeft) {
  for (const PocketShape& shape : kShapes) {
    if (shape.allowance == 0) continue;
    const std::string program = program_of(shape, 2, 0);
    const Outcome outcome = milled(program);
    ASSERT_EQ(outcome.alarms, 0u) << program;
    const Rounded rough = room(shape, shape.allowance);
    const bool nothing = rough.a < 0 || rough.b < 0;
    check(last_level(outcome), room(shape, 0), nothing ? nullptr : &rough, program);
  }
}

TEST(SinumerikPocket, TheSamplesShowWhatIsLeft) {
  const PocketShape shape{24, 16, 4.5, 3};
  auto left = [&](const char* fault, int type, double at_bottom, const Rounded* rest) {
    const std::string program = program_of(shape, type, at_bottom);
    const Path path = last_level(run_sinumerik802s(program, profile(), fault));
    return uncut(path, room(shape, type == 1 ? shape.allowance : 0), rest);
  };
  const Rounded rough = room(shape, shape.allowance);
  EXPECT_GT(left("pocket-strip-left", 2, 0, &rough), 0);
  EXPECT_GT(left("pocket-contour-only-by-r125", 2, 0, nullptr), 0);
  EXPECT_EQ(left("", 2, 0.5, nullptr), 0);
}

}  // namespace
}  // namespace gonogo::expanders::testing
