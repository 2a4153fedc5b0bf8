// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge of LCYC75 on finishing paths written by hand. Roughing left 0.75 and 0.5; the tool's
// centre may be within 25 by 15 about the middle, corners 3, down to -8, and what roughing cleared
// for it is 24.25 by 14.25, corners 2.25, down to -7.5.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pocket_milling.hpp"

namespace gonogo::oracle {
namespace {

Job finishing() {
  Job job;
  job.ways = "R126=2 R127=2";
  return job;
}
Job contour_only() {
  Job job = finishing();
  job.allowance = "R124=0.75 R125=0";
  return job;
}

std::string told(const Miller& miller, const Job& job, ReadingsOf readings = {}) {
  const Verdict verdict =
      judge_records(job.program(), miller.records(), {true, profile_802s(readings)});
  if (decision(verdict.kind) == Decision::go) return "go";
  return fmt::format("{} {}", name(verdict.kind), reference::clause_name(verdict.clause));
}

void contour(Miller& miller) {
  miller.round(25, 15, 3);
}
void floor(Miller& miller) {
  miller.line(-10, 0).line(10, 0).round(17, 7, 0).round(25, 15, 3).home();
}
// Comes down fast in the rough pocket, mills the contour and is at the centre again.
void upper_level(Miller& miller) {
  miller.rapid(20, 5).rapid_down(-4).line(20, 0);
  contour(miller);
  miller.rapid(0, 0);
}

TEST(PocketFinishing, ContourThenFloorIsGo) {
  Miller miller(finishing());
  miller.approach();
  upper_level(miller);
  miller.plunge(-8);
  floor(miller);
  miller.end();
  EXPECT_EQ(told(miller, finishing()), "go");
  EXPECT_EQ(told(miller, finishing(), {{"sie.finish.levels", "split"}}), "go");
}

TEST(PocketFinishing, OneLevelAtTheFloorIsAReading) {
  Miller miller(finishing());
  miller.approach().plunge(-8);
  floor(miller);
  miller.end();
  EXPECT_EQ(told(miller, finishing()), "go");
  EXPECT_EQ(told(miller, finishing(), {{"sie.finish.levels", "split"}}),
            "fail.geometry SIE-LC75-06");
  Job deep = finishing();
  deep.infeed = "R121=8";
  EXPECT_EQ(told(miller, deep, {{"sie.finish.levels", "split"}}), "go");
}

TEST(PocketFinishing, TheLastInfeedIsAtTheCentre) {
  Miller miller(finishing());
  miller.approach();
  upper_level(miller);
  miller.rapid(5, 0).plunge(-8);
  floor(miller);
  EXPECT_EQ(told(miller.end(), finishing()), "fail.geometry SIE-LC75-11");
}

TEST(PocketFinishing, TheLastInfeedIsNoTraverseAndHasItsFeed) {
  Miller fast(finishing());
  fast.approach();
  upper_level(fast);
  fast.rapid_down(-8);
  floor(fast);
  EXPECT_EQ(told(fast.end(), finishing()), "fail.region SIE-LC75-11");
  Miller slow(finishing());
  slow.approach();
  upper_level(slow);
  slow.feed_down(100).plunge(-8);
  floor(slow);
  EXPECT_EQ(told(slow.end(), finishing()), "fail.feed SIE-LC75-11");
}

TEST(PocketFinishing, AFloorThatIsLeftIsNoGo) {
  Miller miller(finishing());
  miller.approach();
  upper_level(miller);
  miller.plunge(-8);
  contour(miller);
  EXPECT_EQ(told(miller.home().end(), finishing()), "fail.region SIE-LC75-10");
}

TEST(PocketFinishing, AStripThatIsLeftIsNoGo) {
  Miller miller(finishing());
  miller.approach().rapid_down(-4).round(24.25, 14.25, 2.25).rapid(0, 0).plunge(-8);
  floor(miller);
  EXPECT_EQ(told(miller.end(), finishing()), "fail.region SIE-LC75-10");
}

TEST(PocketFinishing, TheContourAloneIsEnoughWhereTheFloorIsDone) {
  Miller miller(contour_only());
  miller.approach();
  upper_level(miller);
  miller.plunge(-8);
  contour(miller);
  miller.home().end();
  EXPECT_EQ(told(miller, contour_only()), "go");
  EXPECT_EQ(told(miller, finishing()), "fail.region SIE-LC75-10");
}

TEST(PocketFinishing, OfTheContourAloneTheLastInfeedIsAtTheCentreToo) {
  Miller miller(contour_only());
  miller.approach();
  upper_level(miller);
  miller.rapid(20, 0).plunge(-8);
  contour(miller);
  EXPECT_EQ(told(miller.home().end(), contour_only()), "fail.geometry SIE-LC75-11");
}

TEST(PocketFinishing, TheContourGoesRoundAsTold) {
  Miller miller(contour_only());
  miller.approach().plunge(-8).round(25, 15, 3, +1).home().end();
  EXPECT_EQ(told(miller, contour_only()), "fail.region SIE-LC75-12");
  Job other = contour_only();
  other.ways = "R126=3 R127=2";
  EXPECT_EQ(told(miller, other), "go");
}

// 24.5 is in the strip that roughing left.
TEST(PocketFinishing, TravelBelowTheTopStaysInWhatRoughingCleared) {
  const auto down_at = [](double u) {
    Miller miller(contour_only());
    miller.approach().rapid(u, 0).rapid_down(-4);
    contour(miller);
    miller.rapid(0, 0).plunge(-8);
    contour(miller);
    return told(miller.home().end(), contour_only());
  };
  EXPECT_EQ(down_at(24.25), "go");
  EXPECT_EQ(down_at(24.5), "fail.region SIE-LC75-13");
}

TEST(PocketFinishing, AFastWayAlongTheStripIsNoGo) {
  Miller miller(contour_only());
  miller.approach().rapid_down(-4).line(24, 0).rapid(25, 0);
  contour(miller);
  miller.rapid(0, 0).plunge(-8);
  contour(miller);
  EXPECT_EQ(told(miller.home().end(), contour_only()), "fail.region SIE-LC75-10");
}

TEST(PocketFinishing, AnUpperLevelIsNoDeeperThanTheInfeed) {
  Miller miller(contour_only());
  miller.approach().rapid_down(-5);
  contour(miller);
  miller.rapid(0, 0).plunge(-8);
  contour(miller);
  EXPECT_EQ(told(miller.home().end(), contour_only()), "fail.geometry SIE-LC75-06");
}

// Without an allowance in the plane there is nothing to mill above the floor.
TEST(PocketFinishing, WithoutAStripOnlyTheFloorCounts) {
  Job job = finishing();
  job.allowance = "R124=0 R125=0.5";
  Miller miller(job);
  miller.approach().rapid_down(-7).plunge(-8);
  floor(miller);
  miller.end();
  EXPECT_EQ(told(miller, job), "go");
  for (const std::string_view infeed : {"equal", "max-rest"}) {
    EXPECT_EQ(told(miller, job, {{"sie.finish.levels", "split"}, {"sie.infeed", infeed}}), "go");
  }
  EXPECT_EQ(told(miller, job, {{"sie.finish.levels", "split"}}), "go");
}

// Roughing left 3 in depth: at -6 the strip alone is milled, and the middle still stands.
TEST(PocketFinishing, BelowTheRoughFloorAStripOpensOnlyItself) {
  Job job = finishing();
  job.allowance = "R124=0.75 R125=3";
  job.infeed = "R121=3";
  const auto after_strip = [&](bool fast) {
    Miller miller(job);
    miller.approach().rapid_down(-3);
    contour(miller);
    miller.rapid(0, 0).plunge(-6);
    contour(miller);
    fast ? miller.rapid(0, 0) : miller.home();
    miller.plunge(-8);
    floor(miller);
    return told(miller.end(), job);
  };
  EXPECT_EQ(after_strip(false), "go");
  EXPECT_EQ(after_strip(true), "fail.region SIE-LC75-13");
}

}  // namespace
}  // namespace gonogo::oracle
