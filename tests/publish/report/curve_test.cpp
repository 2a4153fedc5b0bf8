// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "publish/report/path.hpp"

namespace gonogo::oracle::report {
namespace {

using reference::Axis;
using reference::Number;
using reference::Plane;
using reference::Position;
using reference::Record;
using reference::RecordKind;

constexpr double kClose = 1e-9;
const double kHalfRoot = std::sqrt(0.5);

void expect_at(const Point3& point, double x, double y, double z) {
  EXPECT_NEAR(point.x, x, kClose);
  EXPECT_NEAR(point.y, y, kClose);
  EXPECT_NEAR(point.z, z, kClose);
}

std::vector<Point3> arc(const Point3& from, const Point3& to, const ArcShape& shape) {
  return sample_arc(from, to, shape, kMaxSegments);
}

Record rapid_x(const Number& x) {
  Record record;
  record.axes = {Axis::x};
  record.to[Axis::x] = x;
  return record;
}

Path sample_path(const Position& start, const std::vector<Record>& records,
                 std::size_t max_segments = kMaxSegments) {
  PathSampler sampler(start, max_segments);
  for (const Record& record : records) {
    if (!sampler.add(record)) break;
  }
  return sampler.take();
}

// A quarter of 128 steps: 32. Half of it stands at 45 degrees: (10 / sqrt 2, 10 / sqrt 2).
TEST(SampleArc, quarter_counterclockwise_passes_45_degrees) {
  const auto points = arc({10, 0, 0}, {0, 10, 0}, {Plane::g17, {0, 0}, 1});
  ASSERT_EQ(points.size(), 33U);
  expect_at(points[16], 10 * kHalfRoot, 10 * kHalfRoot, 0);
}

// The same ends clockwise: three quarters; half of it stands at -135 degrees.
TEST(SampleArc, same_ends_clockwise_go_the_other_way_round) {
  const auto points = arc({10, 0, 0}, {0, 10, 0}, {Plane::g17, {0, 0}, -1});
  ASSERT_EQ(points.size(), 97U);
  expect_at(points[48], -10 * kHalfRoot, -10 * kHalfRoot, 0);
}

// End = start: one full turn; half of it is opposite.
TEST(SampleArc, end_at_start_is_a_full_turn) {
  const auto points = arc({3, 5, 0}, {3, 5, 0}, {Plane::g17, {1, 5}, -1});
  ASSERT_EQ(points.size(), 129U);
  expect_at(points[64], -1, 5, 0);
}

// rot 3: two whole turns and then the half: 320 steps. One whole turn after the start is step 128;
// the pitch is 5 mm over 2.5 turns, 2 mm a turn.
TEST(SampleArc, whole_turns_come_before_the_turn_to_the_end) {
  const auto points = arc({1, 0, 0}, {-1, 0, 5}, {Plane::g17, {0, 0}, 3});
  ASSERT_EQ(points.size(), 321U);
  expect_at(points[128], 1, 0, 2);
}

// From radius 2 to radius 4 over half a turn: 3 at the quarter.
TEST(SampleArc, radius_of_a_spiral_is_linear_in_the_angle) {
  const auto points = arc({2, 0, 0}, {-4, 0, 0}, {Plane::g17, {0, 0}, 1});
  ASSERT_EQ(points.size(), 65U);
  expect_at(points[32], 0, 3, 0);
}

// G18 pairs (Z, X) and looks from +Y: counterclockwise goes from +Z to +X.
TEST(SampleArc, g18_turns_from_z_to_x) {
  const auto points = arc({0, 7, 10}, {10, 7, 0}, {Plane::g18, {0, 0}, 1});
  ASSERT_EQ(points.size(), 33U);
  expect_at(points[16], 10 * kHalfRoot, 7, 10 * kHalfRoot);
}

// G19 pairs (Y, Z): counterclockwise goes from +Y to +Z.
TEST(SampleArc, g19_turns_from_y_to_z) {
  const auto points = arc({7, 10, 0}, {7, 0, 10}, {Plane::g19, {0, 0}, 1});
  ASSERT_EQ(points.size(), 33U);
  expect_at(points[16], 7, 10 * kHalfRoot, 10 * kHalfRoot);
}

TEST(SampleArc, a_billion_turns_stay_within_the_limit) {
  const auto points = sample_arc({1, 0, 0}, {1, 0, 0}, {Plane::g17, {0, 0}, 1'000'000'000}, 500);
  EXPECT_EQ(points.size(), 501U);
}

// Unit circle in the plane y = z through (1,0,0), (0, s, s), (-1,0,0), s = sqrt(1/2): half a turn,
// a quarter of it at (s, 1/2, 1/2).
TEST(SampleCircle, half_circle_in_a_tilted_plane) {
  const auto points = sample_circle({1, 0, 0}, {0, kHalfRoot, kHalfRoot}, {-1, 0, 0}, kMaxSegments);
  ASSERT_EQ(points.size(), 65U);
  expect_at(points[16], kHalfRoot, 0.5, 0.5);
  expect_at(points[32], 0, kHalfRoot, kHalfRoot);
}

TEST(SampleCircle, three_points_in_line_are_two_lines) {
  const std::vector<Point3> expected = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}};
  EXPECT_EQ(sample_circle(expected[0], expected[1], expected[2], kMaxSegments), expected);
}

TEST(SamplePath, axes_that_a_record_does_not_name_stay) {
  Position start;
  start[Axis::z] = 5;
  const Path path = sample_path(start, std::vector{rapid_x(Number(1) / Number(4))});
  ASSERT_EQ(path.motions.size(), 1U);
  EXPECT_EQ(path.motions[0].points, (std::vector<Point3>{{0, 0, 5}, {0.25, 0, 5}}));
  EXPECT_TRUE(path.motions[0].rapid);
}

TEST(SamplePath, texts_keep_the_exact_numbers) {
  const Path path = sample_path({}, std::vector{rapid_x(Number(1) / Number(3))});
  EXPECT_EQ(path.motions[0].text, R"({"k":"rapid","to":{"x":"1/3"}})");
}

TEST(SamplePath, a_dwell_stands_where_the_machine_is) {
  Record dwell;
  dwell.kind = RecordKind::dwell;
  const Path path = sample_path({}, std::vector{rapid_x(2), dwell});
  EXPECT_EQ(path.motions[1].points, (std::vector<Point3>{{2, 0, 0}}));
  EXPECT_FALSE(path.motions[1].moves());
}

TEST(SamplePath, is_cut_at_the_limit_of_segments) {
  const Path path = sample_path({}, std::vector{rapid_x(1), rapid_x(2), rapid_x(3)}, 2);
  EXPECT_EQ(path.motions.size(), 2U);
  EXPECT_TRUE(path.cut);
}

TEST(SamplePath, far_places_stay_finite) {
  const Path path = sample_path({}, std::vector{rapid_x(*Number::parse("1e400"))});
  EXPECT_TRUE(std::isfinite(path.motions[0].points[1].x));
}

}  // namespace
}  // namespace gonogo::oracle::report
