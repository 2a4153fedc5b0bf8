// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a campaign says of subjects that hang, crash, skip or answer otherwise the next time.
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

#include "campaign_testing.hpp"

namespace gonogo::oracle {
namespace {

// J-RUN-08: a subject that hangs at every third program of a process.
TEST(Campaign, AHangThatFreshProcessesDoNotShareIsAStateLeak) {
  const Scratch scratch(3);
  const FakeSubject hangs = acting([](std::string_view, int runs) -> std::optional<RunEnd> {
    if (runs % 3 != 0) return std::nullopt;
    return ended(RunEnd::Kind::timeout);
  });
  const std::string footer = results_of(scratch, hangs);
  EXPECT_TRUE(has(footer, "\"pass-exact\":2,\"state-leak\":1"));
  EXPECT_TRUE(has(scratch.read("r"), "3 times out of 3"));
  EXPECT_TRUE(has(scratch.read("r"), "\"attempts\":4"));
}

// J-RUN-08: the process grows from program to program; a fresh one has room.
TEST(Campaign, TooMuchMemoryIsToldAsThatWhateverAFreshProcessDoes) {
  const Scratch scratch(3);
  for (const bool in_fresh : {false, true}) {
    const FakeSubject grows = acting([&](std::string_view id, int runs) -> std::optional<RunEnd> {
      if (id != "t.000002") return std::nullopt;
      if ((runs == 1) == in_fresh) return ended(RunEnd::Kind::out_of_memory);
      return in_fresh ? std::optional(ended(RunEnd::Kind::crash)) : std::nullopt;
    });
    const std::string footer = results_of(scratch, grows);
    EXPECT_TRUE(has(footer, "\"out-of-memory\":1"));
    EXPECT_FALSE(has(footer, "state-leak"));
  }
}

TEST(Campaign, ASubjectThatDiesAtOnceInEveryCaseIsNotJudged) {
  const Scratch scratch(8);
  FakeSubject dies;
  dies.info.emplace();
  dies.info->everything = true;
  dies.info->greeted = false;
  dies.act = [](std::string_view, int) -> std::optional<RunEnd> {
    RunEnd end = ended(RunEnd::Kind::crash);
    end.notes = "no such script";
    return end;
  };
  try {
    results_of(scratch, dies);
    FAIL() << "it was judged";
  } catch (const SubjectUnusable& unusable) {
    EXPECT_TRUE(has(unusable.what(), "no such script"));
  }
  // An interpreter whose script is missing or broken often exits with 1, which is an alarm's code.
  FakeSubject exits = dies;
  exits.act = [](std::string_view, int) { return ended(RunEnd::Kind::protocol); };
  EXPECT_THROW(results_of(scratch, exits), SubjectUnusable);
  // One that has said who it is may be right of other programs: twenty cases show that it is not.
  dies.info->greeted = true;
  EXPECT_TRUE(has(results_of(scratch, dies), "\"crash\":8"));
  const Scratch more(20);
  EXPECT_THROW(results_of(more, dies), SubjectUnusable);
  dies.info->greeted = false;
  // One that answers once is at work.
  FakeSubject lives;
  lives.info = dies.info;
  lives.info->features = {"blocks"};
  lives.act = [](std::string_view id, int) -> std::optional<RunEnd> {
    if (id == "t.000001") return std::nullopt;
    return ended(RunEnd::Kind::crash);
  };
  EXPECT_TRUE(has(results_of(scratch, lives), "\"crash\":7"));
}

SubjectInfo declaring(std::map<std::string, std::set<std::string>> dialects) {
  SubjectInfo info;
  info.dialects = std::move(dialects);
  info.features = {"blocks"};
  return info;
}

FakeSubject skipping_all_but(const std::string& judged, const std::string& feature) {
  const FakeSubject skips =
      acting([judged, feature](std::string_view id, int) -> std::optional<RunEnd> {
        if (id == judged) return std::nullopt;
        RunEnd end = ended(RunEnd::Kind::skip);
        end.feature = feature;
        return end;
      });
  return skips;
}

// J-RUN-05: the cases need `basic`, which it declares; it may name any reason.
TEST(Campaign, ASkipInsideADeclaredFeatureIsAFailureOfTheDeclaration) {
  const Scratch scratch(10);
  for (const char* reason : {"basic", "g116", "bytes of mine", ""}) {
    FakeSubject skips = skipping_all_but("t.000003", reason);
    skips.info = declaring({{"gsk988ta", {"basic"}}});
    const std::string footer = results_of(scratch, skips);
    EXPECT_TRUE(has(footer, "\"decision\":\"NO-GO\""));
    EXPECT_TRUE(has(footer, "\"fail.declaration\":9,\"pass-exact\":1"));
    EXPECT_TRUE(has(footer,
                    "NO-GO: basic of gsk988ta fails 9 of 10 cases; 1 of 10 judged is GO; "
                    "declared, but skipped: basic of gsk988ta (9 cases)"));
  }
}

// J-RUN-05, J-RUN-14: a subject that declares nothing claims what it does not skip, and one case of
// ten is not the feature.
TEST(Campaign, ASubjectThatSkipsAllButOneIsGoForNoFeature) {
  const Scratch scratch(10);
  const std::string footer = results_of(scratch, skipping_all_but("t.000003", "g90"));
  EXPECT_TRUE(has(footer,
                  "\"head\":\"GO: 1 judged; not claimed: 9 cases; not judged for the most "
                  "part: basic (1 of 10 cases); not compared: M functions (g33.1, g74, g84, "
                  "g86 of rs274 pass some on themselves), source lines; fresh programs: "
                  "none\""));
}

// What it calls its reason is none of a declaration that it does not make.
TEST(Campaign, ASkippedFeatureIsUndeclaredOnlyWhereTheSubjectDeclares) {
  const Scratch scratch(10);
  const std::string footer = results_of(scratch, skipping_all_but("t.000003", "basic"));
  EXPECT_TRUE(has(footer,
                  "\"head\":\"GO: 1 judged; not claimed: 9 cases; not judged for the most "
                  "part: basic (1 of 10 cases)"));
}

TEST(Campaign, ASubjectThatDeclaresLittleIsAskedForNoMore) {
  const Scratch scratch(10);
  FakeSubject little;
  little.info = declaring({{"gsk988ta", {"g94"}}});
  const std::string footer = results_of(scratch, little);
  EXPECT_TRUE(has(footer,
                  "\"head\":\"UNDECIDED: 0 judged; not claimed: basic (10 cases); not "
                  "compared: M functions, source lines; fresh programs: "
                  "none\""));
}

TEST(Campaign, ToRefuseTheProfileOfDefaultsIsAFailureOfTheDeclaration) {
  const Scratch scratch(2);
  FakeSubject refuses;
  refuses.info = declaring({{"gsk988ta", {}}});
  refuses.act = [](std::string_view, int) { return ended(RunEnd::Kind::refused); };
  EXPECT_TRUE(has(results_of(scratch, refuses), "\"fail.declaration\":2"));
}

TEST(Campaign, ANoGoThatAFreshProcessDoesNotShareIsAStateLeak) {
  const Scratch scratch(3);
  const FakeSubject leaky = acting([](std::string_view, int runs) -> std::optional<RunEnd> {
    if (runs < 3) return std::nullopt;
    return RunEnd{};  // no records at all
  });
  EXPECT_TRUE(has(results_of(scratch, leaky), "\"pass-exact\":2,\"state-leak\":1"));
}

TEST(Campaign, AFailureThatComesAgainKeepsItsNameAndItsAttempts) {
  const Scratch scratch(1);
  const FakeSubject wrong =
      acting([](std::string_view, int) { return RunEnd{}; });  // no records at all
  results_of(scratch, wrong);
  EXPECT_TRUE(has(scratch.read("r"), "\"verdict\":\"fail.geometry\""));
  EXPECT_TRUE(has(scratch.read("r"), "\"attempts\":2"));
}

TEST(Campaign, NotesOfAFailureAreOfTheRunInWhichNothingWasAhead) {
  const Scratch scratch(2);
  const FakeSubject wrong = acting([](std::string_view, int runs) -> std::optional<RunEnd> {
    RunEnd end;
    end.notes = runs == 1 ? std::string("alone") : std::string("beside");
    return end;
  });
  results_of(scratch, wrong);
  EXPECT_TRUE(has(scratch.read("r"), "\"notes\":\"alone\""));
  EXPECT_FALSE(has(scratch.read("r"), "beside"));
}

TEST(Campaign, ATimeoutIsTriedThreeTimesMore) {
  const Scratch scratch(1);
  const FakeSubject hanging =
      acting([](std::string_view, int) { return ended(RunEnd::Kind::timeout); });
  results_of(scratch, hanging);
  EXPECT_TRUE(has(scratch.read("r"), "\"verdict\":\"timeout\""));
  EXPECT_TRUE(has(scratch.read("r"), "\"attempts\":4"));
}

// How many records have come by then is another number each time.
// J-RUN-08: no answer in time is no other answer.
TEST(Campaign, ACrashAndThenATimeoutIsACrash) {
  const Scratch scratch(1);
  FakeSubject subject;
  int all = 0;
  subject.act = [&all](std::string_view, int) {
    return ended(all++ == 0 ? RunEnd::Kind::crash : RunEnd::Kind::timeout);
  };
  results_of(scratch, subject);
  EXPECT_TRUE(has(scratch.read("r"), "\"verdict\":\"crash\""));
  all = 0;
  subject.act = [&all](std::string_view, int) {
    return ended(all++ > 0 ? RunEnd::Kind::crash : RunEnd::Kind::timeout);
  };
  results_of(scratch, subject);
  EXPECT_TRUE(has(scratch.read("r"), "\"verdict\":\"crash\""));
}

// J-RUN-08.
TEST(Campaign, AProgramThatTheCorpusDoesNotCoverNeverFailsByItsTime) {
  const Scratch scratch(1);
  Case outside;
  outside.id = "t.basic.000001";
  outside.comment = "G71 is not read.";
  outside.program = "G71 U1 R1\n";
  outside.provenance = "hand";
  outside.group = "t";
  outside.features = {"basic"};
  outside.clauses = {"GSK-COM-05"};
  outside.dialect = "gsk988ta";
  outside.cycle = "basic";
  outside.profile = std::get<reference::Profile>(reference::default_profile("gsk988ta"));
  outside.expect = {expectation_of(outside.profile, outside.program)};
  ASSERT_TRUE(outside.expect.front().not_covered);
  // In the place of the one file that is there.
  scratch.write("corpus/vectors/gsk988ta/f0000.json", vector_file_text("2026.1.0", {outside}));
  const FakeSubject hangs =
      acting([](std::string_view, int) { return ended(RunEnd::Kind::timeout); });
  results_of(scratch, hangs);
  EXPECT_TRUE(has(scratch.read("r"), "\"verdict\":\"oracle-gap\",\"expected\":true"));
}

TEST(Campaign, ATimeoutHasNoTrace) {
  const Scratch scratch(1);
  FakeSubject slow;
  slow.end = RunEnd::Kind::timeout;
  results_of(scratch, slow);
  EXPECT_TRUE(has(scratch.read("r"), "\"trace\":[]"));
}

TEST(Campaign, ASubjectThatWasGivenUpIsNotRunAgain) {
  const Scratch scratch(1);
  const FakeSubject gone = acting([](std::string_view, int) -> std::optional<RunEnd> {
    RunEnd end;
    end.kind = RunEnd::Kind::crash;
    end.given_up = true;
    return end;
  });
  results_of(scratch, gone);
  EXPECT_TRUE(has(scratch.read("r"), "\"attempts\":1"));
}

// Every case has an entry with the verdict of a trace without records, 1 of 4 runs.
CampaignOptions knowing_flaky() {
  CampaignOptions options = options_of(1);
  options.known_failures = {{"t.*", VerdictKind::fail_geometry, {}, {}, "a race", Flaky{1, 4}}};
  return options;
}

TEST(Campaign, WhatIsKnownToFailNowAndThenIsRunAsOftenAsItsEntrySays) {
  const Scratch scratch(3);
  // The third run of the first process; fresh ones answer well.
  const FakeSubject flickers = acting([](std::string_view, int runs) -> std::optional<RunEnd> {
    if (runs != 3) return std::nullopt;
    return RunEnd{};
  });
  const std::string footer = results_of(scratch, flickers, knowing_flaky());
  EXPECT_TRUE(has(footer, "\"pass-exact\":2,\"xfail\":1"));
  EXPECT_TRUE(has(scratch.read("r"), "1 of 4 runs failed so"));
  EXPECT_TRUE(has(scratch.read("r"), "\"attempts\":4"));
}

TEST(Campaign, AStableFailureIsNotHiddenByABoundOfFlickers) {
  const Scratch scratch(1);
  const FakeSubject wrong = acting([](std::string_view, int) { return RunEnd{}; });
  const std::string footer = results_of(scratch, wrong, knowing_flaky());
  EXPECT_TRUE(has(footer, "\"fail.geometry\":1"));
  EXPECT_TRUE(has(scratch.read("r"), "4 of 4 runs failed so; it is known to fail in at most 1"));
}

TEST(Campaign, ARunThatFailsOtherwiseThanItIsKnownToIsTheVerdict) {
  const Scratch scratch(1);
  FakeSubject wrong;
  int calls = 0;
  wrong.act = [&calls](std::string_view, int) -> std::optional<RunEnd> {
    RunEnd end;
    if (++calls == 3) end.kind = RunEnd::Kind::crash;
    return end;
  };
  EXPECT_TRUE(has(results_of(scratch, wrong, knowing_flaky()), "\"crash\":1"));
}

// The first run sends nothing and the second alarms.
TEST(Campaign, LineAndTraceAreOfOneRun) {
  const Scratch scratch(1);
  FakeSubject wrong;
  int calls = 0;
  wrong.act = [&calls](std::string_view, int) -> std::optional<RunEnd> {
    RunEnd end;
    if (++calls < 2) return end;
    end.kind = RunEnd::Kind::alarm;
    end.alarm.native = "E1";
    end.alarm.alarm_class = "arc-radius";
    end.alarm.block = 1;
    return end;
  };
  CampaignOptions options = knowing_flaky();
  options.traces = scratch.path("traces");
  std::filesystem::create_directories(options.traces);
  const std::string footer = results_of(scratch, wrong, options);
  EXPECT_TRUE(has(footer, "\"fail.alarm-spurious\":1"));
  EXPECT_TRUE(has(scratch.read("traces/t.000000.jsonl"), "E1"));
  // Nothing is left of the other run.
  const std::filesystem::directory_iterator files(options.traces);
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

}  // namespace
}  // namespace gonogo::oracle
