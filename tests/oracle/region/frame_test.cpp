// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turned pockets: exact where the angle allows it, else with a bound that holds.
#include "oracle/region/frame.hpp"

#include "tests/oracle/region/pocket_expectations.hpp"

namespace gonogo::oracle::region {
namespace {

TEST(RegionFrame, ARationalAngleIsExact) {
  const PocketFrame frame = make_frame({3, mm("0.5")}, mm("0.6"), mm("0.8"));
  EXPECT_EQ(frame.turn, Number());
  EXPECT_EQ(frame.shift, Number());
  EXPECT_EQ(slack_of(frame, {22, 12, 8}), Number());
  // (4, 7) - (3, 0.5) = (1, 6.5): 0.6 + 0.8 * 6.5 along, 0.6 * 6.5 - 0.8 aside.
  const PlanePoint point = into(frame, PlanePoint{4, 7});
  EXPECT_EQ(point.p, mm("5.8"));
  EXPECT_EQ(point.q, mm("3.1"));
  const PlanePoint back = out_of(frame, point);
  EXPECT_EQ(back.p, Number(4));
  EXPECT_EQ(back.q, Number(7));
}

TEST(RegionFrame, TheMotionsCentreIsTurnedToo) {
  const PocketFrame frame = make_frame({}, 0, 1);
  LevelMotion motion;
  motion.is_arc = true;
  motion.from = {1, 0};
  motion.to = {0, 1};
  motion.centre = {0, -2};
  motion.rot = 2;
  const LevelMotion turned = into(frame, motion);
  EXPECT_EQ(turned.from.q, Number(-1));
  EXPECT_EQ(turned.to.p, Number(1));
  EXPECT_EQ(turned.centre.p, Number(-2));
  EXPECT_EQ(turned.rot, 2);
}

class AnyAngle : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(RegionFrame, AnyAngle,
                         testing::Values(1, 17, 30, 45, 60, 89, 91, 135, 150, 179, 181, 225, 269,
                                         271, 300, 359));

TEST_P(AnyAngle, TheRotationIsRationalAndNearTheTrueOne) {
  const auto [cos, sin] = exact::cos_sin_degrees(GetParam());
  const PocketFrame frame = make_frame({}, cos, sin);
  ASSERT_TRUE(frame.cos.is_rational() && frame.sin.is_rational());
  EXPECT_EQ(frame.cos * frame.cos + frame.sin * frame.sin, Number(1));
  // The bound holds for the two unit vectors, and is well below a nanometre over a metre.
  const Number dc = frame.cos - cos;
  const Number ds = frame.sin - sin;
  EXPECT_LE(dc * dc + ds * ds, frame.turn * frame.turn);
  EXPECT_LT(frame.turn, mm("1e-12"));
  EXPECT_EQ(frame.shift, Number());
}

TEST_P(AnyAngle, APointComesNoFartherFromItsTruePlaceThanTheSlack) {
  const auto [cos, sin] = exact::cos_sin_degrees(GetParam());
  // The centre (40, 30) of a pocket in a frame that is turned about the origin.
  const PlanePoint centre{Number(40) * cos - Number(30) * sin, Number(40) * sin + Number(30) * cos};
  const PocketFrame frame = make_frame(centre, cos, sin);
  const PlanePoint base{mm("12.345"), mm("67.891")};
  const PlanePoint got = into(frame, base);
  const Number p = cos * base.p + sin * base.q - Number(40) - got.p;
  const Number q = cos * base.q - sin * base.p - Number(30) - got.q;
  const Number slack = frame.slack(200);
  EXPECT_TRUE(got.p.is_rational() && got.q.is_rational());
  EXPECT_LE(p * p + q * q, slack * slack);
  EXPECT_LT(slack, mm("1e-9"));
}

TEST(RegionFrame, TwoNumbersOfNoAngleAreRefused) {
  EXPECT_THROW(make_frame({}, mm("0.6"), mm("0.81")), std::domain_error);
}

// 22 and 12 and twice 7.25, times the turn.
TEST(RegionFrame, TheSlackOfALevelCoversTheWholeArea) {
  PocketFrame frame;
  frame.turn = mm("1e-12");
  frame.shift = mm("1e-15");
  EXPECT_EQ(slack_of(frame, {22, 12, mm("7.25")}), mm("48.501e-12"));
}

// E reaches to 14.25; tolerance 0.001, slack 0.0004.
Pocket poking_through_the_side(std::string_view beyond) {
  Pocket job = pocket("60", "40", "8", "5", "0.75");
  job.level.slack = mm("0.0004");
  contour_parallel(job, 4);
  line_to(job, {0, mm("-14.25") - mm(beyond)});
  return job;
}

TEST(RegionSlack, AGougeMustShowWhicheverWayThePointsMayBeOff) {
  EXPECT_EQ(judge(poking_through_the_side("0.0006")).kind, LevelVerdict::Kind::go);
  EXPECT_EQ(judge(poking_through_the_side("0.00061")).kind, LevelVerdict::Kind::gap);
  EXPECT_EQ(judge(poking_through_the_side("0.0014")).kind, LevelVerdict::Kind::gap);
  const Pocket job = poking_through_the_side("0.0015");
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::gouge, job, verdict));
  EXPECT_EQ(verdict.finding->deviation, mm("0.0015"));
}

Pocket sides_apart_with_slack(std::string_view width) {
  Pocket job = sides_apart(width);
  job.level.slack = mm("0.0004");
  return job;
}

TEST(RegionSlack, AHoleMustShowWhicheverWayThePointsMayBeOff) {
  EXPECT_EQ(judge(sides_apart_with_slack("20.0012")).kind, LevelVerdict::Kind::go);
  EXPECT_EQ(judge(sides_apart_with_slack("20.0014")).kind, LevelVerdict::Kind::gap);
  EXPECT_EQ(judge(sides_apart_with_slack("20.0028")).kind, LevelVerdict::Kind::gap);
  const Pocket job = sides_apart_with_slack("20.003");
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::cover, job, verdict));
  EXPECT_EQ(verdict.finding->deviation.decimal_text(6), "0.001500");
}

Pocket back_along(std::string_view q) {
  Pocket job = pocket("60", "40", "8", "5", "0.75");
  job.level.slack = mm("0.0004");
  contour_parallel(job, 4);
  line_to(job, {10, 0});
  line_to(job, {10, mm(q)});
  line_to(job, {0, mm(q)});
  return job;
}

TEST(RegionSlack, AWrongWayMustShowWhicheverWayThePointsMayBeOff) {
  const Pocket job = back_along("-14.2496");
  EXPECT_TRUE(breaks(Rule::sense, job));
  EXPECT_EQ(judge(back_along("-14.249")).kind, LevelVerdict::Kind::gap);
  EXPECT_EQ(judge(back_along("-14.248")).kind, LevelVerdict::Kind::go);
}

TEST(RegionSlack, ASlackAsLargeAsTheToleranceIsAGap) {
  Pocket job = pocket("10", "10", "5", "5", "0");
  job.level.slack = job.level.tolerance;
  EXPECT_EQ(judge(job).kind, LevelVerdict::Kind::gap);
}

}  // namespace
}  // namespace gonogo::oracle::region
