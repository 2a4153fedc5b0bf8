// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/campaign/known_failures.hpp"

#include <gtest/gtest.h>

#include "oracle/campaign/results.hpp"
#include "oracle/campaign/tally.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::string_view kOneEntry =
    "[[failure]]\ncases = \"ngc.arc.*\"\nverdict = \"fail.geometry\"\nreason = \"a known bug\"\n";

KnownFailures known(std::string_view toml) {
  auto read = known_failures_from_toml(toml);
  EXPECT_TRUE(std::holds_alternative<std::vector<KnownFailure>>(read));
  return KnownFailures(std::get<std::vector<KnownFailure>>(std::move(read)));
}

CaseResult result(std::string id, VerdictKind kind, std::string deviation = {}) {
  CaseResult made;
  made.id = std::move(id);
  made.verdict.kind = kind;
  made.verdict.deviation_exact = std::move(deviation);
  return made;
}

VerdictKind after(const KnownFailures& failures, CaseResult made) {
  failures.apply(made);
  return made.verdict.kind;
}

std::string fault_of(std::string_view toml) {
  auto read = known_failures_from_toml(toml);
  auto* fault = std::get_if<FileFault>(&read);
  return fault == nullptr ? "" : fault->message;
}

TEST(KnownFailures, AFailureAsKnownIsExpected) {
  CaseResult made = result("ngc.arc.000001", VerdictKind::fail_geometry);
  known(kOneEntry).apply(made);
  EXPECT_EQ(made.verdict.kind, VerdictKind::xfail);
  EXPECT_NE(made.verdict.message.find("a known bug"), std::string::npos);
  EXPECT_NE(made.verdict.message.find("fail.geometry"), std::string::npos);
}

// Reconciled with the run's other readings, it would be a GO again.
TEST(KnownFailures, WhatPassesUnderAnyReadingIsUnexpectedToo) {
  CaseResult made = result("ngc.arc.000001", VerdictKind::pass_exact);
  made.dialect = "rs274";
  made.readings = OpenReadings{{"k"}, {"k=a"}, VerdictKind::pass_exact};
  known(kOneEntry).apply(made);
  Tally tally;
  EXPECT_EQ(tally.add(facts_of(case_line(made, true))), VerdictKind::xpass);
}

TEST(KnownFailures, AnotherFailureStays) {
  const KnownFailures failures = known(kOneEntry);
  EXPECT_EQ(after(failures, result("ngc.arc.000001", VerdictKind::fail_feed)),
            VerdictKind::fail_feed);
  EXPECT_EQ(after(failures, result("ngc.basic.000001", VerdictKind::fail_geometry)),
            VerdictKind::fail_geometry);
}

TEST(KnownFailures, AKnownFailureThatPassesIsAFinding) {
  const KnownFailures failures = known(kOneEntry);
  EXPECT_EQ(after(failures, result("ngc.arc.000001", VerdictKind::pass_exact)), VerdictKind::xpass);
  EXPECT_EQ(after(failures, result("ngc.basic.000001", VerdictKind::pass_exact)),
            VerdictKind::pass_exact);
}

TEST(KnownFailures, ACaseThatWasNotJudgedSaysNothing) {
  const KnownFailures failures = known(kOneEntry);
  for (VerdictKind kind : {VerdictKind::skip, VerdictKind::advice, VerdictKind::oracle_gap}) {
    EXPECT_EQ(after(failures, result("ngc.arc.000001", kind)), kind);
  }
}

TEST(KnownFailures, ADeviationHasToBeExactlyTheKnownOne) {
  const KnownFailures failures = known(
      "[[failure]]\ncases = \"a\"\nverdict = \"fail.geometry\"\ndeviation = \"1/3\"\n"
      "reason = \"off by a third\"\n");
  EXPECT_EQ(after(failures, result("a", VerdictKind::fail_geometry, "1/3")), VerdictKind::xfail);
  EXPECT_EQ(after(failures, result("a", VerdictKind::fail_geometry, "2/3")),
            VerdictKind::fail_geometry);
}

TEST(KnownFailures, WhatCameHasToBeExactlyWhatIsKnown) {
  const KnownFailures failures = known(
      "[[failure]]\ncases = \"a\"\nverdict = \"fail.feed\"\ngot = '{\"f\":\"1\"}'\n"
      "reason = \"the power-on feed\"\n");
  CaseResult made = result("a", VerdictKind::fail_feed);
  made.verdict.got = R"({"f":"1"})";
  EXPECT_EQ(after(failures, made), VerdictKind::xfail);
  made.verdict.got = R"({"f":"2"})";
  EXPECT_EQ(after(failures, made), VerdictKind::fail_feed);
}

constexpr std::string_view kOneCause =
    "[[cause]]\nreason = \"R is a diameter\"\nprogram = \"G2 X20 R5 F100\"\n"
    "[[cause.failure]]\ncases = [\"ngc.arc-r.00000[1-3]\", \"ngc.helix.000007\"]\n"
    "verdict = \"fail.geometry\"\ndeviation = \"5\"\n"
    "[[cause.failure]]\ncases = \"ngc.arc-r.000004\"\nverdict = \"fail.alarm-missing\"\n";

TEST(KnownFailures, ACauseHasManyFailures) {
  const KnownFailures failures = known(kOneCause);
  for (const char* id : {"ngc.arc-r.000001", "ngc.arc-r.000003", "ngc.helix.000007"}) {
    EXPECT_EQ(after(failures, result(id, VerdictKind::fail_geometry, "5")), VerdictKind::xfail);
    EXPECT_EQ(after(failures, result(id, VerdictKind::fail_geometry, "6")),
              VerdictKind::fail_geometry);
  }
  EXPECT_EQ(after(failures, result("ngc.arc-r.000004", VerdictKind::fail_alarm_missing)),
            VerdictKind::xfail);
  EXPECT_EQ(after(failures, result("ngc.arc-r.000004", VerdictKind::fail_geometry, "5")),
            VerdictKind::fail_geometry);
  CaseResult made = result("ngc.helix.000007", VerdictKind::fail_geometry, "5");
  failures.apply(made);
  EXPECT_NE(made.verdict.message.find("R is a diameter"), std::string::npos);
}

TEST(KnownFailures, EveryGlobOfAListHasToHaveACase) {
  KnownFailures failures = known(kOneCause);
  for (const char* id : {"ngc.arc-r.000002", "ngc.arc-r.000004"}) failures.note_case(id);
  ASSERT_EQ(failures.stale().size(), 1U);
  EXPECT_NE(failures.stale()[0].find("ngc.helix.000007"), std::string::npos);
}

TEST(KnownFailures, AGlobMayCoverTwentyCasesAndNoMore) {
  KnownFailures failures = known(kOneEntry);
  for (int i = 0; i < 20; ++i) failures.note_case("ngc.arc." + std::to_string(i));
  EXPECT_TRUE(failures.stale().empty());
  failures.note_case("ngc.arc.20");
  ASSERT_EQ(failures.stale().size(), 1U);
  EXPECT_NE(failures.stale()[0].find("covers 21 cases"), std::string::npos);
}

TEST(KnownFailures, AGlobOfWildcardsAloneIsRefused) {
  for (const char* glob : {"*", "**", "?*", ""}) {
    EXPECT_NE(fault_of(std::string("[[failure]]\ncases = \"") + glob +
                       "\"\nverdict = \"crash\"\nreason = \"r\"\n")
                  .find("covers everything"),
              std::string::npos)
        << glob;
  }
}

TEST(KnownFailures, ACauseThatCannotBeUsedIsRefused) {
  const std::string head = "[[cause]]\nreason = \"r\"\n";
  const std::string failure = "[[cause.failure]]\nverdict = \"fail.feed\"\n";
  EXPECT_NE(fault_of(head).find("[[cause.failure]]"), std::string::npos);
  EXPECT_NE(fault_of(head + "failure = 1\n").find("line 3"), std::string::npos);
  EXPECT_NE(fault_of(head + failure).find("`cases`"), std::string::npos);
  EXPECT_NE(fault_of(head + failure + "cases = []\n").find("empty"), std::string::npos);
  EXPECT_NE(fault_of(head + failure + "cases = [1]\n").find("line 5"), std::string::npos);
  EXPECT_NE(fault_of(head + failure + "cases = \"a\"\nreason = \"r\"\n").find("no key `reason`"),
            std::string::npos);
  EXPECT_NE(fault_of("[[cause]]\n" + failure + "cases = \"a\"\n").find("reason"),
            std::string::npos);
}

TEST(KnownFailures, AnEntryOfNoCaseIsStale) {
  KnownFailures failures = known(kOneEntry);
  failures.note_case("ngc.basic.000001");
  ASSERT_EQ(failures.stale().size(), 1U);
  EXPECT_NE(failures.stale()[0].find("ngc.arc.*"), std::string::npos);
  failures.note_case("ngc.arc.000007");
  EXPECT_TRUE(failures.stale().empty());
}

TEST(KnownFailures, AnEntryThatCannotBeUsedIsRefusedWithItsLine) {
  EXPECT_NE(fault_of("x = 1\n").find("line 1"), std::string::npos);
  EXPECT_NE(fault_of("[[failure]]\ncases = \"a\"\nverdict = \"fail.geometry\"\n").find("reason"),
            std::string::npos);
  EXPECT_NE(fault_of("[[failure]]\ncases = \"a\"\nverdict = \"pass-exact\"\nreason = \"r\"\n")
                .find("pass-exact"),
            std::string::npos);
  EXPECT_NE(fault_of("[[failure]]\ncase = \"a\"\n").find("no key `case`"), std::string::npos);
  EXPECT_NE(fault_of("[[failure]\n").find("line 1"), std::string::npos);
}

TEST(AlarmMap, MapsTheSubjectsOwnTexts) {
  auto read = alarm_map_from_toml(
      "[alarms]\n\"PS0061\" = \"value-sign\"\n\"Zero-radius*\" = \"arc-radius\"\n");
  const AlarmMap map(std::get<std::vector<AlarmMap::Entry>>(std::move(read)));
  ASSERT_NE(map.entry_for("PS0061"), nullptr);
  EXPECT_EQ(map.entry_for("PS0061")->alarm_class, "value-sign");
  ASSERT_NE(map.entry_for("Zero-radius arc: start=(X1)"), nullptr);
  EXPECT_EQ(map.entry_for("Zero-radius arc: start=(X1)")->native, "Zero-radius*");
  EXPECT_EQ(map.entry_for("PS0062"), nullptr);
  EXPECT_EQ(map.natives(), (std::vector<std::string>{"PS0061", "Zero-radius*"}));
}

TEST(AlarmMap, AClassThatDoesNotExistIsRefused) {
  auto read = alarm_map_from_toml("[alarms]\n\"PS0061\" = \"sign\"\n");
  ASSERT_TRUE(std::holds_alternative<FileFault>(read));
  EXPECT_NE(std::get<FileFault>(read).message.find("sign"), std::string::npos);
}

}  // namespace
}  // namespace gonogo::oracle
