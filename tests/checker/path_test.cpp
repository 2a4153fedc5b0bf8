// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/path.hpp"

#include <gtest/gtest.h>

namespace gonogo::checker {
namespace {

Path path_of(const std::vector<std::string>& records, long renaming = 0) {
  std::vector<Record> all;
  for (const std::string& text : records) all.push_back(read_record(parse_json(text)));
  PathTolerances tolerances;
  for (auto& coordinate : tolerances.start) coordinate = Real(0);
  tolerances.tolerance = Rational(1, 1000);
  tolerances.renaming = renaming;
  return make_path(all, tolerances);
}

std::string feed(const std::string& to, int block = 1) {
  return R"({"k":"feed","b":)" + std::to_string(block) + R"(,"to":{)" + to + R"(},"f":"100"})";
}

std::string arc(int rotation, const std::string& x, const std::string& y) {
  return R"({"k":"arc","b":1,"plane":"G17","c":{"x":"0","y":"0"},"rot":)" +
         std::to_string(rotation) + R"(,"to":{"x":")" + x + R"(","y":")" + y + R"("},"f":"100"})";
}

const std::string kToTen = R"({"k":"rapid","b":1,"to":{"x":"10"}})";

TEST(CheckerPath, AMotionThatGoesNowhereIsDropped) {
  EXPECT_EQ(path_of({feed(R"("x":"0.001")"), feed(R"("x":"1")")}).motions.size(), 1U);
}

// From 0 by thousandths: the second leads away from where the path stood, and the third goes on.
TEST(CheckerPath, MotionsThatGoNowhereOneByOneAddUp) {
  const Path path =
      path_of({feed(R"("z":"-0.001")"), feed(R"("z":"-0.002")"), feed(R"("z":"-0.003")")});
  ASSERT_EQ(path.motions.size(), 1U);
  EXPECT_EQ(equal(*path.motions[0].to[2], Rational(-3, 1000)), Truth::yes);
  EXPECT_FALSE(path.is_doubtful);
}

TEST(CheckerPath, AnArcInSpaceThatComesBackGoesSomewhere) {
  const auto circle = [](const char* y) {
    return std::string(R"({"k":"arc3","b":1,"to":{"x":"0","y":"0","z":"0"},"via":{"x":"0","y":")") +
           y + R"(","z":"0"},"f":"100"})";
  };
  EXPECT_EQ(path_of({circle("100")}).motions.size(), 1U);
  EXPECT_TRUE(path_of({circle("0.001")}).motions.empty());
}

TEST(CheckerPath, ADwellOfNoTimeIsDropped) {
  EXPECT_TRUE(path_of({R"({"k":"dwell","b":1,"s":"0"})"}).motions.empty());
}

TEST(CheckerPath, LinesThatGoOnAreOne) {
  const Path path = path_of({feed(R"("x":"1","y":"2")"), feed(R"("x":"3","y":"6")")});
  ASSERT_EQ(path.motions.size(), 1U);
  EXPECT_EQ(equal(*path.motions[0].to[1], 6), Truth::yes);
}

TEST(CheckerPath, LinesThatTurnOrTurnBackAreTwo) {
  EXPECT_EQ(path_of({feed(R"("x":"1")"), feed(R"("x":"2","y":"0.01")")}).motions.size(), 2U);
  EXPECT_EQ(path_of({feed(R"("x":"2")"), feed(R"("x":"1")")}).motions.size(), 2U);
}

TEST(CheckerPath, LinesOfTwoBlocksAreTwo) {
  EXPECT_EQ(path_of({feed(R"("x":"1")", 1), feed(R"("x":"2")", 2)}).motions.size(), 2U);
}

TEST(CheckerPath, TraversesOfOneAxisAreOneAndOfTwoAreTwo) {
  const std::string to_one = R"({"k":"rapid","b":1,"to":{"x":"1"}})";
  const std::string both = R"({"k":"rapid","b":1,"to":{"x":"2","y":"2"}})";
  EXPECT_EQ(path_of({to_one, kToTen}).motions.size(), 1U);
  EXPECT_EQ(path_of({to_one, both}).motions.size(), 2U);
}

// From (10, 0) counterclockwise: to (0, 10) a quarter, on to (-10, 0) a half: together one turn
// begun; from (0, -10) on to (0, 10) it goes past the start: a second turn begun.
TEST(CheckerPath, TurnsOfArcsAddUp) {
  const Path half = path_of({kToTen, arc(1, "0", "10"), arc(1, "-10", "0")});
  ASSERT_EQ(half.motions.size(), 2U);
  EXPECT_EQ(half.motions[1].record.rotation, 1);
  const Path more = path_of({kToTen, arc(1, "0", "-10"), arc(1, "0", "10")});
  ASSERT_EQ(more.motions.size(), 2U);
  EXPECT_EQ(more.motions[1].record.rotation, 2);
  // Two halves are one whole turn, and a turn and a half are two begun; clockwise alike.
  const Path whole = path_of({kToTen, arc(-1, "-10", "0"), arc(-1, "10", "0")});
  ASSERT_EQ(whole.motions.size(), 2U);
  EXPECT_EQ(whole.motions[1].record.rotation, -1);
  const Path two = path_of({kToTen, arc(-1, "10", "0"), arc(-1, "-10", "0")});
  ASSERT_EQ(two.motions.size(), 2U);
  EXPECT_EQ(two.motions[1].record.rotation, -2);
}

TEST(CheckerPath, ArcsOfTwoSensesAreTwo) {
  EXPECT_EQ(path_of({kToTen, arc(1, "0", "10"), arc(-1, "10", "0")}).motions.size(), 3U);
}

TEST(CheckerPath, AWholeTurnIsNoNilMotion) {
  EXPECT_EQ(path_of({kToTen, arc(1, "10", "0")}).motions.size(), 2U);
}

TEST(CheckerPath, AfterARenamingPositionsAreUnknown) {
  const Path path = path_of({feed(R"("x":"1")", 1), feed(R"("x":"1")", 3)}, 2);
  ASSERT_EQ(path.motions.size(), 2U);
  EXPECT_FALSE(path.motions[1].from[0].has_value());
  EXPECT_TRUE(path.is_doubtful);
}

}  // namespace
}  // namespace gonogo::checker
