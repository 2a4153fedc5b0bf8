// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/known_failures_update.hpp"

#include <gtest/gtest.h>

#include "campaign/results.hpp"

namespace gonogo::oracle {
namespace {

// A run of which every line goes through the findings, as `certify` does it.
class JudgedRun {
 public:
  explicit JudgedRun(std::vector<KnownCause> before)
      : known_(entries_of(before)), update_(std::move(before)) {}

  void judge(const std::string& id, VerdictKind kind, const std::string& deviation = {}) {
    CaseResult result;
    result.id = id;
    result.dialect = "rs274";
    result.cycle = "arc";
    result.verdict.kind = kind;
    result.verdict.message = "It departs.";
    result.verdict.deviation_exact = deviation;
    known_.apply(result);
    const CaseFacts facts = facts_of(case_line(result, true));
    update_.add(facts, facts.verdict, findings_.add(facts.head, facts.verdict));
  }
  KnownFailuresUpdate::Result end(const std::vector<std::string>& corpus) const {
    return update_.result(corpus, {{1, "G0 X1\nG1 X2 F3\n\n"}});
  }

 private:
  KnownFailures known_;
  Findings findings_;
  KnownFailuresUpdate update_;
};

const std::vector<std::string> kCorpus = {"a.000001", "a.000002", "a.000003", "a.000004"};

KnownCause cause_of(std::vector<std::string> globs) {
  KnownCause cause{"R is a diameter", "G2", {}};
  cause.failures.push_back({VerdictKind::fail_geometry, {}, {}, {}, std::move(globs)});
  return cause;
}

TEST(KnownFailuresUpdate, WhatFailsAndIsNotKnownIsACauseForEachFinding) {
  JudgedRun run({});
  run.judge("a.000001", VerdictKind::fail_geometry, "1/2");
  run.judge("a.000002", VerdictKind::fail_geometry, "1/2");
  run.judge("a.000003", VerdictKind::fail_geometry, "3");
  run.judge("a.000004", VerdictKind::pass_exact);
  const auto result = run.end(kCorpus);
  EXPECT_EQ(result.added, 3U);
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes[0].program, "G0 X1 | G1 X2 F3");
  EXPECT_EQ(result.causes[0].reason.find("Not looked at yet: fail.geometry"), 0U);
  ASSERT_EQ(result.causes[0].failures.size(), 2U);
  EXPECT_EQ(result.causes[0].failures[0].deviation, "1/2");
  EXPECT_EQ(result.causes[0].failures[0].cases, std::vector<std::string>{"a.00000[12]"});
  EXPECT_EQ(result.causes[0].failures[1].cases, std::vector<std::string>{"a.000003"});
}

// The same run under the written file is GO, and changes nothing in it.
TEST(KnownFailuresUpdate, WhatIsWrittenExplainsTheRunThatItIsOf) {
  JudgedRun first({});
  const auto judge_all = [](JudgedRun& run) {
    run.judge("a.000001", VerdictKind::fail_geometry, "1/2");
    run.judge("a.000002", VerdictKind::crash);
    run.judge("a.000003", VerdictKind::pass_exact);
  };
  judge_all(first);
  const auto written = first.end(kCorpus);
  JudgedRun second(written.causes);
  judge_all(second);
  const auto again = second.end(kCorpus);
  EXPECT_EQ(again.added, 0U);
  EXPECT_EQ(again.pruned, 0U);
  EXPECT_EQ(known_causes_text(again.causes), known_causes_text(written.causes));
}

TEST(KnownFailuresUpdate, WhatPassesIsPrunedAndTheRestStays) {
  JudgedRun run({cause_of({"a.00000[1-3]"}), cause_of({"a.000004"})});
  run.judge("a.000001", VerdictKind::fail_geometry);
  run.judge("a.000002", VerdictKind::pass_exact);
  run.judge("a.000004", VerdictKind::pass_exact);  // and a.000003 is not run
  const auto result = run.end(kCorpus);
  EXPECT_EQ(result.pruned, 2U);
  EXPECT_EQ(result.added, 0U);
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes[0].reason, "R is a diameter");
  EXPECT_EQ(result.causes[0].program, "G2");
  EXPECT_EQ(result.causes[0].failures[0].cases, (std::vector<std::string>{"a.00000[13]"}));
}

TEST(KnownFailuresUpdate, WhatFailsInAnotherWayIsWrittenAnew) {
  JudgedRun run({cause_of({"a.000001"})});
  run.judge("a.000001", VerdictKind::crash);
  const auto result = run.end(kCorpus);
  EXPECT_EQ(result.pruned, 1U);
  EXPECT_EQ(result.added, 1U);
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes[0].failures[0].verdict, VerdictKind::crash);
}

TEST(KnownFailuresUpdate, AGlobOfNoCaseGoes) {
  JudgedRun run({cause_of({"b.*", "a.000001"})});
  const auto result = run.end(kCorpus);
  ASSERT_EQ(result.causes.size(), 1U);
  EXPECT_EQ(result.causes[0].failures[0].cases, std::vector<std::string>{"a.000001"});
}

TEST(KnownFailuresUpdate, WhatFailsNowAndThenStaysWhenItPasses) {
  KnownCause flaky = cause_of({"a.000001"});
  flaky.failures[0].flaky = Flaky{1, 3};
  JudgedRun run({flaky});
  run.judge("a.000001", VerdictKind::pass_exact);
  EXPECT_EQ(run.end(kCorpus).causes.size(), 1U);
}

TEST(KnownFailuresUpdate, WhatFlickersIsCountedAndNotWritten) {
  JudgedRun run({});
  run.judge("a.000001", VerdictKind::state_leak);
  const auto result = run.end(kCorpus);
  EXPECT_EQ(result.unsteady, 1U);
  EXPECT_TRUE(result.causes.empty());
}

TEST(GlobsOfIds, CoverTheIdsAndNoOther) {
  EXPECT_EQ(globs_of_ids({"a.000003", "a.000001", "a.000002", "a.000005"}),
            std::vector<std::string>{"a.00000[1-35]"});
  EXPECT_EQ(globs_of_ids({"a.000009", "a.000010"}),
            (std::vector<std::string>{"a.000009", "a.000010"}));
  EXPECT_EQ(globs_of_ids({"a.1", "a.12"}), (std::vector<std::string>{"a.1", "a.12"}));
  EXPECT_EQ(globs_of_ids({"x.b", "x.c"}), (std::vector<std::string>{"x.b", "x.c"}));
  EXPECT_TRUE(globs_of_ids({}).empty());
}

}  // namespace
}  // namespace gonogo::oracle
