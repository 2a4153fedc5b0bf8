// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finishing above the floor: only the strip between the contour and what roughing left.
#include "tests/oracle/region/pocket_expectations.hpp"

namespace gonogo::oracle::region {
namespace {

// The contour of 60 x 40, corners 8, for a tool of 5; cleared before: all but `allowance`.
Pocket strip(std::string_view allowance) {
  Pocket job = pocket("60", "40", "8", "5", "0");
  job.level.cleared = pocket("60", "40", "8", "5", allowance).level.area;
  return job;
}

TEST(StripRegion, TheContourAloneClearsTheStrip) {
  Pocket job = strip("0.75");
  finish(job);
  EXPECT_TRUE(is_go(job));
  EXPECT_TRUE(judge(job).by_filter);
}

TEST(StripRegion, TheContourAloneDoesNotClearTheFloor) {
  Pocket job = strip("0.75");
  finish(job);
  job.level.cleared.reset();
  EXPECT_TRUE(breaks(Rule::cover, job));
}

TEST(StripRegion, ClearingMoreThanTheStripIsGo) {
  Pocket job = strip("0.75");
  zigzag(job, 4);
  EXPECT_TRUE(is_go(job));
}

TEST(StripRegion, NoMotionAtAllLeavesTheStrip) {
  const Pocket job = strip("0.75");
  EXPECT_TRUE(breaks(Rule::cover, job));
}

TEST(StripRegion, AStripOfNoWidthNeedsNothing) {
  EXPECT_TRUE(is_go(strip("0")));
}

// A side left out: its middle is 0.75 wide, the outer edge lies 5.75 from what is done.
TEST(StripRegion, ASideLeftOutBreaksCover) {
  Pocket job = strip("0.75");
  finish(job);
  job.motions.resize(job.motions.size() - 2);  // the last corner and half of the lower side
  EXPECT_TRUE(breaks(Rule::cover, job));
}

// The tool runs 5 inside the contour and reaches 10.001 inside: 0.499 is left along the sides.
TEST(StripRegion, AStripWiderThanTheToolBreaksCover) {
  Pocket job = strip("10.5");
  finish(job);
  EXPECT_TRUE(breaks(Rule::cover, job));
}

// Corners are of 5 before and the contour reaches all but the rectangle to (19.999, 9.999). Cleared
// corners about (20, 10) begin outside of that; those about (15.01, 5.01) at (18.55, 8.55).
TEST(StripRegion, AWideStripIsGoAsFarAsItsCornersAreReached) {
  Pocket job = strip("5");
  finish(job);
  EXPECT_TRUE(is_go(job));
  job = strip("9.99");
  finish(job);
  EXPECT_TRUE(breaks(Rule::cover, job));
}

// Corners of 2: the tool leaves corners of 5 inside and outside alike.
TEST(StripRegion, CornersSmallerThanTheToolAreGo) {
  Pocket job = pocket("60", "40", "2", "5", "0");
  job.level.cleared = pocket("60", "40", "2", "5", "0.5").level.area;
  finish(job);
  EXPECT_TRUE(is_go(job));
}

TEST(StripRegion, RingsAndSlotsAreGo) {
  for (const std::string_view length : {"40", "60"}) {
    Pocket job = pocket(length, "40", "20", "5", "0");
    job.level.cleared = pocket(length, "40", "20", "5", "0.75").level.area;
    finish(job);
    EXPECT_TRUE(is_go(job));
  }
}

TEST(StripRegion, RoughedAlongALineOrAtAPointIsGo) {
  for (const std::string_view length : {"11.5", "60"}) {
    Pocket job = pocket(length, "11.5", "5.75", "5", "0");
    job.level.cleared = pocket(length, "11.5", "5.75", "5", "0.75").level.area;
    finish(job);
    EXPECT_TRUE(is_go(job));
    job.level.sense = -1;
    EXPECT_TRUE(breaks(Rule::sense, job));
  }
}

}  // namespace
}  // namespace gonogo::oracle::region
