// SPDX-License-Identifier: GPL-3.0-or-later
//
// Levels of pockets with rounded corners.
#include "tests/oracle/region/pocket_expectations.hpp"

namespace gonogo::oracle::region {
namespace {

// 60 x 40, corners 8, tool 5, allowance 0.75: the area has half sides 29.25 and 19.25 and corners
// of 7.25, its core 22 and 12; E reaches 24.25 and 14.25, with corners of 2.25.
Pocket rectangle() {
  return pocket("60", "40", "8", "5", "0.75");
}
// R119 = 2 R120. E: the line from -22 to 22, grown by 2.25.
Pocket slot() {
  return pocket("60", "16", "8", "5", "0.75");
}
Pocket round() {
  return pocket("40", "40", "20", "5", "0.75");
}

class EveryShape : public testing::TestWithParam<Pocket (*)()> {};
INSTANTIATE_TEST_SUITE_P(PocketRegion, EveryShape, testing::Values(rectangle, slot, round));

TEST_P(EveryShape, ClearedInRowsIsGo) {
  Pocket job = GetParam()();
  zigzag(job, 4);
  EXPECT_TRUE(is_go(job));
  EXPECT_TRUE(judge(job).by_filter);
}

TEST_P(EveryShape, ClearedFromInsideIsGo) {
  Pocket job = GetParam()();
  contour_parallel(job, 4);
  EXPECT_TRUE(is_go(job));
  EXPECT_TRUE(judge(job).by_filter);
}

TEST_P(EveryShape, ClearedInCirclesIsGo) {
  Pocket job = GetParam()();
  trochoidal(job, 2, 3);
  EXPECT_TRUE(is_go(job));
  EXPECT_TRUE(judge(job).by_filter);
}

// The circles turn counterclockwise all the same: only the border has a sense.
TEST_P(EveryShape, ClearedClockwiseIsGo) {
  Pocket job = GetParam()();
  job.level.sense = -1;
  trochoidal(job, 2, 3);
  EXPECT_TRUE(is_go(job));
}

TEST_P(EveryShape, TheBorderTheWrongWayBreaksSense) {
  Pocket job = GetParam()();
  contour_parallel(job, 4);
  job.level.sense = -1;
  EXPECT_TRUE(breaks(Rule::sense, job));
}

TEST_P(EveryShape, WithoutTheBorderCoverIsBroken) {
  Pocket job = GetParam()();
  zigzag(job, 4);
  const std::size_t rows = job.motions.size();
  finish(job);
  const std::size_t border = job.motions.size() - rows;
  job.motions.resize(rows - border);
  EXPECT_TRUE(breaks(Rule::cover, job));
}

// The path of allowance 0 reaches 0.75 farther.
TEST_P(EveryShape, TheAllowanceForgottenGouges) {
  Pocket job = GetParam()();
  Pocket full = job;
  full.level.area.radius += mm("0.75");
  zigzag(full, 4);
  job.motions = full.motions;
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::gouge, job, verdict));
}

TEST_P(EveryShape, TheAllowanceLeftBreaksCover) {
  Pocket job = GetParam()();
  zigzag(job, 4);
  job.level.area.radius += mm("0.75");
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::cover, job, verdict));
  EXPECT_EQ(verdict.finding->deviation.decimal_text(3), "0.750");
}

// Rings 12 and 0 inside the border: 12 - 2 * 5 is left along the sides, more in the corners.
TEST(PocketRegion, ARingLeftOutBreaksCover) {
  Pocket job = rectangle();
  go_round(job, *eroded(border_of(job), 12), 1);
  finish(job);
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::cover, job, verdict));
  EXPECT_GE(verdict.finding->deviation, mm("0.99"));
}

TEST(PocketRegion, NoMotionAtAllBreaksCover) {
  EXPECT_TRUE(breaks(Rule::cover, rectangle()));
}

// The chord of the corner arc: 7.25 - 2.25 cos 45 = 5.65901 from the area's corner.
TEST(PocketRegion, ACornerCutShortBreaksCover) {
  Pocket job = rectangle();
  contour_parallel(job, 4);
  LevelMotion& corner = job.motions[job.motions.size() - 6];
  ASSERT_TRUE(corner.is_arc);
  corner.is_arc = false;
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::cover, job, verdict));
  EXPECT_LE(verdict.finding->deviation, mm("0.6591"));
  EXPECT_GE(verdict.finding->deviation, mm("0.2"));
}

// Out of the corner's centre (22, 12) along (0.6, 0.8), to 2.25 and a bit.
Pocket poking_into_the_corner(std::string_view beyond) {
  Pocket job = rectangle();
  contour_parallel(job, 4);
  const Number far = mm("2.25") + mm(beyond);
  line_to(job, {22, 12});
  line_to(job, {Number(22) + mm("0.6") * far, Number(12) + mm("0.8") * far});
  return job;
}

TEST(PocketRegion, ACornerGougedByTwiceTheToleranceBreaksGouge) {
  const Pocket job = poking_into_the_corner("0.002");
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::gouge, job, verdict));
  EXPECT_EQ(verdict.finding->deviation, mm("0.002"));
  EXPECT_EQ(verdict.finding->record, job.motions.size() - 1);
}

TEST(PocketRegion, ACornerGougedByHalfTheToleranceIsGo) {
  EXPECT_TRUE(is_go(poking_into_the_corner("0.0005")));
}

TEST(PocketRegion, ACornerGougedByTheToleranceIsGo) {
  EXPECT_TRUE(is_go(poking_into_the_corner("0.001")));
  EXPECT_TRUE(breaks(Rule::gouge, poking_into_the_corner("0.001000000001")));
}

// The corner arc about (22, 12) + e (0.6, 0.8), between its ends e farther out than it should be.
Pocket with_corner_aside(const Number& e) {
  Pocket job = rectangle();
  contour_parallel(job, 4);
  const PlanePoint centre{Number(22) + mm("0.6") * e, Number(12) + mm("0.8") * e};
  line_to(job, {centre.p + mm("2.25"), centre.q});
  arc_to(job, {centre.p, centre.q + mm("2.25")}, centre, 1);
  return job;
}

TEST(PocketRegion, AnArcThatGougesBetweenItsEndsBreaksGouge) {
  const Pocket job = with_corner_aside(mm("0.0012"));
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::gouge, job, verdict));
  EXPECT_EQ(verdict.finding->deviation, mm("0.0012"));
  EXPECT_EQ(verdict.finding->witness.p, Number(22) + mm("0.6") * mm("2.2512"));
  EXPECT_TRUE(is_go(with_corner_aside(mm("0.001"))));
}

// A half circle of radius 3 about (21.26, 0) bulges over the side at 24.25 by 0.01.
TEST(PocketRegion, AnArcThatBulgesOverASideBreaksGouge) {
  Pocket job = rectangle();
  contour_parallel(job, 4);
  line_to(job, {mm("21.26"), -3});
  arc_to(job, {mm("21.26"), 3}, {mm("21.26"), 0}, 1);
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::gouge, job, verdict));
  EXPECT_EQ(verdict.finding->deviation, mm("0.01"));
  job.motions.back().rot = -1;
  EXPECT_TRUE(is_go(job));
}

// Slots and circles of the tool's width: the border is a line or a point, without direction.
TEST(PocketRegion, ALineForthAndBackHasNoSense) {
  for (const int sense : {1, -1}) {
    Pocket job = pocket("60", "10", "5", "5", "0");
    job.level.sense = sense;
    go_round(job, border_of(job), 1);
    EXPECT_TRUE(is_go(job));
  }
}

TEST(PocketRegion, ThePlungeAloneClearsAPocketOfTheToolsSize) {
  EXPECT_TRUE(is_go(pocket("10", "10", "5", "5", "0")));
}

TEST(PocketRegion, AToolLargerThanTheCornersLeavesLargerCorners) {
  Pocket job = pocket("60", "40", "2", "5", "0");
  EXPECT_EQ(border_of(job).radius, Number());
  contour_parallel(job, 4);
  EXPECT_TRUE(is_go(job));
}

TEST(PocketRegion, AToolTooLargeForThePocketIsAGap) {
  Pocket job = rectangle();
  job.level.tool_radius = mm("7.26");
  EXPECT_EQ(judge(job).kind, LevelVerdict::Kind::gap);
}

TEST(PocketRegion, MoreMotionsThanTheLimitAreAGap) {
  Pocket job = rectangle();
  job.motions.resize(kMostMotions + 1);
  EXPECT_EQ(judge(job).kind, LevelVerdict::Kind::gap);
}

// Motions of no length, and lines of a micron, before the border.
TEST(PocketRegion, MotionsOfAlmostNoLengthChangeNothing) {
  Pocket job = rectangle();
  contour_parallel(job, 4);
  line_to(job, job.motions.back().to);
  line_to(job, {mm("-0.001"), mm("-14.25")});
  line_to(job, {mm("0.0000000001"), mm("-14.25")});
  arc_to(job, {mm("-0.0005"), mm("-14.25")}, {0, -20}, -1);
  EXPECT_TRUE(is_go(job));
}

}  // namespace
}  // namespace gonogo::oracle::region
