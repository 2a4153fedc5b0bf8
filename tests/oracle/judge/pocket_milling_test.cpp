// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge of LCYC75 on roughing paths written by hand. The tool's centre may be within 24.25 by
// 14.25 about the middle, corners 2.25; 7.5 deep, no infeed above 4; the tolerance is 0.001.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "pocket_milling.hpp"

namespace gonogo::oracle {
namespace {

using Step = std::function<void(Miller&)>;

void clears(Miller& miller) {
  miller.contour_parallel();
}

Verdict judge(const Miller& miller, const Job& job = {}, ReadingsOf readings = {}) {
  return judge_records(job.program(), miller.records(), {true, profile_802s(readings)});
}

// Both levels done by one step each, the first plunge to `first`.
Verdict two_levels(const Step& upper, const Step& lower, double first = -3.75) {
  Miller miller{Job()};
  miller.approach().plunge(first);
  upper(miller);
  miller.plunge(-7.5);
  lower(miller);
  return judge(miller.end());
}

std::string told(const Verdict& verdict) {
  if (decision(verdict.kind) == Decision::go) return "go";
  return fmt::format("{} {}", name(verdict.kind), reference::clause_name(verdict.clause));
}

TEST(PocketMilling, ThreeWaysToClearALevelAreGo) {
  for (const Way way : {Way::zigzag, Way::contour_parallel, Way::trochoidal}) {
    EXPECT_EQ(told(judge_records(Job().program(), rough(way))), "go");
  }
}

TEST(PocketMilling, SoTheyAreInATurnedFrame) {
  for (const int degrees : {17, 30, 45, 90, 163, -90}) {
    Job job;
    job.frame = fmt::format("G258 RPL={}\n", degrees);
    const double angle = degrees * std::numbers::pi / 180;
    const double x = 60 * std::cos(angle) - 40 * std::sin(angle);
    const double y = 60 * std::sin(angle) + 40 * std::cos(angle);
    for (const Way way : {Way::zigzag, Way::contour_parallel, Way::trochoidal}) {
      EXPECT_EQ(told(judge_records(job.program(), rough(way, job, x, y, degrees))), "go")
          << degrees;
    }
    EXPECT_EQ(told(judge_records(job.program(), rough(Way::zigzag, job, x, y, degrees + 1))),
              "fail.region SIE-LC75-08");
  }
}

TEST(PocketMilling, WithoutLineNumbersTheyAreGoToo) {
  for (const Way way : {Way::zigzag, Way::contour_parallel, Way::trochoidal}) {
    EXPECT_EQ(told(judge_records(Job().program(), rough(way), {false})), "go");
  }
}

TEST(PocketMilling, TheToolMayLiftAndTravelInWhatIsCleared) {
  const Step lifts = [](Miller& miller) {
    miller.contour_parallel().lift(1).rapid(10, 5).lift(5).rapid(-10, 0).rapid(0, 0);
    miller.rapid_down(-3.75);
  };
  EXPECT_EQ(told(two_levels(lifts, clears)), "go");
  const Step travels = [](Miller& miller) {
    miller.zigzag().rapid(20, 5).rapid_in_space(-20, 5, -2).rapid_in_space(0, 0, -3.7);
  };
  EXPECT_EQ(told(two_levels(travels, clears)), "go");
}

TEST(PocketMilling, TheWayBackToTheCentreMayHaveAnyFeed) {
  const Step slow = [](Miller& miller) {
    miller.zigzag().line(24.25, 0).feed_in_plane(1000).home().feed_in_plane(300);
  };
  EXPECT_EQ(told(two_levels(slow, slow)), "go");
}

TEST(PocketMilling, TheEndMayBeReachedFromAnywhereInThePocket) {
  Miller miller{Job()};
  miller.approach().plunge(-3.75).zigzag().plunge(-7.5).zigzag().lift(1).rapid(10, 0);
  miller.rapid_in_space(0, 0, 5).end();
  EXPECT_EQ(told(judge(miller)), "go");
}

// From (0, 0, -20) the order of the axes is free.
TEST(PocketMilling, TheApproachMayGoAxisByAxis) {
  Job job;
  job.frame = "G0 X0 Y0 Z-20\n";
  std::vector<Record> records = rough(Way::zigzag, job);
  Record start = records[0];
  start.block = 3;
  start.to[Axis::x] = start.to[Axis::y] = 0;
  start.to[Axis::z] = -20;
  Record up = records[1];
  up.axes = {Axis::z};
  Record across = records[1];
  across.axes = {Axis::x, Axis::y};
  for (const bool up_first : {true, false}) {
    std::vector<Record> sent = {records[0], start, up_first ? up : across, up_first ? across : up};
    sent.insert(sent.end(), records.begin() + 2, records.end());
    EXPECT_EQ(told(judge_records(job.program(), sent)), "go");
  }
}

TEST(PocketMilling, AnIslandIsNoGo) {
  const Step leaves = [](Miller& miller) {
    miller.line(-22, -12).line(22, -12).line(22, 12).line(-22, 12).line(22, 0).border().home();
  };
  EXPECT_EQ(told(two_levels(leaves, clears)), "fail.region SIE-LC75-10");
  const Verdict verdict = two_levels(clears, leaves);
  EXPECT_EQ(told(verdict), "fail.region SIE-LC75-10");
  EXPECT_NE(verdict.witness.find(R"("z":"-7.5")"), std::string::npos) << verdict.witness;
  EXPECT_EQ(verdict.block, 6U);
}

TEST(PocketMilling, WithoutLineNumbersAnIslandIsNoGoToo) {
  Miller miller{Job()};
  miller.approach().plunge(-3.75).border().home().plunge(-7.5).zigzag().end();
  EXPECT_EQ(told(judge_records(Job().program(), miller.records(), {false})),
            "fail.region SIE-LC75-10");
}

TEST(PocketMilling, AGougedWallIsNoGoBeyondTheTolerance) {
  const auto wider = [](double by) {
    const Step goes = [by](Miller& miller) {
      miller.zigzag().round(24.25 + by, 14.25, 2.25).home();
    };
    return two_levels(goes, clears);
  };
  EXPECT_EQ(told(wider(0.001)), "go");
  const Verdict verdict = wider(0.002);
  EXPECT_EQ(told(verdict), "fail.region SIE-LC75-08");
  EXPECT_EQ(verdict.deviation_mm.substr(0, 5), "0.002");
  EXPECT_FALSE(verdict.got.empty());
}

TEST(PocketMilling, AGougedCornerIsNoGo) {
  const Step goes = [](Miller& miller) { miller.zigzag().round(24.25, 14.25, 0).home(); };
  EXPECT_EQ(told(two_levels(goes, clears)), "fail.region SIE-LC75-08");
}

TEST(PocketMilling, TheAllowanceForgottenInThePlaneIsNoGo) {
  const Step goes = [](Miller& miller) { miller.zigzag().round(25, 15, 3).home(); };
  EXPECT_EQ(told(two_levels(goes, clears)), "fail.region SIE-LC75-08");
}

TEST(PocketMilling, TheAllowanceForgottenInDepthIsNoGo) {
  Miller miller{Job()};
  miller.approach().plunge(-4).zigzag().plunge(-8).zigzag().end();
  EXPECT_EQ(told(judge(miller)), "fail.geometry SIE-LC75-06");
}

TEST(PocketMilling, AMissingLastLevelIsNoGo) {
  Miller miller{Job()};
  miller.approach().plunge(-3.75).zigzag().end();
  EXPECT_EQ(told(judge(miller)), "fail.geometry SIE-LC75-04");
}

TEST(PocketMilling, AnInfeedIsNoDeeperThanAllowed) {
  EXPECT_EQ(told(two_levels(clears, clears, -4)), "go");
  EXPECT_EQ(told(two_levels(clears, clears, -4.001)), "go");
  EXPECT_EQ(told(two_levels(clears, clears, -4.002)), "fail.geometry SIE-LC75-06");
  EXPECT_EQ(told(two_levels(clears, clears, -3.5)), "go");
  EXPECT_EQ(told(two_levels(clears, clears, -3.498)), "fail.geometry SIE-LC75-06");
}

TEST(PocketMilling, TheFeedsAreThoseOfTheirParameters) {
  Miller down{Job()};
  down.approach().plunge(-3.75).zigzag().feed_down(121).plunge(-7.5).zigzag().end();
  EXPECT_EQ(told(judge(down)), "fail.feed SIE-LC75-04");
  Miller across{Job()};
  across.approach().plunge(-3.75).feed_in_plane(301).zigzag();
  across.feed_in_plane(300).plunge(-7.5).zigzag().end();
  EXPECT_EQ(told(judge(across)), "fail.feed SIE-LC75-04");
}

TEST(PocketMilling, TheBorderGoesRoundAsToldAndNothingElseHasASense) {
  const Step wrong = [](Miller& miller) { miller.zigzag().border(+1).home(); };
  EXPECT_EQ(told(two_levels(wrong, clears)), "fail.region SIE-LC75-12");
  const Step inner = [](Miller& miller) { miller.zigzag().round(16, 6, 1, +1).home(); };
  EXPECT_EQ(told(two_levels(inner, clears)), "go");
}

TEST(PocketMilling, TheInfeedIsAtTheCentre) {
  const auto off = [](double by) {
    Miller miller{Job()};
    miller.approach().plunge(-3.75).zigzag().line(by, 0).plunge(-7.5).zigzag().end();
    return told(judge(miller));
  };
  EXPECT_EQ(off(0.001), "go");
  EXPECT_EQ(off(0.002), "fail.geometry SIE-LC75-04");
}

TEST(PocketMilling, ARampIsNoInfeed) {
  Miller miller{Job()};
  miller.approach().ramp(10, 0, -3.75).zigzag().plunge(-7.5).zigzag().end();
  EXPECT_EQ(told(judge(miller)), "fail.geometry SIE-LC75-04");
}

// From Z2, where R103 + R102 lies, to Z0.1 the tool is in the air.
TEST(PocketMilling, ATraverseInTheAirWhereTheInfeedIsDueIsToldAsThat) {
  Miller miller{Job()};
  miller.approach().rapid_down(0.1).plunge(-3.75).zigzag().plunge(-7.5).zigzag().end();
  const Verdict verdict = judge(miller);
  EXPECT_EQ(told(verdict), "fail.region SIE-LC75-04");
  EXPECT_EQ(verdict.message, "The tool traverses where the infeed is due.");
}

TEST(PocketMilling, ATraverseIntoThePartIsNoGo) {
  Miller miller{Job()};
  miller.approach().rapid_down(-3.75).zigzag().plunge(-7.5).zigzag().end();
  EXPECT_EQ(told(judge(miller)), "fail.region SIE-LC75-04");
  const Step rapids = [](Miller& m) { m.rapid(20, 0).zigzag(); };
  EXPECT_EQ(told(two_levels(rapids, clears)), "fail.region SIE-LC75-10");
}

TEST(PocketMilling, TravelStaysInThePocket) {
  const Step leaves = [](Miller& miller) {
    miller.zigzag().lift(3).rapid(24.252, 0).rapid(0, 0).rapid_down(-3.75);
  };
  EXPECT_EQ(told(two_levels(leaves, clears)), "fail.region SIE-LC75-13");
  const Step stays = [](Miller& miller) {
    miller.zigzag().lift(3).rapid(24.251, 0).rapid(0, 0).rapid_down(-3.75);
  };
  EXPECT_EQ(told(two_levels(stays, clears)), "go");
}

TEST(PocketMilling, ItEndsAboveTheCentreAtTheRetractPlane) {
  const auto ends = [](const Step& last) {
    Miller miller{Job()};
    miller.approach().plunge(-3.75).zigzag().plunge(-7.5).zigzag();
    last(miller);
    return told(judge(miller));
  };
  EXPECT_EQ(ends([](Miller& m) { m.line(5, 0).end(); }), "fail.geometry SIE-LC75-13");
  EXPECT_EQ(ends([](Miller& m) { m.lift(4).end(); }), "go");
  EXPECT_EQ(ends([](Miller& m) { m.lift(4.998).rapid(1, 0).end(); }), "fail.geometry SIE-LC75-13");
}

// SIE-LC75-13: no speed is printed for the way back. It may be a feed, R122, R123 or another, and
// in pieces; the motion behind it is of the next block. Above R101 no clause leads.
TEST(PocketMilling, TheWayBackToTheRetractPlaneMayBeAFeed) {
  const auto ends = [](const Step& last, bool blocks) {
    Miller miller{Job()};
    miller.approach().plunge(-3.75).zigzag().plunge(-7.5).zigzag();
    last(miller);
    miller.end();
    std::vector<Record> records = miller.records();
    records.erase(records.end() - 2);  // the traverse to R101
    return told(judge_records(Job().program(), records, {blocks}));
  };
  for (const bool blocks : {true, false}) {
    for (const int feed : {120, 300, 1000}) {
      EXPECT_EQ(ends([&](Miller& m) { m.feed_down(feed).plunge(5); }, blocks), "go") << feed;
    }
    EXPECT_EQ(ends([](Miller& m) { m.plunge(-1).plunge(3).plunge(5); }, blocks), "go");
    EXPECT_EQ(ends([](Miller& m) { m.rapid_down(1).plunge(5); }, blocks), "go");
    EXPECT_EQ(ends([](Miller& m) { m.line(5, 0).plunge(5).line(0, 0); }, blocks), "go");
  }
  EXPECT_EQ(ends([](Miller& m) { m.plunge(4.998); }, true), "fail.geometry SIE-LC75-13");
  EXPECT_EQ(ends([](Miller& m) { m.line(5, 0).plunge(5); }, true), "fail.geometry SIE-LC75-13");
  EXPECT_EQ(ends([](Miller& m) { m.plunge(6); }, true), "fail.region SIE-LC75-13");
}

TEST(PocketMilling, ASubjectThatStopsEarlyIsNoGo) {
  Miller miller{Job()};
  miller.approach().plunge(-3.75).zigzag();
  EXPECT_EQ(told(judge(miller)), "fail.geometry SIE-LC75-04");
}

// To -7.5, infeeds of at most 4: from 0 two of 3.75 or 4 and a rest, from 2 above three of 19/6 or
// 4, 4 and a rest.
TEST(PocketMilling, EachReadingOfTheLevelsIsToldFromTheOthers) {
  struct Division {
    std::string_view infeed;
    std::string_view from;
    std::vector<double> depths;
  };
  const std::vector<Division> all = {
      {"equal", "reference", {-3.75, -7.5}},
      {"max-rest", "reference", {-4, -7.5}},
      {"equal", "clearance", {-1.166667, -4.333333, -7.5}},
      {"max-rest", "clearance", {-2, -6, -7.5}},
  };
  for (const Division& milled : all) {
    Miller miller{Job()};
    miller.approach();
    for (const double depth : milled.depths) miller.plunge(depth).contour_parallel();
    miller.end();
    EXPECT_EQ(told(judge(miller)), "go");
    for (const Division& wanted : all) {
      const Verdict verdict =
          judge(miller, {}, {{"sie.infeed", wanted.infeed}, {"sie.infeed-from", wanted.from}});
      EXPECT_EQ(told(verdict), &milled == &wanted ? "go" : "fail.geometry SIE-LC75-06")
          << milled.infeed << ' ' << milled.from << ' ' << wanted.infeed << ' ' << wanted.from;
    }
    EXPECT_EQ(told(judge(miller, {}, {{"sie.infeed", milled.infeed}, {"sie.infeed-from", "any"}})),
              "go");
  }
}

// With a clearance of 5 and infeeds of 4 the first of three equal levels lies above the part.
TEST(PocketMilling, ALevelInTheAirIsALevel) {
  Job job;
  job.planes = "R101=7 R102=5 R103=0";
  job.infeed = "R121=4.2";
  Miller miller(job);
  miller.approach().lift(7).rapid_down(5);
  for (const double depth : {0.833333, -3.333333, -7.5}) miller.plunge(depth).contour_parallel();
  miller.lift(7).end();
  std::vector<Record> records = miller.records();
  records.erase(records.end() - 2);  // to Z5
  records.erase(records.begin() + 2);
  EXPECT_EQ(told(judge_records(job.program(), records)), "go");
  const Judged equal = {true,
                        profile_802s({{"sie.infeed", "equal"}, {"sie.infeed-from", "clearance"}})};
  EXPECT_EQ(told(judge_records(job.program(), records, equal)), "go");
}

}  // namespace
}  // namespace gonogo::oracle
