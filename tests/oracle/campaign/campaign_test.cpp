// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "campaign_testing.hpp"
#include "oracle/campaign/selection.hpp"

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

// Flaky in time only: every third case has no answer in time at the first try.
TEST(Campaign, TimeoutsThatDoNotComeAgainLeaveTheResultsAsTheyAre) {
  const Scratch scratch;
  write_corpus(scratch, 30);
  const std::string expected = results_of(scratch, "r", options_of(1), fake_maker({}));
  for (const int jobs : {1, 3}) {
    FakeSubject flaky;
    flaky.act = [](std::string_view id, int runs) -> std::optional<RunEnd> {
      // A fresh process, which has run nothing else, is in time.
      if (runs == 1 || id.back() % 3 != 0) return std::nullopt;
      RunEnd end;
      end.kind = RunEnd::Kind::timeout;
      return end;
    };
    EXPECT_EQ(results_of(scratch, "r", options_of(jobs), fake_maker(flaky)), expected);
  }
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

TEST(Campaign, StopsAtTheFirstNoGoWhenAsked) {
  const Scratch scratch;
  write_corpus(scratch, 1'000);
  const Corpus corpus(scratch.path("corpus"));
  CampaignOptions options = options_of(2);
  options.fail_fast = true;
  options.known_failures.push_back({"t.000999", VerdictKind::crash, "", "", "never reached"});
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
