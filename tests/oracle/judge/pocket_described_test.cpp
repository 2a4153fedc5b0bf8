// SPDX-License-Identifier: GPL-3.0-or-later
//
// R8, J-PKT-09, J-PKT-10: of LCYC75 nothing but what its clauses describe. Planes: R101 = 5,
// clearance 2, reference 0. Named after the wrong GO that each was.
#include <gtest/gtest.h>

#include "pocket_milling.hpp"

namespace gonogo::oracle {
namespace {

Verdict judge(const Miller& miller, const Job& job) {
  return judge_records(job.program(), miller.records(), {true, profile_802s({})});
}

// From the clearance plane up to Z100 and down again, at a feed.
TEST(DescribedMotions, AFeedFarAboveR101BeforeTheInfeedIsNoGo) {
  for (const char* ways : {"R126=2 R127=1", "R126=2 R127=2"}) {
    Job job;
    job.ways = ways;
    Miller miller(job);
    miller.approach().plunge(100).plunge(2).plunge(-4).contour_parallel();
    const Verdict verdict = judge(miller, job);
    EXPECT_EQ(verdict.kind, VerdictKind::fail_region) << verdict.message;
    EXPECT_FALSE(verdict.witness.empty());
  }
}

TEST(DescribedMotions, AnExcursionInTheAirBeforeTheFirstInfeedIsNoGo) {
  const Job job;
  Miller miller(job);
  miller.approach().line(5, 0).home().plunge(-4).contour_parallel();
  const Verdict verdict = judge(miller, job);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_region) << verdict.message;
  // And round to where it was.
  Miller ring(job);
  ring.approach().arc(0, 0, 5, 0, -1).plunge(-4).contour_parallel();
  EXPECT_EQ(judge(ring, job).kind, VerdictKind::fail_region);
}

TEST(DescribedMotions, ALiftAboveR101BetweenLevelsIsNoGo) {
  const Job job;
  Miller miller(job);
  miller.approach().plunge(-4).contour_parallel().rapid_down(9).rapid_down(-3);
  const Verdict verdict = judge(miller, job);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_region) << verdict.message;
  EXPECT_EQ(reference::clause_name(verdict.clause), "SIE-LC75-13");
}

// J-CMP-12. 7.5 deep in infeeds of at most 4 are two of 3.75; the reading says that they are equal.
TEST(DescribedMotions, ALevelAtAnotherDepthIsToldWithThoseThatAreDue) {
  const Job job;
  const auto judged = [&](const Miller& miller, std::string_view levels) {
    return judge_records(job.program(), miller.records(),
                         {true, profile_802s({{"sie.infeed", levels}})});
  };
  Miller high(job);
  high.approach().plunge(-3).contour_parallel();
  const Verdict named = judged(high, "equal");
  EXPECT_EQ(
      named.message,
      "The depth of the level is none that the infeed admits. It is -3; due are -3.75, -7.5.");
  EXPECT_EQ(named.deviation_exact, "0.75");
  Miller deep(job);
  deep.approach().plunge(-5).contour_parallel();
  const Verdict open = judged(deep, "any");
  EXPECT_NE(open.message.find("It is -5; "), std::string::npos) << open.message;
  EXPECT_FALSE(open.deviation_exact.empty());
  Miller below(job);
  below.approach().plunge(-4).contour_parallel().plunge(-7.75).contour_parallel();
  EXPECT_NE(judged(below, "any").message.find("It is -7.75, below the floor at -7.5."),
            std::string::npos);
}

TEST(DescribedMotions, AFeedThatDiffersIsToldWithTheOneThatIsDue) {
  const Job job;
  Miller miller(job);
  miller.approach().feed_down(100).plunge(-4).contour_parallel();
  EXPECT_EQ(judge(miller, job).message,
            "The feed of the infeed differs. It is 100 mm/min in place of 120 mm/min.");
}

// The second level is missing: 7.5 deep, the first one is at 4.
TEST(DescribedMotions, APocketThatEndsAboveItsFloorIsToldWithBothDepths) {
  const Job job;
  Miller miller(job);
  miller.approach().plunge(-4).contour_parallel().end();
  const Verdict verdict = judge(miller, job);
  EXPECT_EQ(verdict.message,
            "The pocket is not milled to its floor. It is milled to -4 in place of -7.5.");
  EXPECT_EQ(verdict.deviation_exact, "3.5");
}

Job wall_only() {
  Job job;
  job.ways = "R126=2 R127=2";
  job.allowance = "R124=0.75 R125=0";
  return job;
}

TEST(DescribedMotions, ContourOnlyThatClearsTheFloorIsNoGo) {
  const Job job = wall_only();
  Miller miller(job);
  miller.approach().plunge(-8).line(-10, 0).line(10, 0).round(17, 7, 0).round(25, 15, 3).home();
  miller.end();
  const Verdict verdict = judge(miller, job);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_region) << verdict.message;
  EXPECT_EQ(reference::clause_name(verdict.clause), "SIE-LC75-07");
  EXPECT_FALSE(verdict.witness.empty());
}

// Rows 9 apart from wall to wall, for a tool of 10: each touches the strip.
TEST(DescribedMotions, ContourOnlyWithRowsFromWallToWallIsNoGo) {
  const Job job = wall_only();
  Miller miller(job);
  miller.approach().plunge(-8);
  for (const double v : {-9.0, 0.0, 9.0}) miller.line(-25, v).line(25, v);
  miller.round(25, 15, 3).home().end();
  const Verdict verdict = judge(miller, job);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_region) << verdict.message;
  EXPECT_EQ(reference::clause_name(verdict.clause), "SIE-LC75-07");
}

// The contour reaches 10 from the wall: of the 40 by 20 that are left the tool mills all but the
// upper fifth, at R123 or at another feed. Twice the half sides of E: 2 (25 + 15) = 80.
TEST(DescribedMotions, ContourOnlyWithMostOfTheFloorIsNoGo) {
  const Job job = wall_only();
  for (const double feed : {300.0, 120.0}) {
    Miller miller(job);
    miller.approach().plunge(-8).feed_in_plane(feed);
    miller.line(-18, -6).line(18, -6).line(18, 1).line(-18, 1).home().feed_in_plane(300);
    miller.round(25, 15, 3).home().end();
    const Verdict verdict = judge(miller, job);
    EXPECT_EQ(verdict.kind, VerdictKind::fail_region) << verdict.message;
    EXPECT_EQ(reference::clause_name(verdict.clause), "SIE-LC75-07");
  }
}

// Out in a bow and back in one, and the contour twice: long, but next to nothing of the floor.
TEST(DescribedMotions, TheContourTwiceInBowsIsGo) {
  const Job job = wall_only();
  Miller miller(job);
  miller.approach().plunge(-8);
  for (int k = 0; k < 2; ++k) {
    miller.arc(25, 0, 12.5, 0, -1).round(25, 15, 3).arc(0, 0, 12.5, 0, -1);
  }
  const Verdict verdict = judge(miller.end(), job);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
}

// J-PKT-09: onto the floor that roughing left, 8 deep, before the first infeed; and from the
// contour back to the middle at its depth.
TEST(DescribedMotions, ATraverseOnTheFloorIsNoGo) {
  const Job job = wall_only();
  const auto before_infeed = [&](double z) {
    Miller miller(job);
    miller.approach().rapid_down(z).lift(2).rapid_down(-4);
    miller.round(25, 15, 3).home().plunge(-8).round(25, 15, 3).home().end();
    return judge(miller, job);
  };
  EXPECT_EQ(before_infeed(-8).kind, VerdictKind::fail_region);
  EXPECT_EQ(reference::clause_name(before_infeed(-8).clause), "SIE-LC75-11");
  EXPECT_EQ(before_infeed(-7.9995).kind, VerdictKind::fail_region);
  EXPECT_EQ(decision(before_infeed(-7.9).kind), Decision::go) << before_infeed(-7.9).message;
  Miller back(job);
  back.approach().plunge(-8).round(25, 15, 3).rapid(0, 0).end();
  EXPECT_EQ(judge(back, job).kind, VerdictKind::fail_region);
}

TEST(DescribedMotions, ATraverseDownToTheRoughedFloorIsNoGo) {
  const Job job;
  Miller miller(job);
  miller.approach().plunge(-4).contour_parallel().plunge(-7.5).contour_parallel();
  miller.lift(2).rapid_down(-7.5).end();
  EXPECT_EQ(judge(miller, job).kind, VerdictKind::fail_region);
}

// Metres away at every height that the tool comes by.
TEST(DescribedMotions, ExcursionsBesideThePocketAreNoGo) {
  const Job job;
  for (const double z : {5.0, 2.0, 0.0, -3.9}) {
    Miller miller(job);
    miller.approach().plunge(-4).contour_parallel().lift(z).rapid(5000, 0).rapid(0, 0);
    miller.rapid_down(-4).plunge(-7.5).contour_parallel().end();
    EXPECT_EQ(judge(miller, job).kind, VerdictKind::fail_region) << z;
  }
}

// J-CYC-02: turns, whether in records of their own or in one, in a level and on the way.
TEST(DescribedMotions, TurnsOverAndOverAreStopped) {
  const Job job;
  const auto turns = [&](int records, int rot, double z) {
    Miller miller(job);
    miller.approach().plunge(-4).contour_parallel();
    if (z > -4) miller.lift(z);
    miller.line(8, 0);
    for (int k = 0; k < records; ++k) miller.arc(8, 0, 0, 0, rot);
    miller.home();
    if (z > -4) miller.rapid_down(-4);
    miller.plunge(-7.5).contour_parallel().end();
    return judge(miller, job).kind;
  };
  for (const double z : {-4.0, 1.0}) {
    EXPECT_EQ(decision(turns(9, -1, z)), Decision::go) << z;
    EXPECT_EQ(turns(50, -1, z), VerdictKind::fail_overrun) << z;
    EXPECT_EQ(turns(1, -1'000'000'000, z), VerdictKind::fail_overrun) << z;
  }
}

TEST(DescribedMotions, TheContourAloneIsGo) {
  const Job job = wall_only();
  Miller miller(job);
  miller.approach().plunge(-8).round(25, 15, 3).home().end();
  const Verdict verdict = judge(miller, job);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
}

}  // namespace
}  // namespace gonogo::oracle
