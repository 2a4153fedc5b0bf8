// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/known_failures.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "campaign/results.hpp"
#include "campaign/tally.hpp"
#include "tests/has.hpp"

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

template <typename Read>
std::string message_of(const Read& read) {
  const auto* fault = std::get_if<FileFault>(&read);
  return fault == nullptr ? "" : fault->message;
}

std::string fault_of(std::string_view toml) {
  return message_of(known_failures_from_toml(toml));
}

std::string map_fault(std::string_view toml) {
  return message_of(alarm_map_from_toml(toml));
}

AlarmMap alarm_map(std::string_view toml) {
  return AlarmMap(std::get<std::vector<AlarmMap::Entry>>(alarm_map_from_toml(toml)));
}

TEST(KnownFailures, AFailureAsKnownIsExpected) {
  CaseResult made = result("ngc.arc.000001", VerdictKind::fail_geometry);
  known(kOneEntry).apply(made);
  EXPECT_EQ(made.verdict.kind, VerdictKind::xfail);
  EXPECT_EQ(made.verdict.known, "a known bug");
  EXPECT_EQ(made.verdict.departure, VerdictKind::fail_geometry);
}

// Reconciled with the run's other readings, it would be a GO again.
TEST(KnownFailures, WhatPassesUnderAnyReadingIsUnexpectedToo) {
  CaseResult made = result("ngc.arc.000001", VerdictKind::pass_exact);
  made.dialect = "rs274";
  made.readings = OpenReadings{{"k"}, {"k=a"}, VerdictKind::pass_exact, {}};
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
  EXPECT_EQ(made.verdict.known, "R is a diameter");
}

TEST(KnownFailures, EveryGlobOfAListHasToHaveACase) {
  KnownFailures failures = known(kOneCause);
  for (const char* id : {"ngc.arc-r.000002", "ngc.arc-r.000004"}) failures.note_case(id);
  ASSERT_EQ(failures.stale().size(), 1U);
  EXPECT_TRUE(has(failures.stale()[0], "ngc.helix.000007"));
}

TEST(KnownFailures, AGlobMayCoverTwentyCasesAndNoMore) {
  KnownFailures failures = known(kOneEntry);
  for (int i = 0; i < 20; ++i) failures.note_case("ngc.arc." + std::to_string(i));
  EXPECT_TRUE(failures.stale().empty());
  failures.note_case("ngc.arc.20");
  ASSERT_EQ(failures.stale().size(), 1U);
  EXPECT_TRUE(has(failures.stale()[0], "covers 21 cases"));
}

TEST(KnownFailures, AGlobOfWildcardsAloneIsRefused) {
  for (const char* glob : {"*", "**", "?*", ""}) {
    EXPECT_TRUE(has(fault_of(std::string("[[failure]]\ncases = \"") + glob +
                             "\"\nverdict = \"crash\"\nreason = \"r\"\n"),
                    "covers everything"))
        << glob;
  }
}

TEST(KnownFailures, ACauseThatCannotBeUsedIsRefused) {
  const std::string head = "[[cause]]\nreason = \"r\"\n";
  const std::string failure = "[[cause.failure]]\nverdict = \"fail.feed\"\n";
  EXPECT_TRUE(has(fault_of(head), "[[cause.failure]]"));
  EXPECT_TRUE(has(fault_of(head + "failure = 1\n"), "line 3"));
  EXPECT_TRUE(has(fault_of(head + failure), "`cases`"));
  EXPECT_TRUE(has(fault_of(head + failure + "cases = []\n"), "empty"));
  EXPECT_TRUE(has(fault_of(head + failure + "cases = [1]\n"), "line 5"));
  EXPECT_TRUE(has(fault_of(head + failure + "cases = \"a\"\nreason = \"r\"\n"), "no key `reason`"));
  EXPECT_TRUE(has(fault_of("[[cause]]\n" + failure + "cases = \"a\"\n"), "reason"));
}

TEST(KnownFailures, AnEntryOfNoCaseIsStale) {
  KnownFailures failures = known(kOneEntry);
  failures.note_case("ngc.basic.000001");
  ASSERT_EQ(failures.stale().size(), 1U);
  EXPECT_TRUE(has(failures.stale()[0], "ngc.arc.*"));
  failures.note_case("ngc.arc.000007");
  EXPECT_TRUE(failures.stale().empty());
}

TEST(KnownFailures, AnEntryThatCannotBeUsedIsRefusedWithItsLine) {
  EXPECT_TRUE(has(fault_of("x = 1\n"), "line 1"));
  EXPECT_TRUE(has(fault_of("[[failure]]\ncases = \"a\"\nverdict = \"fail.geometry\"\n"), "reason"));
  EXPECT_TRUE(
      has(fault_of("[[failure]]\ncases = \"a\"\nverdict = \"pass-exact\"\nreason = \"r\"\n"),
          "pass-exact"));
  EXPECT_TRUE(has(fault_of("[[failure]]\ncase = \"a\"\n"), "no key `case`"));
  EXPECT_TRUE(has(fault_of("[[failure]\n"), "line 1"));
}

constexpr std::string_view kFlaky =
    "[[failure]]\ncases = \"ngc.arc.000001\"\nverdict = \"crash\"\nflaky = \"2 of 5\"\n"
    "reason = \"a race\"\n";

TEST(KnownFailures, WhatFailsNowAndThenMayPassAndIsNeverExpectedToFail) {
  const KnownFailures failures = known(kFlaky);
  EXPECT_EQ(after(failures, result("ngc.arc.000001", VerdictKind::pass_exact)),
            VerdictKind::pass_exact);
  EXPECT_EQ(after(failures, result("ngc.arc.000001", VerdictKind::crash)), VerdictKind::crash);
  Verdict crashed;
  crashed.kind = VerdictKind::crash;
  const KnownFailure* const entry = failures.flaky_entry("ngc.arc.000001", crashed);
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->flaky->failures, 2);
  EXPECT_EQ(entry->flaky->runs, 5);
  EXPECT_EQ(failures.flaky_entry("ngc.arc.000002", crashed), nullptr);
  crashed.kind = VerdictKind::timeout;
  EXPECT_EQ(failures.flaky_entry("ngc.arc.000001", crashed), nullptr);
}

TEST(KnownFailures, ABoundThatHidesEveryFailureIsRefused) {
  for (const char* bound :
       {"5 of 5", "6 of 5", "0 of 5", "-1 of 5", "1 of 101", "1 of", "1of5", "1 of 5x", "often"}) {
    const std::string text = std::string("[[failure]]\ncases = \"a\"\nverdict = \"crash\"\n") +
                             "reason = \"r\"\nflaky = \"" + bound + "\"\n";
    EXPECT_TRUE(has(fault_of(text), "fewer than all, of at most 100")) << bound;
  }
}

TEST(KnownFailures, WhatIsWrittenIsReadAsTheSame) {
  KnownCause cause{"it's \"odd\"", "G0 X1 | (\t\\)", {}};
  cause.failures.push_back({VerdictKind::fail_geometry,
                            "4/3",
                            R"({"k":"dwell","s":"it's"})",
                            std::nullopt,
                            {"ngc.arc.00000[1-3]", "ngc.arc.000007"}});
  cause.failures.push_back({VerdictKind::crash, {}, R"({"k":"m"})", Flaky{1, 3}, {}});
  for (int i = 0; i < 30; ++i) cause.failures[1].cases.push_back("ngc.arc-r." + std::to_string(i));
  const std::string text = known_causes_text({cause, cause});
  auto read = known_causes_from_toml(text);
  ASSERT_TRUE(std::holds_alternative<std::vector<KnownCause>>(read)) << fault_of(text);
  const auto& causes = std::get<std::vector<KnownCause>>(read);
  ASSERT_EQ(causes.size(), 2U);
  EXPECT_EQ(causes[1].reason, cause.reason);
  EXPECT_EQ(causes[1].program, cause.program);
  ASSERT_EQ(causes[1].failures.size(), 2U);
  EXPECT_EQ(causes[1].failures[0].deviation, "4/3");
  EXPECT_EQ(causes[1].failures[0].got, cause.failures[0].got);
  EXPECT_EQ(causes[1].failures[0].cases, cause.failures[0].cases);
  EXPECT_FALSE(causes[1].failures[0].flaky);
  EXPECT_EQ(causes[1].failures[1].cases, cause.failures[1].cases);
  EXPECT_EQ(causes[1].failures[1].flaky->runs, 3);
  EXPECT_EQ(known_causes_text(causes), text);
}

TEST(AlarmMap, MapsTheSubjectsOwnTexts) {
  const AlarmMap map =
      alarm_map("[alarms]\n\"PS0061\" = \"value-sign\"\n\"Zero-radius*\" = \"arc-radius\"\n");
  ASSERT_NE(map.entry_for("PS0061"), nullptr);
  EXPECT_EQ(map.entry_for("PS0061")->alarm_class, "value-sign");
  ASSERT_NE(map.entry_for("Zero-radius arc: start=(X1)"), nullptr);
  EXPECT_EQ(map.entry_for("Zero-radius arc: start=(X1)")->native, "Zero-radius*");
  EXPECT_EQ(map.entry_for("PS0062"), nullptr);
  EXPECT_EQ(map.natives(), (std::vector<std::string>{"PS0061", "Zero-radius*"}));
}

TEST(AlarmMap, ATextMayStandForSeveralClasses) {
  const AlarmMap map = alarm_map("[alarms]\n\"E\" = [\"value-sign\", \"value-out-of-range\"]\n");
  RunEnd end;
  end.kind = RunEnd::Kind::alarm;
  end.alarm.native = "E";
  ASSERT_NE(map.name_class(end), nullptr);
  EXPECT_EQ(end.alarm.alarm_class, "value-sign value-out-of-range");
}

TEST(AlarmMap, ATextStandsForThreeClassesAtMost) {
  EXPECT_TRUE(has(
      map_fault("[alarms]\n\"E*\" = [\"value-sign\", \"syntax\", \"no-tool\", \"unused-word\"]\n"),
      "3 classes"));
}

// One that stands for every text makes any alarm right where one of its classes is due.
TEST(AlarmMap, AnEntryOfWildcardsAloneIsRefused) {
  for (const char* native : {"*", "?", "**", "?*"}) {
    EXPECT_EQ(
        map_fault(fmt::format("[alarms]\n\"E1\" = \"syntax\"\n\"{}\" = \"syntax\"\n", native)),
        fmt::format("line 3: \"{}\" is every alarm. Name the texts.", native));
  }
}

// docs/known-failures.md: the first that matches, in the file; its keys would sort otherwise.
TEST(AlarmMap, TheFirstLineThatMatchesCountsAndGoesBeforeTheSubjectsOwnClass) {
  const AlarmMap map =
      alarm_map("[alarms]\n\"Zero radius\" = \"arc-radius\"\n\"Zero*\" = \"value-sign\"\n");
  EXPECT_EQ(map.natives(), (std::vector<std::string>{"Zero radius", "Zero*"}));
  RunEnd end;
  end.kind = RunEnd::Kind::alarm;
  end.alarm.native = "Zero radius";
  end.alarm.alarm_class = "syntax";
  ASSERT_NE(map.name_class(end), nullptr);
  EXPECT_EQ(end.alarm.alarm_class, "arc-radius");
}

TEST(AlarmMap, AClassThatDoesNotExistIsRefused) {
  for (const char* classes : {"\"sign\"", "[\"value-sign\", \"sign\"]"}) {
    EXPECT_TRUE(has(map_fault(std::string("[alarms]\n\"PS0061\" = ") + classes + "\n"), "\"sign\""))
        << classes;
  }
}

TEST(AlarmMap, AListHasOneClassAtLeastAndTextsOnly) {
  for (const char* classes : {"[]", "[1]", "1"}) {
    EXPECT_NE(map_fault(std::string("[alarms]\n\"PS0061\" = ") + classes + "\n"), "") << classes;
  }
}

}  // namespace
}  // namespace gonogo::oracle
