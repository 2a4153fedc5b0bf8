// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-CYC-01, J-PKT-09, J-PKT-10: of LCYC75 nothing but what its clauses describe. Planes: R101 = 5,
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
}

TEST(DescribedMotions, ALiftAboveR101BetweenLevelsIsNoGo) {
  const Job job;
  Miller miller(job);
  miller.approach().plunge(-4).contour_parallel().rapid_down(9).rapid_down(-3);
  const Verdict verdict = judge(miller, job);
  EXPECT_EQ(verdict.kind, VerdictKind::fail_region) << verdict.message;
  EXPECT_EQ(reference::clause_name(verdict.clause), "SIE-LC75-13");
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

TEST(DescribedMotions, TheContourAloneIsGo) {
  const Job job = wall_only();
  Miller miller(job);
  miller.approach().plunge(-8).round(25, 15, 3).home().end();
  const Verdict verdict = judge(miller, job);
  EXPECT_EQ(decision(verdict.kind), Decision::go) << verdict.message;
}

}  // namespace
}  // namespace gonogo::oracle
