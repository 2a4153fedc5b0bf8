// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/campaign/results_writer.hpp"

#include <gtest/gtest.h>

#include "campaign_testing.hpp"
#include "oracle/campaign/results_reader.hpp"

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
  ResultsFooter footer;
  const RunAnswer answer = writer.close({}, footer);
  EXPECT_EQ(answer.decision, "GO");
  EXPECT_EQ(footer.cases, 3U);
  EXPECT_EQ(ids_in(scratch.path("r.jsonl")), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_FALSE(std::filesystem::exists(scratch.path("r.jsonl.part")));
}

TEST(ResultsWriter, ARunThatStoppedHasNoFooter) {
  const Scratch scratch;
  ResultsWriter writer(scratch.path("r.jsonl"), header_of("1"));
  writer.add(passed("a"));
  ResultsWriter::Ending ending;
  ending.is_complete = false;
  ResultsFooter footer;
  EXPECT_EQ(writer.close(ending, footer).cases, 1U);
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
    ResultsFooter footer;
    writer.close({}, footer);
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
  } catch (const ResumeError& error) {
    EXPECT_NE(std::string(error.what()).find("\"gonogo\""), std::string::npos) << error.what();
  }
}

TEST(ResultsWriter, GoesOnWhenOnlyTheCommandLineDiffers) {
  const Scratch scratch;
  leave_journal(scratch, "");
  ResultsHeader header = header_of("1");
  header.argv = {"certify", "--resume"};
  EXPECT_EQ(ResultsWriter(scratch.path("r.jsonl"), header, Start::resume).resumed(), 1U);
}

TEST(ResultsWriter, ADamagedJournalIsRefused) {
  const Scratch scratch;
  leave_journal(scratch, "garbage\n");
  EXPECT_THROW(ResultsWriter(scratch.path("r.jsonl"), header_of("1"), Start::resume), ResumeError);
}

TEST(ResultsWriter, ACaseThatIsThereTwiceIsAnError) {
  const Scratch scratch;
  ResultsWriter writer(scratch.path("r.jsonl"), header_of("1"));
  writer.add(passed("a"));
  writer.add(passed("a"));
  ResultsFooter footer;
  EXPECT_THROW(writer.close({}, footer), std::runtime_error);
  EXPECT_TRUE(std::filesystem::exists(scratch.path("r.jsonl.part")));
}

TEST(ResultsWriter, AFullDiskIsToldAndNotCrashedOn) {
  const Scratch scratch;
  std::filesystem::create_symlink("/dev/full", scratch.path("r.jsonl.part"));
  EXPECT_THROW(ResultsWriter(scratch.path("r.jsonl"), header_of("1")), ResultsUnwritable);
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
    ResultsFooter footer;
    EXPECT_EQ(writer.close(ending, footer).exit_code, is_shard ? 0 : 1);
    EXPECT_EQ(footer.unused_alarms, std::vector<std::string>{"B"});
    EXPECT_EQ(footer.stale.size(), is_shard ? 0U : 1U);
  }
}

}  // namespace
}  // namespace gonogo::oracle
