// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/oracle/region/expectations.hpp"

namespace gonogo::oracle::region {
namespace {

// The bands of 0, 3, 6, 9, 12 reach 1.501 to either side: they overlap by 0.002.
TEST(Region, ConcentricCirclesAStepApartAreGo) {
  const Job job = concentric(i16_l3_d4(), {3, 6, 9, 12});
  EXPECT_TRUE(is_go(job));
  EXPECT_TRUE(judge(job).by_filter);
}

TEST(Region, SemicircleSpiralIsGoClockwise) {
  const Job job = semicircles(i16_l3_d4(-1));
  ASSERT_EQ(job.motions.size(), 9U);  // 1.5, -3, 4.5, ... -12 and the circle
  EXPECT_EQ(job.motions[7].to.p, Number(-12));
  EXPECT_TRUE(is_go(job));
  EXPECT_TRUE(judge(job).by_filter);
}

TEST(Region, SemicircleSpiralIsGoCounterclockwise) {
  EXPECT_TRUE(is_go(semicircles(i16_l3_d4(1))));
}

// The spiral ends at (-12, 0), having come by (10.5, 0): the rim at (16, 0) is 5.5 away.
TEST(Region, SpiralWithoutTheClosingCircleBreaksCover) {
  EXPECT_TRUE(breaks(Rule::cover, semicircles(i16_l3_d4(), false)));
}

// I10 L3 D2: E has radius 8, the last semicircle runs from 7.5 to -8.
TEST(Region, SpiralWhoseLastStepIsClippedIsGo) {
  CircularLevel level = i16_l3_d4();
  level.pocket_radius = 10;
  level.tool_radius = 2;
  const Job job = semicircles(level);
  ASSERT_EQ(job.motions.size(), 7U);
  EXPECT_EQ(job.motions[5].to.p, Number(-8));
  EXPECT_TRUE(is_go(job));
}

// The centre lies ten million kilometres off, beyond what enclosures in doubles tell apart, and the
// radii differ: neither NO-GO for gouge, since both ends are within, nor GO.
TEST(Region, ASpiralAboutACentreBeyondAllDoublesIsUndecided) {
  Job job = concentric(i16_l3_d4(), {3, 6, 9, 12});
  const PlanePoint here = job.motions.back().to;
  arc_to(job, {here.p - 1, here.q - 1}, {mm("1e13"), 0}, -1);
  const LevelVerdict verdict = judge(job);
  EXPECT_EQ(verdict.kind, LevelVerdict::Kind::gap) << verdict.gap;
}

// Between 3 and 9 the middle is 3 from both, 1.5 more than half the step. The tool still cleans it.
// J-PKT-02
TEST(Region, OneRingLeftOutBreaksStep) {
  const Job job = concentric(i16_l3_d4(), {3, 9, 12});
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::step, job, verdict));
  EXPECT_LE(verdict.finding->deviation, mm("1.5"));
  EXPECT_GE(verdict.finding->deviation, mm("1.49"));
}

// From 3 to 12 the tool leaves 7 to 8.
// J-PKT-02
TEST(Region, TwoRingsLeftOutBreakCover) {
  const Job job = concentric(i16_l3_d4(), {3, 12});
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::cover, job, verdict));
  EXPECT_LE(verdict.finding->deviation, mm("0.5"));
  EXPECT_GE(verdict.finding->deviation, mm("0.49"));
}

// The circle of radius 16 lies 16 - 12 outside.
// J-PKT-02
TEST(Region, LastCircleAtThePocketRadiusGouges) {
  const Job job = concentric(i16_l3_d4(), {3, 6, 9, 12, 16});
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::gouge, job, verdict));
  EXPECT_EQ(verdict.finding->deviation, mm("4"));
  EXPECT_EQ(verdict.finding->record, 8U);  // the line to the circle already
}

TEST(Region, AnArcTheWrongWayBreaksSense) {
  Job job = concentric(i16_l3_d4(), {3, 6, 9, 12});
  job.motions[5].rot = 1;
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::sense, job, verdict));
  EXPECT_EQ(verdict.finding->record, 5U);
}

TEST(Region, SenseComesBeforeGouge) {
  Job job = concentric(i16_l3_d4(), {16, 3});
  job.motions[3].rot = 1;
  EXPECT_TRUE(breaks(Rule::sense, job));
}

TEST(Region, AnArcThatGoesNowhereHasNoSense) {
  Job job = concentric(i16_l3_d4(), {3, 6, 9, 12});
  arc_to(job, {12, 0}, {12, 0}, 1);
  EXPECT_TRUE(is_go(job));
}

// Its circle about (0.1, 0) reaches 12.1.
TEST(Region, SpiralBesideTheCentreGouges) {
  Job job = moved(semicircles(i16_l3_d4()), {mm("0.1"), 0});
  job.level.centre = {0, 0};
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::gouge, job, verdict));
}

// On the other side the circle about (0.1, 0) of radius 11.9 is 4.2 from the rim: 0.2 too far.
TEST(Region, ClosingCircleBesideTheCentreBreaksCover) {
  Job job = concentric(i16_l3_d4(), {3, 6, 9, mm("11.9")});
  job.motions.pop_back();
  line_to(job, {12, 0});
  arc_to(job, {12, 0}, {mm("0.1"), 0}, -1);
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::cover, job, verdict));
  EXPECT_LE(verdict.finding->deviation, mm("0.2"));
}

// An arc bulges out between its ends: centre (3, 0), radius 10, ends at (3, +-10), 10.44 out.
TEST(Region, AnArcThatLeavesBetweenItsEndsGouges) {
  Job job = concentric(i16_l3_d4(1), {3, 6, 9, 12});
  line_to(job, {3, -10});
  arc_to(job, {3, 10}, {3, 0}, 1);
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::gouge, job, verdict));
  EXPECT_EQ(verdict.finding->witness.p, Number(13));
  EXPECT_EQ(verdict.finding->witness.q, Number(0));
  EXPECT_EQ(verdict.finding->deviation, mm("1"));
}

// The same ends the other way round stay within: the far point is (-7, 0).
TEST(Region, AnArcThatBulgesInwardDoesNotGouge) {
  Job job = concentric(i16_l3_d4(-1), {3, 6, 9, 12});
  line_to(job, {3, -10});
  arc_to(job, {3, 10}, {3, 0}, -1);
  EXPECT_TRUE(is_go(job));
}

// J-PKT-02
TEST(Region, StraightMotionsDoNotClear) {
  Job job = concentric(i16_l3_d4(), {3, 9, 12});
  for (int k = 0; k < 4; ++k) line_to(job, {k % 2 == 0 ? 6 : -6, k < 2 ? 2 : -2});
  EXPECT_TRUE(breaks(Rule::step, job));
}

// Without the plunge point the middle is 3 from the first ring.
TEST(Region, ThePlungePointCountsAndOnlyWhereItIs) {
  Job job = concentric(i16_l3_d4(), {3, 6, 9, 12});
  job.level.plunge = {3, 0};
  EXPECT_TRUE(breaks(Rule::step, job));
}

TEST(Region, NoArcAtAllBreaksCover) {
  EXPECT_TRUE(breaks(Rule::cover, Job{i16_l3_d4(), {}}));
}

TEST(Region, MoreMotionsThanTheLimitAreAGap) {
  const std::vector<LevelMotion> motions(kMostMotions + 1);
  EXPECT_EQ(judge_level(i16_l3_d4(), motions).kind, LevelVerdict::Kind::gap);
}

}  // namespace
}  // namespace gonogo::oracle::region
