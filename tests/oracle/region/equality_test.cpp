// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sets are closed: what is just reached is reached.
#include "tests/oracle/region/expectations.hpp"

namespace gonogo::oracle::region {
namespace {

CircularLevel with_border(std::string_view border) {
  CircularLevel level = i16_l3_d4();
  level.pocket_radius = mm(border) + level.tool_radius;
  return level;
}

// Bands reach 1.501: at 3.002 apart they touch along whole circles.
TEST(RegionEquality, RingsThatJustTouchAreGo) {
  const Job job =
      concentric(with_border("12.008"), {mm("3.002"), mm("6.004"), mm("9.006"), mm("12.008")});
  EXPECT_TRUE(is_go(job));
}

// 6.004 to 9.007: the middle is 1.5015 from both, 0.0015 more than half the step.
TEST(RegionEquality, OneMicronMoreBreaksStep) {
  const Job job =
      concentric(with_border("12.009"), {mm("3.002"), mm("6.004"), mm("9.007"), mm("12.009")});
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::step, job, verdict));
  EXPECT_LE(verdict.finding->deviation, mm("0.0015"));
}

// Radii k sqrt(2): circles that begin on the diagonal. 2 sqrt(2) = 2.83 apart.
TEST(RegionEquality, IrrationalRadiiAreDecided) {
  CircularLevel level = i16_l3_d4();
  level.pocket_radius = 4 + 8;
  Job job{level, {}};
  for (const int k : {2, 4}) {
    line_to(job, {k, k});
    arc_to(job, {k, k}, {}, -1);
  }
  circle(job, 8, {1, 0});
  EXPECT_TRUE(is_go(job));
}

// Radii sqrt(2) and 3 sqrt(2), reach sqrt(2) exactly: the roots must cancel. The reach is the
// step's half plus the tolerance, so the step is a root itself.
TEST(RegionEquality, IrrationalRingsThatJustTouchAreGo) {
  CircularLevel level = i16_l3_d4();
  level.step = Number::root(mm("-0.002"), 2, 2);
  level.pocket_radius = Number::root(4, 4, 2);
  Job job{level, {}};
  for (const int k : {2, 4}) {
    line_to(job, {k, k});
    arc_to(job, {k, k}, {}, -1);
  }
  EXPECT_TRUE(is_go(job));
}

TEST(RegionEquality, ACircleAtTheBorderPlusToleranceDoesNotGouge) {
  EXPECT_TRUE(is_go(concentric(i16_l3_d4(), {3, 6, 9, mm("12.001")})));
}

TEST(RegionEquality, OneMicronBeyondGouges) {
  const Job job = concentric(i16_l3_d4(), {3, 6, 9, mm("12.002")});
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::gouge, job, verdict));
  EXPECT_EQ(verdict.finding->deviation, mm("0.002"));
}

// |(0.0006, 0.0008)| = 0.001: the circle of radius 12 about it just reaches 12.001.
TEST(RegionEquality, AnOffsetCircleThatJustReachesDoesNotGouge) {
  Job job = concentric(i16_l3_d4(), {3, 6, 9});
  line_to(job, {mm("0.0006"), mm("12.0008")});
  arc_to(job, job.motions.back().to, {mm("0.0006"), mm("0.0008")}, -1);
  EXPECT_TRUE(is_go(job));
}

TEST(RegionEquality, AnOffsetCircleAHairBeyondGouges) {
  Job job = concentric(i16_l3_d4(), {3, 6, 9});
  line_to(job, {mm("0.0006"), mm("12.000800001")});
  arc_to(job, job.motions.back().to, {mm("0.0006"), mm("0.000800001")}, -1);
  EXPECT_TRUE(breaks(Rule::gouge, job));
}

// 11.999 + 4.001 = 16: the rim itself is just reached.
TEST(RegionEquality, TheRimJustReachedIsGo) {
  EXPECT_TRUE(is_go(concentric(i16_l3_d4(), {3, 6, 9, mm("11.999")})));
}

TEST(RegionEquality, TheRimMissedByAMicronBreaksCover) {
  const Job job = concentric(i16_l3_d4(), {3, 6, 9, mm("11.998")});
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::cover, job, verdict));
  EXPECT_LE(verdict.finding->deviation, mm("0.002"));
}

// The plunge disc touches the first band on a circle; 3.003 leaves a slit of 0.001.
TEST(RegionEquality, TheFirstRingIsMeasuredFromThePlunge) {
  EXPECT_TRUE(is_go(concentric(i16_l3_d4(), {mm("3.002"), 6, 9, 12})));
  EXPECT_TRUE(breaks(Rule::step, concentric(i16_l3_d4(), {mm("3.003"), 6, 9, 12})));
}

// Apart or overlapping by 5e-10, less than the filter looks for: a gap at worst, never the
// opposite.
TEST(RegionEquality, HalfANanometreIsNeverGuessed) {
  const auto with = [](std::string_view second) {
    return concentric(with_border("12.008"), {mm("3.002"), mm(second), mm("9.006"), mm("12.008")});
  };
  EXPECT_NE(judge(with("6.0040000005")).kind, LevelVerdict::Kind::go);
  Job overlapping = with("6.004");
  overlapping.motions[2].to.p = overlapping.motions[3].from.p = mm("6.0039999995");
  overlapping.motions[3].to.p = mm("6.0039999995");
  overlapping.level.tolerance = mm("0.00100000025");
  EXPECT_NE(judge(overlapping).kind, LevelVerdict::Kind::no_go);
}

// Pitch 3.002: bands of one side touch along half circles, those of the two sides meet in points.
TEST(RegionEquality, ASpiralThatJustTouchesItselfIsGo) {
  CircularLevel wide = with_border("12.008");
  wide.step = mm("3.002");
  Job job = semicircles(wide);
  job.level.step = 3;
  const LevelVerdict verdict = judge(job);
  EXPECT_TRUE(is_go(job, verdict));
  EXPECT_FALSE(verdict.by_filter);  // the points are beyond intervals
}

TEST(RegionEquality, ASpiralOneMicronWiderBreaksStep) {
  CircularLevel wide = with_border("12.012");
  wide.step = mm("3.003");
  Job job = semicircles(wide);
  job.level.step = 3;
  EXPECT_TRUE(breaks(Rule::step, job));
}

}  // namespace
}  // namespace gonogo::oracle::region
