// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/results_writer.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "campaign/results_reader.hpp"
#include "campaign_testing.hpp"

namespace gonogo::oracle {
namespace {

using Json = nlohmann::ordered_json;
using Start = ResultsWriter::Start;

ResultsHeader header_of(std::string version) {
  ResultsHeader header;
  header.version = std::move(version);
  return header;
}

std::vector<std::string> ids_in(const std::string& path) {
  ResultsReader reader(path);
  std::vector<std::string> ids;
  for (Json line; reader.next(line);) ids.push_back(line["id"]);
  EXPECT_TRUE(reader.footer().has_value());
  return ids;
}

TEST(ResultsWriter, SortsTheLinesAndTheReaderAgreesWithItsFooter) {
  const Scratch scratch;
  ResultsWriter writer(scratch.path("r.jsonl"), header_of("1"));
  for (const char* id : {"c", "a", "b"}) writer.add(passed(id));
  const RunAnswer answer = writer.close({}).answer;
  EXPECT_EQ(answer.decision, "GO");
  EXPECT_EQ(answer.cases, 3U);
  EXPECT_EQ(ids_in(scratch.path("r.jsonl")), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_FALSE(std::filesystem::exists(scratch.path("r.jsonl.part")));
}

TEST(ResultsWriter, ARunThatStoppedHasNoFooter) {
  const Scratch scratch;
  ResultsWriter writer(scratch.path("r.jsonl"), header_of("1"));
  writer.add(passed("a"));
  ResultsWriter::Ending ending;
  ending.is_complete = false;
  EXPECT_EQ(writer.close(ending).answer.cases, 1U);
  ResultsReader reader(scratch.path("r.jsonl"));
  for (Json line; reader.next(line);) EXPECT_EQ(line["id"], "a");
  EXPECT_FALSE(reader.footer().has_value());
}

// As a kill leaves it: the writer goes without close().
void leave_journal(const Scratch& scratch, const std::string& half_line) {
  { ResultsWriter(scratch.path("r.jsonl"), header_of("1")).add(passed("b")); }
  const std::string journal = scratch.read("r.jsonl.part");
  scratch.write("r.jsonl.part", journal + half_line);
}

TEST(ResultsWriter, GoesOnFromAJournalAndDropsItsHalfLine) {
  for (const char* half : {"", "{\"id\":\"c\",\"dial", "{"}) {
    const Scratch scratch;
    leave_journal(scratch, half);
    ResultsWriter writer(scratch.path("r.jsonl"), header_of("1"), Start::resume);
    EXPECT_TRUE(writer.has("b"));
    EXPECT_FALSE(writer.has("c"));
    EXPECT_EQ(writer.resumed(), 1U);
    writer.add(passed("a"));
    writer.close({});
    EXPECT_EQ(ids_in(scratch.path("r.jsonl")), (std::vector<std::string>{"a", "b"}));
  }
}

TEST(ResultsWriter, AJournalThatEndsWithinItsHeaderIsNone) {
  const Scratch scratch;
  scratch.write("r.jsonl.part", "{\"format\":1,");
  ResultsWriter writer(scratch.path("r.jsonl"), header_of("1"), Start::resume);
  EXPECT_EQ(writer.resumed(), 0U);
}

TEST(ResultsWriter, DoesNotGoOnFromTheJournalOfAnotherRun) {
  const Scratch scratch;
  leave_journal(scratch, "");
  try {
    const ResultsWriter writer(scratch.path("r.jsonl"), header_of("2"), Start::resume);
    FAIL();
  } catch (const ResultsRefused& error) {
    EXPECT_TRUE(has(error.what(), "\"gonogo\""));
  }
}

TEST(ResultsWriter, GoesOnWhenOnlyTheCommandLineAndTheOrderDiffer) {
  const Scratch scratch;
  leave_journal(scratch, "");
  ResultsHeader header = header_of("1");
  header.argv = {"certify", "--resume"};
  header.seed = 7;
  EXPECT_EQ(ResultsWriter(scratch.path("r.jsonl"), header, Start::resume).resumed(), 1U);
}

TEST(ResultsWriter, AFreshProgramIsALineOfTheResultsAndNotOfTheJournal) {
  const Scratch scratch;
  ResultsWriter writer(scratch.path("r.jsonl"), header_of("1"));
  writer.add(passed("a"));
  writer.add(passed("g"));
  EXPECT_EQ(writer.standing().judged, (std::map<std::string, std::size_t>{{"gsk988ta", 2}}));
  EXPECT_EQ(writer.standing().no_go, 0U);
  CaseResult departure = passed("fresh.gsk988ta.00000000.000001");
  departure.verdict.kind = VerdictKind::fail_geometry;
  writer.add_fresh(departure);
  EXPECT_FALSE(has(scratch.read("r.jsonl.part"), "fresh"));
  ResultsWriter::Ending ending;
  ending.fresh["gsk988ta"] = {2, 1, 1};
  const ResultsFooter footer = writer.close(ending);
  EXPECT_EQ(footer.answer.decision, "NO-GO");
  EXPECT_TRUE(footer.answer.head.ends_with("; fresh programs: 1")) << footer.answer.head;
  EXPECT_EQ(ids_in(scratch.path("r.jsonl")), (std::vector<std::string>{"a", departure.id, "g"}));
  EXPECT_TRUE(
      has(footer_line(footer), R"("fresh":{"gsk988ta":{"wanted":2,"programs":1,"judged":1}})"));
}

TEST(ResultsWriter, ADamagedJournalIsRefused) {
  const Scratch scratch;
  leave_journal(scratch, "garbage\n");
  EXPECT_THROW(ResultsWriter(scratch.path("r.jsonl"), header_of("1"), Start::resume),
               ResultsRefused);
}

TEST(ResultsWriter, ACaseThatIsThereTwiceIsAnError) {
  const Scratch scratch;
  ResultsWriter writer(scratch.path("r.jsonl"), header_of("1"));
  writer.add(passed("a"));
  writer.add(passed("a"));
  EXPECT_THROW(writer.close({}), std::runtime_error);
  EXPECT_TRUE(std::filesystem::exists(scratch.path("r.jsonl.part")));
}

TEST(ResultsWriter, AFullDiskIsToldAndNotCrashedOn) {
  const Scratch scratch;
  // No file may have more bytes than this: more are refused, as on a full disk.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit small{16, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(ResultsWriter(scratch.path("r.jsonl"), header_of("1")), ResultsUnwritable);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
}

// A run that is killed before it has written its own leaves none of another beside its results.
TEST(ResultsWriter, ViewsOfResultsGoBeforeOthersTakeTheirPlace) {
  const Scratch scratch;
  constexpr const char* kViews[] = {"index.html", "junit.xml",  "results.sarif",
                                    "summary.md", "badge.json", "causes.json"};
  const auto run = [&](const std::string& name) {
    ResultsWriter writer(scratch.path(name), header_of("1"));
    writer.add(passed("a"));
    writer.close({});
  };
  for (const char* view : kViews) scratch.write(std::string("report/") + view, "of another");
  scratch.write("report/mine.txt", "mine");
  // No report has written there: these are somebody else's.
  run("report/results.jsonl");
  run("report/results.jsonl");
  scratch.write("report/programs/.written", "");
  run("report/other.jsonl");
  for (const char* view : kViews) {
    EXPECT_EQ(scratch.read(std::string("report/") + view), "of another") << view;
  }
  run("report/results.jsonl");
  for (const char* view : kViews) {
    EXPECT_FALSE(std::filesystem::exists(scratch.path(std::string("report/") + view))) << view;
  }
  EXPECT_EQ(scratch.read("report/mine.txt"), "mine");
}

TEST(ResultsWriter, DecidesFromWhatWasAddedWhateverBecameOfTheJournal) {
  const Scratch scratch;
  ResultsWriter writer(scratch.path("r.jsonl"), header_of("1"));
  CaseResult failed = passed("a");
  failed.verdict.kind = VerdictKind::fail_geometry;
  writer.add(failed);
  writer.add(passed("b"));
  scratch.write("r.jsonl.part", scratch.read("r.jsonl.part").substr(0, 20));
  const RunAnswer answer = writer.close({}).answer;
  EXPECT_EQ(answer.decision, "NO-GO");
  EXPECT_EQ(answer.cases, 2U);
}

TEST(ResultsWriter, OneRunHoldsThePlaceAndTheNextOneMayHaveItWhenThatIsOver) {
  const Scratch scratch;
  {
    const ResultsWriter writer(scratch.path("r.jsonl"), header_of("1"));
    EXPECT_THROW(ResultsWriter(scratch.path("r.jsonl"), header_of("1")), ResultsRefused);
  }
  EXPECT_FALSE(std::filesystem::exists(scratch.path("r.jsonl.lock")));
  const ResultsWriter writer(scratch.path("r.jsonl"), header_of("1"));
}

TEST(ResultsWriter, ReplacesNoFileOfAnotherAndFollowsNoLink) {
  for (const char* name : {"r.jsonl", "r.jsonl.part"}) {
    const Scratch scratch;
    scratch.write(name, "mine\n");
    EXPECT_THROW(ResultsWriter(scratch.path("r.jsonl"), header_of("1")), ResultsRefused) << name;
    EXPECT_EQ(scratch.read(name), "mine\n");
  }
  for (const char* name : {"r.jsonl", "r.jsonl.part"}) {
    const Scratch scratch;
    scratch.write("victim", "{\"format\":1}\n");
    std::filesystem::create_symlink(scratch.path("victim"), scratch.path(name));
    EXPECT_THROW(ResultsWriter(scratch.path("r.jsonl"), header_of("1")), ResultsRefused) << name;
    EXPECT_EQ(scratch.read("victim"), "{\"format\":1}\n");
  }
}

TEST(ResultsWriter, AJournalWithACaseTwiceIsRefused) {
  const Scratch scratch;
  leave_journal(scratch, "");
  const std::string journal = scratch.read("r.jsonl.part");
  scratch.write("r.jsonl.part", journal + journal.substr(journal.find('\n') + 1));
  EXPECT_THROW(ResultsWriter(scratch.path("r.jsonl"), header_of("1"), Start::resume),
               ResultsRefused);
}

TEST(ResultsWriter, AlarmsThatNoCaseMetAreStaleInAWholeRunAndListedInAShard) {
  for (const bool is_shard : {false, true}) {
    const Scratch scratch;
    ResultsWriter writer(scratch.path("r.jsonl"), header_of("1"));
    CaseResult result = passed("a");
    result.mapped = "A";
    writer.add(result);
    ResultsWriter::Ending ending;
    ending.alarms = {"A", "B"};
    ending.is_shard = is_shard;
    const ResultsFooter footer = writer.close(ending);
    EXPECT_EQ(footer.answer.exit_code, is_shard ? 0 : 1);
    EXPECT_EQ(footer.unused_alarms, std::vector<std::string>{"B"});
    EXPECT_EQ(footer.stale.size(), is_shard ? 0U : 1U);
  }
}

}  // namespace
}  // namespace gonogo::oracle
