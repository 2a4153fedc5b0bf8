// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cases of level_test, decided by the sets of circles alone: no filter.
#include "tests/oracle/region/expectations.hpp"

namespace gonogo::oracle::region {
namespace {

LevelVerdict judge_exactly(const Job& job) {
  return judge_level_by(Method::exact_only, job.level, job.motions);
}

void expect_go(const Job& job) {
  const LevelVerdict verdict = judge_exactly(job);
  EXPECT_TRUE(is_go(job, verdict));
  EXPECT_FALSE(verdict.by_filter);
}

void expect_broken(Rule rule, const Job& job) {
  const LevelVerdict verdict = judge_exactly(job);
  EXPECT_TRUE(breaks(rule, job, verdict));
  EXPECT_FALSE(verdict.by_filter);
}

TEST(RegionExact, ConcentricCirclesAreGo) {
  expect_go(concentric(i16_l3_d4(), {3, 6, 9, 12}));
}

TEST(RegionExact, SemicircleSpiralsAreGo) {
  expect_go(semicircles(i16_l3_d4(-1)));
  expect_go(semicircles(i16_l3_d4(1)));
}

TEST(RegionExact, SemicircleSpiralMovedByThirdsIsGo) {
  expect_go(moved(semicircles(i16_l3_d4()), {mm("100/3"), mm("-200/3")}));
}

TEST(RegionExact, SpiralWithoutTheClosingCircleBreaksCover) {
  expect_broken(Rule::cover, semicircles(i16_l3_d4(), false));
}

TEST(RegionExact, OneRingLeftOutBreaksStep) {
  expect_broken(Rule::step, concentric(i16_l3_d4(), {3, 9, 12}));
}

TEST(RegionExact, TwoRingsLeftOutBreakCover) {
  expect_broken(Rule::cover, concentric(i16_l3_d4(), {3, 12}));
}

TEST(RegionExact, AMicronTooFarBreaksStep) {
  expect_broken(Rule::step, concentric(i16_l3_d4(), {mm("3.003"), 6, 9, 12}));
}

TEST(RegionExact, RingsThatJustTouchAreGo) {
  CircularLevel level = i16_l3_d4();
  level.pocket_radius = mm("16.008");
  expect_go(concentric(level, {mm("3.002"), mm("6.004"), mm("9.006"), mm("12.008")}));
}

// Radii k sqrt(2) have no rational circle: bands within them are used, and suffice.
TEST(RegionExact, IrrationalRadiiAreDecidedFromWithin) {
  CircularLevel level = i16_l3_d4();
  level.pocket_radius = 4 + 8;
  Job job{level, {}};
  for (const int k : {2, 4}) {
    line_to(job, {k, k});
    arc_to(job, {-k, -k}, {}, -1);
    arc_to(job, {k, k}, {}, -1);
  }
  circle(job, 8, {1, 0});
  expect_go(job);
}

TEST(RegionExact, ArcsOfTwoRadiiAreDecidedFromWithin) {
  Job job = semicircles(i16_l3_d4());
  for (std::size_t k = 0; k + 2 < job.motions.size(); ++k) {
    job.motions[k].centre.p += mm("0.0005");
  }
  expect_go(job);
}

}  // namespace
}  // namespace gonogo::oracle::region
