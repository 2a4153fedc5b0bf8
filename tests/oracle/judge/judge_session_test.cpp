// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which of the verdicts under several combinations of readings counts.
#include <gtest/gtest.h>

#include "oracle/judge/judge_session.hpp"
#include "oracle/judge/verdict_ranking.hpp"

namespace gonogo::oracle {
namespace {

SampledVerdict said(VerdictKind kind, std::size_t progress) {
  SampledVerdict said;
  said.verdict.kind = kind;
  said.progress = progress;
  return said;
}

TEST(JudgeSession, APassCountsBeforeAGapAndAGapBeforeANoGo) {
  const SampledVerdict pass = said(VerdictKind::pass_tolerance, 1);
  const SampledVerdict gap = said(VerdictKind::oracle_gap, 1);
  // However far it came.
  const SampledVerdict no_go = said(VerdictKind::fail_geometry, 9);
  EXPECT_TRUE(outranks(pass, gap));
  EXPECT_TRUE(outranks(gap, no_go));
  EXPECT_TRUE(outranks(pass, no_go));
  EXPECT_FALSE(outranks(gap, pass));
  EXPECT_FALSE(outranks(no_go, gap));
  EXPECT_FALSE(outranks(no_go, pass));
}

TEST(JudgeSession, TheBetterPassCountsAndTheLaterDeparture) {
  EXPECT_TRUE(outranks(said(VerdictKind::pass_exact, 1), said(VerdictKind::pass_rounded, 9)));
  EXPECT_FALSE(outranks(said(VerdictKind::pass_rounded, 9), said(VerdictKind::pass_exact, 1)));
  EXPECT_TRUE(outranks(said(VerdictKind::fail_feed, 3), said(VerdictKind::fail_geometry, 2)));
  EXPECT_FALSE(outranks(said(VerdictKind::fail_feed, 2), said(VerdictKind::fail_geometry, 2)));
}

// A wrong path is told as one, and not as the alarm that another alternative would have given.
TEST(JudgeSession, AMotionThatDepartsCountsBeforeAnAlarmThatIsMissingOrLate) {
  for (const VerdictKind alarm : {VerdictKind::fail_alarm_missing, VerdictKind::fail_alarm_late}) {
    EXPECT_TRUE(outranks(said(VerdictKind::fail_geometry, 2), said(alarm, 2)));
    EXPECT_FALSE(outranks(said(alarm, 2), said(VerdictKind::fail_geometry, 2)));
    EXPECT_TRUE(outranks(said(alarm, 3), said(VerdictKind::fail_geometry, 2)));
  }
}

// J-RUN-05: G0 X10 goes to a radius of 5, and the record says 6.
TEST(JudgeSession, WhatCameBeforeASkipIsNotJudged) {
  const auto profile = std::get<reference::Profile>(reference::default_profile("gsk988ta"));
  Record wrong;
  wrong.block = 1;
  wrong.axes = {reference::Axis::x};
  wrong.to[reference::Axis::x] = 6;
  const std::vector<Record> records = {wrong};
  const auto judged = [&](const RunEnd& end) {
    return judge_outcome(profile, std::string_view("G0 X10\n"), Tolerances{}, records, end).verdict;
  };
  for (const auto kind : {RunEnd::Kind::skip, RunEnd::Kind::refused}) {
    RunEnd end = RunEnd::of(kind, "no arcs");
    end.feature = "arc";
    const Verdict verdict = judged(end);
    EXPECT_EQ(verdict.kind, VerdictKind::skip);
    EXPECT_EQ(verdict.feature, "arc");
    EXPECT_EQ(verdict.message, "no arcs");
  }
  EXPECT_EQ(judged(RunEnd::of(RunEnd::Kind::stopped, "")).kind, VerdictKind::fail_geometry);
}

}  // namespace
}  // namespace gonogo::oracle
