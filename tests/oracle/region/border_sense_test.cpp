// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which motions have a direction: those along the border of the reachable area.
#include "tests/oracle/region/pocket_expectations.hpp"

namespace gonogo::oracle::region {
namespace {

// E reaches 24.25 and 14.25, with corners of 2.25 about (22, 12); counterclockwise, cleared.
Pocket cleared() {
  Pocket job = pocket("60", "40", "8", "5", "0.75");
  contour_parallel(job, 4);
  return job;
}

Pocket with_line(const PlanePoint& from, const PlanePoint& to) {
  Pocket job = cleared();
  line_to(job, {from.p / Number(2), from.q / Number(2)});
  line_to(job, from);
  line_to(job, to);
  return job;
}

// Counterclockwise is to the right along the lower side, upward along the right one.
TEST(BorderSense, ALineBackAlongASideBreaksSense) {
  EXPECT_TRUE(is_go(with_line({0, mm("-14.25")}, {10, mm("-14.25")})));
  const Pocket job = with_line({10, mm("-14.25")}, {0, mm("-14.25")});
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::sense, job, verdict));
  EXPECT_EQ(verdict.finding->record, job.motions.size() - 1);
  EXPECT_EQ(verdict.finding->witness.p, Number(10));
  EXPECT_EQ(verdict.finding->deviation, Number());
}

TEST(BorderSense, EverySideHasItsDirection) {
  EXPECT_TRUE(is_go(with_line({mm("24.25"), -5}, {mm("24.25"), 5})));
  EXPECT_TRUE(breaks(Rule::sense, with_line({mm("24.25"), 5}, {mm("24.25"), -5})));
  EXPECT_TRUE(is_go(with_line({5, mm("14.25")}, {-5, mm("14.25")})));
  EXPECT_TRUE(breaks(Rule::sense, with_line({-5, mm("14.25")}, {5, mm("14.25")})));
  EXPECT_TRUE(is_go(with_line({mm("-24.25"), 5}, {mm("-24.25"), -5})));
  EXPECT_TRUE(breaks(Rule::sense, with_line({mm("-24.25"), -5}, {mm("-24.25"), 5})));
}

// Near the right end of a long side, aslant by a hair: the line from the centre would mislead.
TEST(BorderSense, TheDirectionIsThatOfTheSideNotOfTheRayFromTheCentre) {
  EXPECT_TRUE(is_go(with_line({21, mm("-14.2495")}, {22, mm("-14.25")})));
  EXPECT_TRUE(is_go(with_line({21, mm("-14.25")}, {22, mm("-14.2495")})));
  EXPECT_TRUE(breaks(Rule::sense, with_line({22, mm("-14.2495")}, {20, mm("-14.25")})));
}

TEST(BorderSense, WithinTheToleranceIsAlongBeyondItIsNot) {
  EXPECT_TRUE(breaks(Rule::sense, with_line({10, mm("-14.249")}, {0, mm("-14.249")})));
  EXPECT_TRUE(breaks(Rule::sense, with_line({10, mm("-14.251")}, {0, mm("-14.251")})));
  EXPECT_TRUE(is_go(with_line({10, mm("-14.248999")}, {0, mm("-14.248999")})));
}

TEST(BorderSense, OneEndAwayFromTheBorderIsNotAlong) {
  EXPECT_TRUE(is_go(with_line({10, mm("-14.25")}, {0, mm("-14.248")})));
}

// A chord from side to side across the corner leaves the border between its ends.
TEST(BorderSense, AChordThatLeavesTheBorderIsNotAlong) {
  EXPECT_TRUE(is_go(with_line({22, mm("-14.25")}, {mm("24.25"), -12})));
  EXPECT_TRUE(is_go(with_line({mm("24.25"), -12}, {22, mm("-14.25")})));
}

// J-PKT-06: 1.25, a quarter of the tool's radius, and the tolerance of 0.001.
TEST(BorderSense, TheBorderLeadsBackByAQuarterOfTheToolsRadiusAtMost) {
  EXPECT_TRUE(is_go(with_line({10, mm("-14.25")}, {mm("8.75"), mm("-14.25")})));
  EXPECT_TRUE(is_go(with_line({10, mm("-14.25")}, {mm("8.7495"), mm("-14.25")})));
  EXPECT_TRUE(breaks(Rule::sense, with_line({10, mm("-14.25")}, {mm("8.7485"), mm("-14.25")})));
}

// Back by 1 in one line or in three, forth by 0.5, and back by 0.7 or 0.8 once more.
TEST(BorderSense, WhatLeadsForthAgainIsNotBack) {
  for (const bool is_split : {false, true}) {
    for (const auto& [end, goes] : {std::pair("8.8", true), std::pair("8.7", false)}) {
      Pocket job = with_line({0, mm("-14.25")}, {10, mm("-14.25")});
      if (is_split) {
        line_to(job, {mm("9.7"), mm("-14.25")});
        line_to(job, {mm("9.4"), mm("-14.25")});
      }
      line_to(job, {9, mm("-14.25")});
      line_to(job, {mm("9.5"), mm("-14.25")});
      line_to(job, {mm(end), mm("-14.25")});
      EXPECT_TRUE(goes ? is_go(job) : breaks(Rule::sense, job)) << end;
    }
  }
}

// On the border of radius 15 of a round pocket: (0.96, 0.28) and (0.9984, 0.0566) lie 0.2838 and
// 0.0566 rad from (1, 0), which is 4.26 and 0.85 along it.
TEST(BorderSense, OnARoundBorderTheWayAlongTheArcCounts) {
  const auto back_from = [](const PlanePoint& from) {
    Pocket job = pocket("40", "40", "20", "5", "0");
    contour_parallel(job, 4);
    line_to(job, {0, 0});
    line_to(job, from);
    arc_to(job, {15, 0}, {}, -1);
    return job;
  };
  EXPECT_TRUE(breaks(Rule::sense, back_from({mm("14.4"), mm("4.2")})));
  // 0.0566 = 2 * 0.0283 / (1 + 0.0283^2), so that both places lie on the circle.
  const Number t = mm("0.0283");
  const Number part = Number(15) / (Number(1) + t * t);
  EXPECT_TRUE(is_go(back_from({part * (Number(1) - t * t), part * Number(2) * t})));
}

TEST(BorderSense, ACornerArcTheWrongWayBreaksSense) {
  Pocket job = cleared();
  line_to(job, {22, mm("14.25")});
  arc_to(job, {mm("24.25"), 12}, {22, 12}, -1);
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::sense, job, verdict));
  EXPECT_EQ(verdict.finding->record, job.motions.size() - 1);
}

// Turning the same way about another centre, off the border.
TEST(BorderSense, AnArcThatOnlyTouchesTheBorderHasNoDirection) {
  Pocket job = cleared();
  line_to(job, {mm("22.25"), 0});
  arc_to(job, job.motions.back().to, {mm("23.25"), 0}, -1);
  EXPECT_TRUE(is_go(job));
}

// A flat arc that stays within the tolerance of the lower side: sagitta 1 / (2 * 1000) = 0.0005.
// It turns clockwise about a centre far below and runs the right way all the same.
TEST(BorderSense, AFlatArcGoesAsItRunsNotAsItTurns) {
  Pocket job = cleared();
  line_to(job, {-1, 0});
  line_to(job, {-1, mm("-14.25")});
  const PlanePoint below{0, mm("-1014.25")};
  arc_to(job, {1, mm("-14.25")}, below, -1);
  EXPECT_TRUE(is_go(job));
  arc_to(job, {-1, mm("-14.25")}, below, 1);
  EXPECT_TRUE(breaks(Rule::sense, job));
}

// The border of a round pocket, in one turn.
TEST(BorderSense, AWholeTurnGoesAsItTurns) {
  Pocket job = pocket("40", "40", "20", "5", "0");
  contour_parallel(job, 4);
  line_to(job, {15, 0});
  arc_to(job, {15, 0}, {}, 1);
  EXPECT_TRUE(is_go(job));
  job.motions.back().rot = -1;
  EXPECT_TRUE(breaks(Rule::sense, job));
  job.motions.back().rot = -3;
  EXPECT_TRUE(breaks(Rule::sense, job));
}

// J-PKT-06: no motion runs along the border, for each leads 0.01 or 0.025 away from it, but the row
// does. Upward along the right side is counterclockwise.
TEST(BorderSense, SmallMotionsThatTouchTheBorderGoAsTheirRow) {
  for (const bool round : {false, true}) {
    for (const int side : {1, -1}) {
      Pocket job = cleared();
      line_to(job, {mm("24.25"), 0});
      for (int k = 1; k <= 40; ++k) {
        const Number q = Number(side * k) / Number(20);
        const Number middle = q - Number(side) / Number(40);
        if (round) {
          arc_to(job, {mm("24.25"), q}, {mm("24.25"), middle}, -side);
        } else {
          line_to(job, {mm("24.24"), middle});
          line_to(job, {mm("24.25"), q});
        }
      }
      EXPECT_TRUE(side > 0 ? is_go(job) : breaks(Rule::sense, job)) << round;
    }
  }
}

// A turn whose end was rounded away from its start, the wrong way: it may be no motion at all.
TEST(BorderSense, AnEndATinyWayFromTheStartIsReadAsItFits) {
  Pocket job = pocket("40", "40", "20", "5", "0");
  contour_parallel(job, 4);
  line_to(job, {15, 0});
  arc_to(job, {15, mm("0.001")}, {}, -1);
  EXPECT_TRUE(is_go(job));
}

// E is 0.002 wide: a path in it runs along both sides; at 0.003 it does not.
TEST(BorderSense, ABorderNoWiderThanTheToleranceHasNoDirection) {
  for (const std::string_view width : {"10.002", "10.003"}) {
    Pocket job = pocket("60", width, "5", "5", "0");
    finish(job);
    EXPECT_TRUE(is_go(job));
    job.level.sense = -1;
    EXPECT_EQ(judge(job).kind,
              width == "10.002" ? LevelVerdict::Kind::go : LevelVerdict::Kind::no_go);
  }
}

TEST(BorderSense, SenseComesBeforeGouge) {
  Pocket job = with_line({10, mm("-14.25")}, {0, mm("-14.25")});
  line_to(job, {0, -20});
  EXPECT_TRUE(breaks(Rule::sense, job));
}

}  // namespace
}  // namespace gonogo::oracle::region
