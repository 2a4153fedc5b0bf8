// SPDX-License-Identifier: GPL-3.0-or-later
//
// A pocket cleared by concentric circles, as somebody else would do it. G18: p = Z, q = X; centre
// Z 50, X 25 (radius); R plane Y 45; bottom Y 40, one layer; I - D = 16 - 4 = 12; L = 3.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "judging.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::string_view kG110Pocket =
    "G18 G0 X70 Z70 Y50\nG110 X50 Z50 Y40 R-5 I16 L3 Q5 P1 D4 F800\n";

struct Clearing {
  std::vector<int> radii = {3, 6, 9, 12};
  int rot = -1;
  std::string plunge_x = "25";
};

std::string trace(const Clearing& clearing) {
  std::string text = R"({"k":"rapid","b":1,"to":{"x":"35","y":"50","z":"70"}})"
                     "\n";
  text += fmt::format(R"({{"k":"rapid","b":2,"to":{{"x":"{}","z":"50"}}}})"
                      "\n",
                      clearing.plunge_x);
  text += R"({"k":"rapid","b":2,"to":{"y":"45"}})"
          "\n";
  text += R"({"k":"feed","b":2,"to":{"y":"40"},"f":"800"})"
          "\n";
  for (int radius : clearing.radii) {
    text += fmt::format(R"({{"k":"feed","b":2,"to":{{"x":"25","z":"{}"}},"f":"800"}})"
                        "\n",
                        50 + radius);
    text += fmt::format(R"({{"k":"arc","b":2,"plane":"G18","c":{{"x":"25","z":"50"}},"rot":{},)"
                        R"("to":{{"x":"25","z":"{}"}},"f":"800"}})"
                        "\n",
                        clearing.rot, 50 + radius);
  }
  text += R"({"k":"rapid","b":2,"to":{"y":"45"}})"
          "\n";
  text += R"({"k":"rapid","b":2,"to":{"x":"25","z":"50"}})"
          "\n";
  text += R"({"k":"rapid","b":2,"to":{"y":"50"}})"
          "\n";
  return text;
}

TEST(PocketJudge, ConcentricCirclesAreGo) {
  EXPECT_EQ(decision(judge_trace(kG110Pocket, trace({})).kind), Decision::go);
}

TEST(PocketJudge, ARingLeftOutIsNoGoWithAWitness) {
  Clearing clearing;
  clearing.radii = {3, 9, 12};
  const Verdict verdict = judge_trace(kG110Pocket, trace(clearing));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_region);
  EXPECT_FALSE(verdict.witness.empty());
  EXPECT_EQ(reference::clause_name(verdict.clause), "GSK-G110-09");
}

TEST(PocketJudge, TheLastCircleAtTheWallGouges) {
  Clearing clearing;
  clearing.radii = {3, 6, 9, 12, 16};
  const Verdict verdict = judge_trace(kG110Pocket, trace(clearing));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_region);
  EXPECT_FALSE(verdict.witness.empty());
  EXPECT_NE(verdict.message.find("wall"), std::string::npos);
}

TEST(PocketJudge, TheSenseTurnedIsNoGoWithAWitness) {
  Clearing clearing;
  clearing.rot = 1;
  const Verdict verdict = judge_trace(kG110Pocket, trace(clearing));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_region);
  EXPECT_FALSE(verdict.witness.empty());
}

TEST(PocketJudge, AnOffCentrePlungeIsNoGoWithAWitness) {
  Clearing clearing;
  clearing.plunge_x = "25.1";
  const Verdict verdict = judge_trace(kG110Pocket, trace(clearing));
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry);
  EXPECT_EQ(reference::clause_name(verdict.clause), "GSK-G110-06");
  EXPECT_FALSE(verdict.witness.empty());
}

// W-2 Q1: levels at Z9 and Z8. The first is passed without a cut: the second plunge shows it.
TEST(PocketJudge, ALevelWithoutACutIsLeftByTheNextPlunge) {
  constexpr std::string_view kTwoLevels =
      "G17 G00 X40 Y30 Z10\nG110 X1 Y1 W-2 I10 L1 Q1 D4 F100\n";
  TraceText trace(1, 100);
  trace.rapid({{'x', 20}, {'y', 30}, {'z', 10}}).block(2, 100);
  trace.rapid({{'x', 0.5}, {'y', 1}}).feed({{'z', 9}}).feed({{'z', 8}});
  const Verdict verdict = judge_trace(kTwoLevels, trace.text());
  EXPECT_EQ(verdict.kind, VerdictKind::fail_region);
  EXPECT_EQ(verdict.message, "The cut leaves the level's depth.");
  EXPECT_EQ(verdict.deviation_exact, "1");
}

// J-PROP-07 leaves such pockets out, but none of these is undecided: two levels a tolerance deep, a
// circle of twice the tolerance, in whole rings or in pieces, from any side, rounded or not.
TEST(PocketJudge, ConcentricCirclesOfTheLeastStepAreGo) {
  constexpr std::string_view kLeast =
      "G17 G00 X40 Y30 Z10\nG110 X1 Y1 W-0.002 I4.002 L0.001 Q0.001 D4 F100\n";
  for (const int pieces : {1, 2, 3, 8}) {
    for (int degrees = 0; degrees < 360; degrees += 15) {
      for (const int decimals : {3, 9}) {
        TraceText trace(1, 100);
        trace.rapid({{'x', 20}, {'y', 30}, {'z', 10}}).block(2, 100).decimals(decimals);
        trace.rapid({{'x', 0.5}, {'y', 1}}).feed({{'z', 9.999}});
        for (const double depth : {9.999, 9.998}) {
          if (depth < 9.999) trace.rapid({{'z', 9.999}}).feed({{'z', depth}});
          for (const double radius : {0.001, 0.002}) {
            for (int k = 0; k <= pieces; ++k) {
              const double angle = std::numbers::pi * (degrees / 180.0 - 2.0 * k / pieces);
              const double x = 0.5 + radius * std::cos(angle);
              const double y = 1 + radius * std::sin(angle);
              if (k == 0) trace.feed({{'x', x}, {'y', y}});
              if (k > 0) trace.arc("G17", {{'x', 0.5}, {'y', 1}}, -1, {{'x', x}, {'y', y}});
            }
          }
          trace.rapid({{'z', 10}}).rapid({{'x', 0.5}, {'y', 1}});
        }
        const Verdict verdict = judge_trace(kLeast, trace.text());
        EXPECT_EQ(decision(verdict.kind), Decision::go) << degrees << ": " << verdict.message;
      }
    }
  }
}

TEST(PocketJudge, ReadingsThatNameAPathJudgeThePath) {
  EXPECT_EQ(decision(judge_trace(kG110Pocket, trace({}), "gsk.pocket.path=concentric").kind),
            Decision::go);
  EXPECT_EQ(decision(judge_trace(kG110Pocket, trace({}), "gsk.pocket.path=semicircles").kind),
            Decision::no_go);
}

TEST(PocketJudge, TheEndAtTheRPlaneIsGoOnlyUnderItsReading) {
  std::string text = trace({});
  text.erase(text.rfind("{\"k\":\"rapid\""));
  EXPECT_EQ(decision(judge_trace(kG110Pocket, text).kind), Decision::no_go);
  EXPECT_EQ(decision(judge_trace(kG110Pocket, text, "gsk.pocket.end=r-plane").kind), Decision::go);
  EXPECT_EQ(decision(judge_trace(kG110Pocket, text, "gsk.pocket.end=any").kind), Decision::go);
}

}  // namespace
}  // namespace gonogo::oracle
