// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/figure.hpp"

#include <gtest/gtest.h>

#include "publish/report/figure_parts.hpp"
#include "tests/publish/report/report_testing.hpp"

namespace gonogo::oracle::report {
namespace {

Motion standing(Point3 at) {
  Motion motion;
  motion.points = {at};
  return motion;
}

// Down to -10, up to -8, down to -20, all along Z.
Path pecks() {
  return {{line({5, 0, 0}, {5, 0, -10}), line({5, 0, -10}, {5, 0, -8}, true), standing({5, 0, -8}),
           line({5, 0, -8}, {5, 0, -20})}};
}

TEST(Figure, NumbersTheMotionsThatMove) {
  EXPECT_EQ(motion_numbers(pecks()), (std::vector<std::size_t>{1, 2, 0, 3}));
}

TEST(Figure, NumbersNoneWhereTheyWouldCoverEachOther) {
  Path path;
  for (std::size_t i = 0; i <= kMostNumbered; ++i) {
    const auto x = static_cast<double>(i);
    path.motions.push_back(line({x, 0, 0}, {x + 1, 1, 0}));
  }
  EXPECT_EQ(motion_numbers(path), std::vector<std::size_t>(kMostNumbered + 1, 0));
  path.motions.pop_back();
  EXPECT_EQ(motion_numbers(path).back(), kMostNumbered);
}

TEST(Figure, IsEmptyWhereNothingMoves) {
  const Path path{{standing({1, 2, 3})}};
  Figure figure;
  figure.path = &path;
  EXPECT_EQ(svg_figure(figure), "");
}

// 20 mm long, so motions stand apart by 6 % of it, 1.2 mm, downwards on a lathe, where Z is level,
// and by 10 %, 2 mm, to the right on a mill, where it is upright. What does not move stays where
// the motion before it ended.
TEST(Figure, SpreadsALineMotionBesideMotion) {
  Extent extent;
  extent.include({5, 0, 0});
  extent.include({5, 0, -20});
  const auto lathe = spread_for(extent, true);
  ASSERT_TRUE(lathe);
  EXPECT_EQ(lathe->axis, 'X');
  const Path spread = spread_out(pecks(), *lathe);
  EXPECT_NEAR(spread.motions[0].points[0].x, 5, 1e-12);
  EXPECT_NEAR(spread.motions[1].points[0].x, 5 - 1.2, 1e-12);
  EXPECT_NEAR(spread.motions[2].points[0].x, 5 - 1.2, 1e-12);
  EXPECT_NEAR(spread.motions[3].points[1].x, 5 - 2.4, 1e-12);
  EXPECT_EQ(spread.motions[3].points[1].z, -20);
  const auto mill = spread_for(extent, false);
  ASSERT_TRUE(mill);
  EXPECT_NEAR(mill->step.x, 2, 1e-12);
}

TEST(Figure, LeavesWhatIsNoLineInItsPlace) {
  Extent extent;
  extent.include({0, 0, 0});
  extent.include({1, 0, -20});
  EXPECT_FALSE(spread_for(extent, true));
}

TEST(Figure, NamesBothPathsAndEachLimitOnce) {
  const Path first{{line({0, 0, 0}, {10, 0, 0}), line({10, 0, 0}, {10, 5, 0}, true)}};
  const Path second{{line({0, 0, 0}, {10, 2, 0})}};
  Figure figure;
  figure.path = &first;
  figure.path_name = "end = near";
  figure.other = &second;
  figure.other_name = "far";
  figure.limits = {{Limit::Kind::border, "border", {{0, 0, 0}, {10, 5, 0}}},
                   {Limit::Kind::border, "border", {{0, 0, 0}, {9, 5, 0}}}};
  const std::string svg = svg_figure(figure);
  for (const char* name : {">end = near, feed<", ">end = near, rapid<", ">far, feed<"}) {
    EXPECT_NE(svg.find(name), std::string::npos) << name;
  }
  EXPECT_EQ(svg.find(">far, rapid<"), std::string::npos);
  EXPECT_EQ(svg.find(">border<"), svg.rfind(">border<"));
  EXPECT_EQ(svg.find("class=\"gs-number\""), std::string::npos) << "two paths have no numbers";
}

TEST(Figure, SaysThatAPathHasNoMotion) {
  const Path first{{line({0, 0, 0}, {10, 5, 0})}};
  const Path second{{standing({0, 0, 0})}};
  Figure figure;
  figure.path = &first;
  figure.path_name = "zero = cut";
  figure.other = &second;
  figure.other_name = "alarm";
  EXPECT_NE(svg_figure(figure).find(">alarm: nothing moves here<"), std::string::npos);
}

}  // namespace
}  // namespace gonogo::oracle::report
