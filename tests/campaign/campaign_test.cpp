// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <thread>

#include "campaign/results_reader.hpp"
#include "campaign/selection.hpp"
#include "campaign_testing.hpp"

namespace gonogo::oracle {
namespace {

CampaignOptions options_of(int jobs) {
  CampaignOptions options;
  options.jobs = jobs;
  return options;
}

TEST(Campaign, EveryCaseIsRunOnceWhateverTheJobsAndTheWindow) {
  const Scratch scratch;
  write_corpus(scratch, 95);
  FakeSubject plain;
  const std::string expected = results_of(scratch, "r", options_of(1), fake_maker(plain));
  EXPECT_NE(expected.find("\"pass-exact\":95"), std::string::npos) << expected;
  for (const int jobs : {1, 2, 5}) {
    for (const int window : {1, 2, 64}) {
      FakeSubject fake;
      fake.window = window;
      EXPECT_EQ(results_of(scratch, "r", options_of(jobs), fake_maker(fake)), expected);
    }
  }
}

// J-RUN-08. Flaky in time only: every third case has no answer at the first try, and in a fresh
// process one that is later than the limit of 2 s.
TEST(Campaign, TimeoutsOfASlowMachineLeaveTheResultsAsTheyAre) {
  const Scratch scratch;
  write_corpus(scratch, 30);
  const std::string expected = results_of(scratch, "r", options_of(1), fake_maker({}));
  for (const int jobs : {1, 3}) {
    FakeSubject flaky;
    flaky.microseconds = 2'500'000;
    flaky.act = [](std::string_view id, int runs) -> std::optional<RunEnd> {
      // A fresh process, which has run nothing else, answers.
      if (runs == 1 || id.back() % 3 != 0) return std::nullopt;
      RunEnd end;
      end.kind = RunEnd::Kind::timeout;
      return end;
    };
    EXPECT_EQ(results_of(scratch, "r", options_of(jobs), fake_maker(flaky)), expected);
  }
}

RunEnd ended(RunEnd::Kind kind) {
  return RunEnd::of(kind, "It ended so.");
}

// J-RUN-08: a subject that hangs at every third program of a process.
TEST(Campaign, AHangThatFreshProcessesDoNotShareIsAStateLeak) {
  const Scratch scratch;
  write_corpus(scratch, 3);
  FakeSubject hangs;
  hangs.act = [](std::string_view, int runs) -> std::optional<RunEnd> {
    if (runs % 3 != 0) return std::nullopt;
    return ended(RunEnd::Kind::timeout);
  };
  const std::string footer = results_of(scratch, "r", options_of(1), fake_maker(hangs));
  EXPECT_NE(footer.find("\"pass-exact\":2,\"state-leak\":1"), std::string::npos) << footer;
  EXPECT_NE(scratch.read("r").find("3 times out of 3"), std::string::npos);
  EXPECT_NE(scratch.read("r").find("\"attempts\":4"), std::string::npos);
}

// J-RUN-08: the process grows from program to program; a fresh one has room.
TEST(Campaign, TooMuchMemoryIsToldAsThatWhateverAFreshProcessDoes) {
  const Scratch scratch;
  write_corpus(scratch, 3);
  for (const bool in_fresh : {false, true}) {
    FakeSubject grows;
    grows.act = [&](std::string_view id, int runs) -> std::optional<RunEnd> {
      if (id != "t.000002") return std::nullopt;
      if ((runs == 1) == in_fresh) return ended(RunEnd::Kind::out_of_memory);
      return in_fresh ? std::optional(ended(RunEnd::Kind::crash)) : std::nullopt;
    };
    const std::string footer = results_of(scratch, "r", options_of(1), fake_maker(grows));
    EXPECT_NE(footer.find("\"out-of-memory\":1"), std::string::npos) << footer;
    EXPECT_EQ(footer.find("state-leak"), std::string::npos) << footer;
  }
}

TEST(Campaign, ASubjectThatDiesAtOnceInEveryCaseIsNotJudged) {
  const Scratch scratch;
  write_corpus(scratch, 8);
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
    results_of(scratch, "r", options_of(1), fake_maker(dies));
    FAIL() << "it was judged";
  } catch (const SubjectUnusable& unusable) {
    EXPECT_NE(std::string(unusable.what()).find("no such script"), std::string::npos);
  }
  // An interpreter whose script is missing or broken often exits with 1, which is an alarm's code.
  FakeSubject exits = dies;
  exits.act = [](std::string_view, int) -> std::optional<RunEnd> {
    return ended(RunEnd::Kind::protocol);
  };
  EXPECT_THROW(results_of(scratch, "r", options_of(1), fake_maker(exits)), SubjectUnusable);
  // One that has said who it is may be right of other programs: twenty cases show that it is not.
  dies.info->greeted = true;
  EXPECT_NE(results_of(scratch, "r", options_of(1), fake_maker(dies)).find("\"crash\":8"),
            std::string::npos);
  const Scratch more;
  write_corpus(more, 20);
  EXPECT_THROW(results_of(more, "r", options_of(1), fake_maker(dies)), SubjectUnusable);
  dies.info->greeted = false;
  // One that answers once is at work.
  FakeSubject lives;
  lives.info = dies.info;
  lives.info->features = {"blocks"};
  lives.act = [](std::string_view id, int) -> std::optional<RunEnd> {
    if (id == "t.000001") return std::nullopt;
    return ended(RunEnd::Kind::crash);
  };
  const std::string footer = results_of(scratch, "r", options_of(1), fake_maker(lives));
  EXPECT_NE(footer.find("\"crash\":7"), std::string::npos) << footer;
}

SubjectInfo declaring(std::map<std::string, std::set<std::string>> dialects) {
  SubjectInfo info;
  info.dialects = std::move(dialects);
  info.features = {"blocks"};
  return info;
}

FakeSubject skipping_all_but(const std::string& judged, const std::string& feature) {
  FakeSubject skips;
  skips.act = [judged, feature](std::string_view id, int) -> std::optional<RunEnd> {
    if (id == judged) return std::nullopt;
    RunEnd end = ended(RunEnd::Kind::skip);
    end.feature = feature;
    return end;
  };
  return skips;
}

// J-RUN-05: the cases need `basic`, which it declares; it may name any reason.
TEST(Campaign, ASkipInsideADeclaredFeatureIsAFailureOfTheDeclaration) {
  const Scratch scratch;
  write_corpus(scratch, 10);
  for (const char* reason : {"basic", "g116", "bytes of mine", ""}) {
    FakeSubject skips = skipping_all_but("t.000003", reason);
    skips.info = declaring({{"gsk988ta", {"basic"}}});
    const std::string footer = results_of(scratch, "r", options_of(1), fake_maker(skips));
    EXPECT_NE(footer.find("\"decision\":\"NO-GO\""), std::string::npos) << footer;
    EXPECT_NE(footer.find("\"fail.declaration\":9,\"pass-exact\":1"), std::string::npos) << footer;
    EXPECT_NE(footer.find("NO-GO: basic of gsk988ta fails 9 of 10 cases; 1 of 10 judged is GO; "
                          "declared, but skipped: basic of gsk988ta (9 cases)"),
              std::string::npos)
        << footer;
  }
}

// J-RUN-05, J-RUN-14: a subject that declares nothing claims what it does not skip, and one case of
// ten is not the feature.
TEST(Campaign, ASubjectThatSkipsAllButOneIsGoForNoFeature) {
  const Scratch scratch;
  write_corpus(scratch, 10);
  const std::string footer =
      results_of(scratch, "r", options_of(1), fake_maker(skipping_all_but("t.000003", "g90")));
  EXPECT_NE(footer.find("\"head\":\"GO: 1 judged; not claimed: 9 cases; not judged for the most "
                        "part: basic (1 of 10 cases); not compared: M functions (g33.1, g74, g84, "
                        "g86 of rs274 pass some on themselves), source lines; fresh programs: "
                        "none\""),
            std::string::npos)
      << footer;
}

// What it calls its reason is none of a declaration that it does not make.
TEST(Campaign, ASkippedFeatureIsUndeclaredOnlyWhereTheSubjectDeclares) {
  const Scratch scratch;
  write_corpus(scratch, 10);
  const std::string footer =
      results_of(scratch, "r", options_of(1), fake_maker(skipping_all_but("t.000003", "basic")));
  EXPECT_NE(footer.find("\"head\":\"GO: 1 judged; not claimed: 9 cases; not judged for the most "
                        "part: basic (1 of 10 cases)"),
            std::string::npos)
      << footer;
}

TEST(Campaign, ASubjectThatDeclaresLittleIsAskedForNoMore) {
  const Scratch scratch;
  write_corpus(scratch, 10);
  FakeSubject little;
  little.info = declaring({{"gsk988ta", {"g94"}}});
  const std::string footer = results_of(scratch, "r", options_of(1), fake_maker(little));
  EXPECT_NE(footer.find("\"head\":\"UNDECIDED: 0 judged; not claimed: basic (10 cases); not "
                        "compared: M functions, source lines; fresh programs: "
                        "none\""),
            std::string::npos)
      << footer;
}

TEST(Campaign, ToRefuseTheProfileOfDefaultsIsAFailureOfTheDeclaration) {
  const Scratch scratch;
  write_corpus(scratch, 2);
  FakeSubject refuses;
  refuses.info = declaring({{"gsk988ta", {}}});
  refuses.act = [](std::string_view, int) { return ended(RunEnd::Kind::refused); };
  const std::string footer = results_of(scratch, "r", options_of(1), fake_maker(refuses));
  EXPECT_NE(footer.find("\"fail.declaration\":2"), std::string::npos) << footer;
}

TEST(Campaign, ANoGoThatAFreshProcessDoesNotShareIsAStateLeak) {
  const Scratch scratch;
  write_corpus(scratch, 3);
  FakeSubject leaky;
  leaky.act = [](std::string_view, int runs) -> std::optional<RunEnd> {
    if (runs < 3) return std::nullopt;
    return RunEnd{};  // no records at all
  };
  const std::string footer = results_of(scratch, "r", options_of(1), fake_maker(leaky));
  EXPECT_NE(footer.find("\"pass-exact\":2,\"state-leak\":1"), std::string::npos) << footer;
}

TEST(Campaign, AFailureThatComesAgainKeepsItsNameAndItsAttempts) {
  const Scratch scratch;
  write_corpus(scratch, 1);
  FakeSubject wrong;
  wrong.act = [](std::string_view, int) -> std::optional<RunEnd> { return RunEnd{}; };
  results_of(scratch, "r", options_of(1), fake_maker(wrong));
  EXPECT_NE(scratch.read("r").find("\"verdict\":\"fail.geometry\""), std::string::npos);
  EXPECT_NE(scratch.read("r").find("\"attempts\":2"), std::string::npos);
}

TEST(Campaign, NotesOfAFailureAreOfTheRunInWhichNothingWasAhead) {
  const Scratch scratch;
  write_corpus(scratch, 2);
  FakeSubject wrong;
  wrong.act = [](std::string_view, int runs) -> std::optional<RunEnd> {
    RunEnd end;
    end.notes = runs == 1 ? std::string("alone") : std::string("beside");
    return end;
  };
  results_of(scratch, "r", options_of(1), fake_maker(wrong));
  EXPECT_NE(scratch.read("r").find("\"notes\":\"alone\""), std::string::npos);
  EXPECT_EQ(scratch.read("r").find("beside"), std::string::npos);
}

TEST(Campaign, ATimeoutIsTriedThreeTimesMore) {
  const Scratch scratch;
  write_corpus(scratch, 1);
  FakeSubject hanging;
  hanging.act = [](std::string_view, int) -> std::optional<RunEnd> {
    RunEnd end;
    end.kind = RunEnd::Kind::timeout;
    return end;
  };
  results_of(scratch, "r", options_of(1), fake_maker(hanging));
  EXPECT_NE(scratch.read("r").find("\"verdict\":\"timeout\""), std::string::npos);
  EXPECT_NE(scratch.read("r").find("\"attempts\":4"), std::string::npos);
}

// How many records have come by then is another number each time.
// J-RUN-08: no answer in time is no other answer.
TEST(Campaign, ACrashAndThenATimeoutIsACrash) {
  const Scratch scratch;
  write_corpus(scratch, 1);
  FakeSubject subject;
  int all = 0;
  subject.act = [&all](std::string_view, int) -> std::optional<RunEnd> {
    return ended(all++ == 0 ? RunEnd::Kind::crash : RunEnd::Kind::timeout);
  };
  results_of(scratch, "r", options_of(1), fake_maker(subject));
  EXPECT_NE(scratch.read("r").find("\"verdict\":\"crash\""), std::string::npos);
  all = 0;
  subject.act = [&all](std::string_view, int) -> std::optional<RunEnd> {
    return ended(all++ > 0 ? RunEnd::Kind::crash : RunEnd::Kind::timeout);
  };
  results_of(scratch, "r", options_of(1), fake_maker(subject));
  EXPECT_NE(scratch.read("r").find("\"verdict\":\"crash\""), std::string::npos);
}

// J-RUN-08.
TEST(Campaign, AProgramThatTheCorpusDoesNotCoverNeverFailsByItsTime) {
  const Scratch scratch;
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
  // In the place of the one file that this writes.
  write_corpus(scratch, 1);
  scratch.write("corpus/vectors/gsk988ta/f0000.json", vector_file_text("2026.1.0", {outside}));
  FakeSubject hangs;
  hangs.act = [](std::string_view, int) { return std::optional(ended(RunEnd::Kind::timeout)); };
  results_of(scratch, "r", options_of(1), fake_maker(hangs));
  EXPECT_NE(scratch.read("r").find("\"verdict\":\"oracle-gap\",\"expected\":true"),
            std::string::npos)
      << scratch.read("r");
}

TEST(Campaign, ATimeoutHasNoTrace) {
  const Scratch scratch;
  write_corpus(scratch, 1);
  FakeSubject slow;
  slow.end = RunEnd::Kind::timeout;
  results_of(scratch, "r", options_of(1), fake_maker(slow));
  EXPECT_NE(scratch.read("r").find("\"trace\":[]"), std::string::npos);
}

TEST(Campaign, ASubjectThatWasGivenUpIsNotRunAgain) {
  const Scratch scratch;
  write_corpus(scratch, 1);
  FakeSubject gone;
  gone.act = [](std::string_view, int) -> std::optional<RunEnd> {
    RunEnd end;
    end.kind = RunEnd::Kind::crash;
    end.given_up = true;
    return end;
  };
  results_of(scratch, "r", options_of(1), fake_maker(gone));
  EXPECT_NE(scratch.read("r").find("\"attempts\":1"), std::string::npos);
}

// Every case has an entry with the verdict of a trace without records, 1 of 4 runs.
CampaignOptions knowing_flaky() {
  CampaignOptions options = options_of(1);
  options.known_failures = {{"t.*", VerdictKind::fail_geometry, {}, {}, "a race", Flaky{1, 4}}};
  return options;
}

TEST(Campaign, WhatIsKnownToFailNowAndThenIsRunAsOftenAsItsEntrySays) {
  const Scratch scratch;
  write_corpus(scratch, 3);
  FakeSubject flickers;
  // The third run of the first process; fresh ones answer well.
  flickers.act = [](std::string_view, int runs) -> std::optional<RunEnd> {
    if (runs != 3) return std::nullopt;
    return RunEnd{};
  };
  const std::string footer = results_of(scratch, "r", knowing_flaky(), fake_maker(flickers));
  EXPECT_NE(footer.find("\"pass-exact\":2,\"xfail\":1"), std::string::npos) << footer;
  EXPECT_NE(scratch.read("r").find("1 of 4 runs failed so"), std::string::npos);
  EXPECT_NE(scratch.read("r").find("\"attempts\":4"), std::string::npos);
}

TEST(Campaign, AStableFailureIsNotHiddenByABoundOfFlickers) {
  const Scratch scratch;
  write_corpus(scratch, 1);
  FakeSubject wrong;
  wrong.act = [](std::string_view, int) -> std::optional<RunEnd> { return RunEnd{}; };
  const std::string footer = results_of(scratch, "r", knowing_flaky(), fake_maker(wrong));
  EXPECT_NE(footer.find("\"fail.geometry\":1"), std::string::npos) << footer;
  EXPECT_NE(scratch.read("r").find("4 of 4 runs failed so; it is known to fail in at most 1"),
            std::string::npos);
}

TEST(Campaign, ARunThatFailsOtherwiseThanItIsKnownToIsTheVerdict) {
  const Scratch scratch;
  write_corpus(scratch, 1);
  FakeSubject wrong;
  int calls = 0;
  wrong.act = [&calls](std::string_view, int) -> std::optional<RunEnd> {
    RunEnd end;
    if (++calls == 3) end.kind = RunEnd::Kind::crash;
    return end;
  };
  const std::string footer = results_of(scratch, "r", knowing_flaky(), fake_maker(wrong));
  EXPECT_NE(footer.find("\"crash\":1"), std::string::npos) << footer;
}

// The first run sends nothing and the second alarms.
TEST(Campaign, LineAndTraceAreOfOneRun) {
  const Scratch scratch;
  write_corpus(scratch, 1);
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
  const std::string footer = results_of(scratch, "r", options, fake_maker(wrong));
  EXPECT_NE(footer.find("\"fail.alarm-spurious\":1"), std::string::npos) << footer;
  EXPECT_NE(scratch.read("traces/t.000000.jsonl").find("E1"), std::string::npos);
  // Nothing is left of the other run.
  const std::filesystem::directory_iterator files(options.traces);
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

// Whoever checks the run derives the pass from them. X2 is a diameter.
TEST(Campaign, WhatIsKnownToFailAndPassesKeepsItsProgramAndTrace) {
  const Scratch scratch;
  write_corpus(scratch, 2);
  CampaignOptions options = options_of(1);
  options.known_failures = {{"t.000001", VerdictKind::fail_geometry, {}, {}, "mended", {}}};
  results_of(scratch, "r", options, fake_maker({}));
  ResultsReader reader(scratch.path("r"));
  nlohmann::ordered_json pass;
  nlohmann::ordered_json unexpected;
  ASSERT_TRUE(reader.next(pass));
  ASSERT_TRUE(reader.next(unexpected));
  EXPECT_EQ(unexpected["verdict"], "xpass");
  EXPECT_EQ(unexpected["program"], "G00 X2 Z5\nM30\n");
  ASSERT_FALSE(unexpected["trace"].empty());
  EXPECT_EQ(unexpected["trace"][0]["to"], (nlohmann::ordered_json{{"x", "1"}, {"z", "5"}}));
  EXPECT_FALSE(pass.contains("program"));
}

TEST(Campaign, ShardsAreDisjointAndCoverTheCorpus) {
  for (const char* id : {"gsk.g94.000001", "a", ""}) {
    EXPECT_EQ(shard_of(id, 1), 1U);
    EXPECT_GE(shard_of(id, 7), 1U);
    EXPECT_LE(shard_of(id, 7), 7U);
  }
  // SHA-256 of "abc" begins ba7816bf8f01cfea: its last hexadecimal digit is 10, so modulo 2 it is 0
  // and modulo 16 it is 10.
  EXPECT_EQ(shard_of("abc", 2), 1U);
  EXPECT_EQ(shard_of("abc", 16), 11U);
}

TEST(Campaign, DoesNotRunWhatIsDone) {
  const Scratch scratch;
  write_corpus(scratch, 20);
  const Corpus corpus(scratch.path("corpus"));
  CampaignOptions options = options_of(2);
  options.is_done = [](std::string_view id) { return id < "t.000005"; };
  std::size_t results = 0;
  const CampaignEnd end = run_campaign(
      corpus, options, fake_maker({}), [&](const CaseResult&) { ++results; }, nullptr);
  EXPECT_EQ(results, 15U);
  EXPECT_EQ(end.cases, 20U);
}

// Ids in the order in which they were judged.
std::vector<std::string> order_of(const Corpus& corpus, std::uint64_t seed) {
  CampaignOptions options = options_of(1);
  options.seed = seed;
  std::vector<std::string> ids;
  run_campaign(
      corpus, options, fake_maker({}), [&](const CaseResult& result) { ids.push_back(result.id); },
      nullptr);
  return ids;
}

TEST(Campaign, CasesComeInTheOrderOfTheSeed) {
  const Scratch scratch;
  write_corpus(scratch, 40);
  const Corpus corpus(scratch.path("corpus"));
  const std::vector<std::string> by_id = order_of(corpus, 0);
  EXPECT_TRUE(std::ranges::is_sorted(by_id));
  const std::vector<std::string> five = order_of(corpus, 5);
  EXPECT_EQ(five, order_of(corpus, 5));
  EXPECT_NE(five, order_of(corpus, 6));
  EXPECT_NE(five, by_id);
  std::vector<std::string> sorted = five;
  std::ranges::sort(sorted);
  EXPECT_EQ(sorted, by_id);
  // A file has ten cases of one group, "t.00000N" to "t.00003N": they stay together.
  for (std::size_t i = 0; i < five.size(); ++i) {
    EXPECT_EQ(five[i].substr(0, 7), five[i / 10 * 10].substr(0, 7)) << five[i];
  }
}

TEST(Campaign, TheResultsAreNotOfTheOrder) {
  const Scratch scratch;
  write_corpus(scratch, 40);
  CampaignOptions options = options_of(3);
  FakeSubject fake;
  fake.act = [](std::string_view id, int) -> std::optional<RunEnd> {
    if (!id.ends_with("7")) return std::nullopt;
    return RunEnd{};
  };
  const auto hash_of = [&](std::uint64_t seed) {
    options.seed = seed;
    results_of(scratch, "r", options, fake_maker(fake));
    ResultsReader reader(scratch.path("r"));
    for (CaseHead head; reader.next(head);) continue;
    return reader.sha256();
  };
  const std::string by_id = hash_of(0);
  EXPECT_EQ(hash_of(5), by_id);
  EXPECT_EQ(hash_of(6), by_id);
}

TEST(Campaign, WhatBreaksDownBehindTheLastCaseBreaksDownInIt) {
  const Scratch scratch;
  write_corpus(scratch, 20);
  const Corpus corpus(scratch.path("corpus"));
  FakeSubject fake;
  fake.breaks_at_end = true;
  std::vector<CaseResult> results;
  run_campaign(
      corpus, options_of(1), fake_maker(fake),
      [&](const CaseResult& result) { results.push_back(result); }, nullptr);
  ASSERT_EQ(results.size(), 20U);
  EXPECT_EQ(results.back().verdict.kind, VerdictKind::crash);
  EXPECT_EQ(results.back().verdict.message, "It broke down at its end.");
  EXPECT_FALSE(results.back().program.empty());
  results.pop_back();
  EXPECT_TRUE(std::ranges::all_of(results, [](const CaseResult& result) {
    return decision(result.verdict.kind) == Decision::go;
  }));
}

TEST(Campaign, StopsAtTheFirstNoGoWhenAsked) {
  const Scratch scratch;
  write_corpus(scratch, 1'000);
  const Corpus corpus(scratch.path("corpus"));
  CampaignOptions options = options_of(2);
  options.fail_fast = true;
  options.known_failures.push_back({"t.000999", VerdictKind::crash, "", "", "never reached", {}});
  FakeSubject wrong;
  wrong.act = [](std::string_view, int) -> std::optional<RunEnd> { return RunEnd{}; };
  std::size_t results = 0;
  const CampaignEnd end = run_campaign(
      corpus, options, fake_maker(wrong), [&](const CaseResult&) { ++results; }, nullptr);
  EXPECT_EQ(results, 1U);
  EXPECT_FALSE(end.complete);
  EXPECT_TRUE(end.stale.empty());
}

TEST(Campaign, AFullDiskEndsItAtOnce) {
  const Scratch scratch;
  write_corpus(scratch, 1'000);
  const Corpus corpus(scratch.path("corpus"));
  std::size_t results = 0;
  auto full = [&](const CaseResult&) {
    if (++results > 7) throw ResultsUnwritable("full");
  };
  EXPECT_THROW(run_campaign(corpus, options_of(3), fake_maker({}), full, nullptr),
               ResultsUnwritable);
  EXPECT_EQ(results, 8U);
}

TEST(Campaign, ABrokenCorpusIsToldWithItsFile) {
  const Scratch scratch;
  write_corpus(scratch, 30);
  scratch.write("corpus/vectors/gsk988ta/f0002.json",
                scratch.read("corpus/vectors/gsk988ta/f0001.json"));
  const Corpus corpus(scratch.path("corpus"));
  try {
    run_campaign(
        corpus, options_of(2), fake_maker({}), [](const CaseResult&) {}, nullptr);
    FAIL();
  } catch (const CorpusError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("f0002.json"), std::string::npos) << message;
    EXPECT_NE(message.find("f0001.json too"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace gonogo::oracle
