// SPDX-License-Identifier: GPL-3.0-or-later
//
// Expectations that re-check the evidence of every verdict, on a level of either kind of pocket
// (Job, Pocket).
#pragma once

#include <gtest/gtest.h>

#include "tests/oracle/region/paths.hpp"

namespace gonogo::oracle::region {

template <typename Judged>
testing::AssertionResult is_go(const Judged& job, const LevelVerdict& verdict) {
  if (verdict.kind == LevelVerdict::Kind::gap) return testing::AssertionFailure() << verdict.gap;
  if (verdict.kind == LevelVerdict::Kind::no_go) {
    return testing::AssertionFailure() << "rule " << static_cast<int>(verdict.finding->rule)
                                       << " by " << verdict.finding->deviation.decimal_text(12)
                                       << " at " << verdict.finding->witness.p.decimal_text(9)
                                       << ", " << verdict.finding->witness.q.decimal_text(9) << " "
                                       << flaw_of_finding(job, *verdict.finding);
  }
  const std::string flaw = flaw_of_go(job);
  if (!flaw.empty()) return testing::AssertionFailure() << flaw;
  return testing::AssertionSuccess();
}

template <typename Judged>
testing::AssertionResult breaks(Rule rule, const Judged& job, const LevelVerdict& verdict) {
  if (verdict.kind == LevelVerdict::Kind::gap) return testing::AssertionFailure() << verdict.gap;
  if (verdict.kind == LevelVerdict::Kind::go) return testing::AssertionFailure() << "go";
  if (verdict.finding->rule != rule) {
    return testing::AssertionFailure() << "rule " << static_cast<int>(verdict.finding->rule);
  }
  const std::string flaw = flaw_of_finding(job, *verdict.finding);
  if (!flaw.empty()) return testing::AssertionFailure() << flaw;
  return testing::AssertionSuccess();
}

template <typename Judged>
testing::AssertionResult is_go(const Judged& job) {
  return is_go(job, judge(job));
}
template <typename Judged>
testing::AssertionResult breaks(Rule rule, const Judged& job) {
  return breaks(rule, job, judge(job));
}

}  // namespace gonogo::oracle::region
