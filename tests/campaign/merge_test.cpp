// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/merge.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "campaign/results_reader.hpp"
#include "campaign_testing.hpp"

namespace gonogo::oracle {
namespace {

constexpr unsigned kShards = 3;

// Without what may differ: argv, us and attempts; and the shards, which stand last in the header.
std::string comparable(const std::string& text) {
  const std::string one = std::regex_replace(text, std::regex(",\"shards\":\\[.*\\]"), "");
  return std::regex_replace(one, std::regex("\"(us|attempts)\":[0-9]+|\"argv\":\\[[^\\]]*\\]"), "");
}

class Merge : public ::testing::Test {
 protected:
  CampaignOptions options() const {
    CampaignOptions options;
    options.alarm_map = alarms_;
    options.known_failures = known_;
    return options;
  }
  void run(const std::string& name, const CampaignOptions& options) {
    results_of(scratch_, fake_, options, name);
  }
  void run_whole() { run("whole", options()); }
  void run_shards(std::uint64_t seed = 0, std::uint64_t step = 0) {
    for (unsigned shard = 1; shard <= kShards; ++shard) {
      CampaignOptions one = options();
      one.shard = shard;
      one.shards = kShards;
      one.seed = seed + step * shard;
      run("s" + std::to_string(shard), one);
    }
  }
  MergeOutcome merge(const std::vector<std::string>& names, MergeOptions merging = {}) {
    for (const std::string& name : names) merging.results.push_back(scratch_.path(name));
    merging.out = scratch_.path("merged");
    merging.argv = {"merge"};
    return merge_results(merging);
  }
  void replace_in(const std::string& name, const std::string& what, const std::string& with) {
    std::string text = scratch_.read(name);
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos);
    scratch_.write(name, text.replace(at, what.size(), with));
  }

  Scratch scratch_{40};
  FakeSubject fake_;
  std::shared_ptr<const AlarmMap> alarms_;
  std::vector<KnownFailure> known_;
};

TEST_F(Merge, IsTheResultOfAnUndividedRunByteForByte) {
  fake_.act = [](std::string_view id, int) -> std::optional<RunEnd> {
    if (id != "t.000007") return std::nullopt;
    return RunEnd{};
  };
  alarms_ = std::make_shared<const AlarmMap>(
      std::vector<AlarmMap::Entry>{{"PS1", "value-sign"}, {"PS2", "no-tool"}});
  known_ = {{"t.9*", VerdictKind::crash, "", "", "of no case", {}}};
  run_whole();
  run_shards();
  const MergeOutcome outcome = merge({"s2", "s3", "s1"});
  EXPECT_TRUE(outcome.written);
  EXPECT_EQ(outcome.footer.answer.exit_code, 1);
  EXPECT_EQ(comparable(scratch_.read("merged")), comparable(scratch_.read("whole")));
}

// A fresh program belongs to no shard, and each shard asks its own.
TEST_F(Merge, FreshProgramsOfShardsAddUp) {
  run_shards();
  for (unsigned shard = 1; shard <= kShards; ++shard) {
    const std::string number = std::to_string(shard);
    ASSERT_NO_FATAL_FAILURE(
        replace_in("s" + number, R"("fresh":{})",
                   R"("fresh":{"gsk988ta":{"wanted":9,"programs":)" + number + R"(,"judged":1}})"));
  }
  const MergeOutcome outcome = merge({"s1", "s2", "s3"});
  EXPECT_EQ(outcome.footer.fresh, (FreshCounts{{"gsk988ta", {27, 6, 3}}}));
  // Each is drawn again from the seed of its shard.
  const auto shards = ResultsReader(scratch_.path("merged")).header()["shards"];
  ASSERT_EQ(shards.size(), kShards);
  EXPECT_EQ(shards[1]["shard"], "2/3");
  EXPECT_EQ(shards[1]["fresh"]["gsk988ta"]["programs"], 2);
  const std::string& head = outcome.footer.answer.head;
  EXPECT_TRUE(head.ends_with("; fresh programs: 3")) << head;
}

TEST_F(Merge, ShardsOfDifferentSeedsAreOneRunWithoutASeed) {
  const auto merged_seed = [&](std::uint64_t step) {
    run_shards(7, step);
    EXPECT_EQ(merge({"s1", "s2", "s3"}).footer.answer.exit_code, 0);
    const auto header = ResultsReader(scratch_.path("merged")).header();
    for (unsigned shard = 1; shard <= kShards; ++shard) {
      EXPECT_EQ(header["shards"][shard - 1]["seed"], 7 + step * shard);
    }
    return header["seed"].get<std::uint64_t>();
  };
  EXPECT_EQ(merged_seed(0), 7U);
  EXPECT_EQ(merged_seed(1), 0U);
}

// The fake sends X i (a radius) and Z 5, of every third case X off by 0.0003 and of the first by
// 0.001: of 40 cases 14 have one that is not exact, 80 - 14 = 66 coordinates are, and what is off
// lies on the grid of 0.0001 mm, by up to ten of it.
TEST_F(Merge, SaysOfCoordinatesWhatAnUndividedRunSays) {
  fake_.alter = [](std::string_view id, reference::Record& record) {
    const int number = std::stoi(std::string(id.substr(2)));
    if (number % 3 != 0 || !record.axes.has(reference::Axis::x)) return;
    record.to[reference::Axis::x] += Number::millionths(number == 0 ? 1'000 : 300);
  };
  run_whole();
  run_shards();
  const MergeOutcome outcome = merge({"s3", "s1", "s2"});
  const RoundingCensus census = outcome.footer.answer.coordinates.at("gsk988ta");
  EXPECT_EQ(census.exact(), 66U);
  EXPECT_EQ(census.rounded().count(), 14U);
  EXPECT_EQ(census.rounded().increment().text(), "0.0001");
  EXPECT_EQ(census.rounded().increments_off(), 10);
  EXPECT_EQ(census.rounded().modes(), std::vector<RoundingMode>{});
  EXPECT_EQ(comparable(scratch_.read("merged")), comparable(scratch_.read("whole")));
  CampaignOptions parallel = options();
  parallel.jobs = 3;
  run("parallel", parallel);
  EXPECT_EQ(comparable(scratch_.read("parallel")), comparable(scratch_.read("whole")));
}

TEST_F(Merge, ReconcilesTheReadingsOfAllShardsTogether) {
  // Passes under r=1 in one shard and under r=2 in the other: each is GO alone, both are not.
  for (const char* name : {"whole", "s1", "s2"}) {
    ResultsHeader header;
    header.shard = name[0] == 'w' ? "1/1" : std::string(1, name[1]) + "/2";
    ResultsWriter writer(scratch_.path(name), header);
    // SHA-256 of "abc" begins ba7816bf8f01cfea: even, shard 1; of "d" 18ac3e7343f01689: shard 2.
    for (const auto& [id, reading] : {std::pair{"abc", "r=1"}, std::pair{"d", "r=2"}}) {
      if (name[0] == 's' && (name[1] == '1') != (std::string(id) == "abc")) continue;
      CaseResult result = passed(id);
      result.readings = OpenReadings{{"r"}, {reading}, VerdictKind::pass_exact, {}};
      writer.add(result);
    }
    EXPECT_EQ(writer.close({}).answer.exit_code, name[0] == 'w' ? 1 : 0) << name;
  }
  const MergeOutcome outcome = merge({"s1", "s2"});
  EXPECT_EQ(outcome.footer.answer.reading_conflict, "d");
  EXPECT_EQ(comparable(scratch_.read("merged")), comparable(scratch_.read("whole")));
}

TEST_F(Merge, NamesAMissingShardAndWritesNothing) {
  run_shards();
  const MergeOutcome outcome = merge({"s1", "s3"});
  ASSERT_EQ(outcome.missing.size(), 1U);
  EXPECT_TRUE(has(outcome.missing[0], "2/3"));
  EXPECT_FALSE(outcome.written);
  EXPECT_FALSE(std::filesystem::exists(scratch_.path("merged")));
}

// What is wrong is the shard alone.
TEST_F(Merge, AMissingShardIsNoMissingCorpus) {
  run_shards();
  const Corpus corpus(scratch_.path("corpus"));
  for (const char* name : {"s1", "s3"}) {
    replace_in(name, R"("sha256":""})", R"("sha256":")" + corpus.sha256() + "\"}");
  }
  MergeOptions merging;
  merging.corpus = &corpus;
  const MergeOutcome outcome = merge({"s1", "s3"}, merging);
  EXPECT_TRUE(outcome.has_corpus);
  EXPECT_EQ(outcome.missing, std::vector<std::string>{"shard 2/3 is not there"});
  EXPECT_FALSE(outcome.written);
}

TEST_F(Merge, NamesAnIncompleteShard) {
  run_shards();
  const std::string text = scratch_.read("s2");
  scratch_.write("s2", text.substr(0, text.rfind("{\"decision\"")));
  const MergeOutcome outcome = merge({"s1", "s2", "s3"});
  ASSERT_EQ(outcome.missing.size(), 1U);
  EXPECT_TRUE(has(outcome.missing[0], "incomplete"));
  EXPECT_FALSE(outcome.written);
}

TEST_F(Merge, WritesWhatIsThereWithoutAFooterWhenAsked) {
  run_shards();
  MergeOptions merging;
  merging.partial = true;
  EXPECT_TRUE(merge({"s1", "s3"}, merging).written);
  const std::string text = scratch_.read("merged");
  EXPECT_TRUE(has(text, "t.0000"));
  EXPECT_FALSE(has(text, "\"decision\""));
}

TEST_F(Merge, AShardThatIsThereTwiceWithTheSameCasesCountsOnce) {
  run_shards();
  scratch_.write("again", scratch_.read("s2"));
  const MergeOutcome outcome = merge({"s1", "s2", "again", "s3"});
  EXPECT_TRUE(outcome.written);
  EXPECT_EQ(outcome.notes.size(), 1U);
  EXPECT_EQ(outcome.footer.answer.cases, 40U);
}

TEST_F(Merge, AShardThatIsThereTwiceWithOtherCasesIsRefused) {
  run_shards();
  scratch_.write("s2-before", scratch_.read("s2"));
  fake_.act = [](std::string_view, int) -> std::optional<RunEnd> { return RunEnd{}; };
  run_shards();
  EXPECT_THROW(merge({"s2-before", "s2"}), MergeError);
}

TEST_F(Merge, RefusesShardsOfDifferentRuns) {
  run_shards();
  for (const auto& [what, with] :
       {std::pair{"\"gonogo\":\"\"", "\"gonogo\":\"9\""},
        std::pair{"\"chord\":null", "\"chord\":\"1\""},
        std::pair{"\"version\":\"\",\"sha256\"", "\"version\":\"2\",\"sha256\""},
        std::pair{"\"spec\":\"\"", "\"spec\":\"pipe:x\""}}) {
    const std::string before = scratch_.read("s2");
    replace_in("s2", what, with);
    EXPECT_THROW(merge({"s1", "s2", "s3"}), MergeError) << with;
    scratch_.write("s2", before);
  }
}

TEST_F(Merge, RefusesShardsOfDifferentDivisions) {
  run_shards();
  CampaignOptions other = options();
  other.shard = 1;
  other.shards = 2;
  run("half", other);
  EXPECT_THROW(merge({"s1", "s2", "s3", "half"}), MergeError);
}

TEST_F(Merge, RefusesCasesThatBelongToAnotherShard) {
  run_whole();
  replace_in("whole", "\"shard\":\"1/1\"", "\"shard\":\"1/3\"");
  EXPECT_THROW(merge({"whole"}), MergeError);
}

}  // namespace
}  // namespace gonogo::oracle
