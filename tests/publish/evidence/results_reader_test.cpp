// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/results_reader.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/publish/evidence/results_files.hpp"

namespace gonogo::oracle {
namespace {

// Reads a file with these lines to the end; the sentence of what is wrong, or empty.
std::string fault_of(const std::string& text,
                     ResultsReader::Order order = ResultsReader::Order::by_id) {
  const Scratch scratch;
  const std::string path = scratch.write("results.jsonl", text);
  try {
    ResultsReader reader(path, order);
    ResultsReader::Json line;
    while (reader.next(line)) {
    }
    return {};
  } catch (const ResultsError& error) {
    const std::string sentence = error.what();
    EXPECT_TRUE(sentence.starts_with(path)) << sentence;
    return sentence.substr(std::min(sentence.size(), path.size()));
  }
}

const std::string kA =
    R"({"id":"a.1","dialect":"rs274","verdict":"pass-exact","us":3,"attempts":1})";
const std::string kB = R"({"id":"b.1","dialect":"rs274","verdict":"skip"})";

TEST(ResultsReader, ReadsHeaderCasesAndFooter) {
  const Scratch scratch;
  ResultsReader reader(scratch.write("r.jsonl", results_text({kA, kB})));
  EXPECT_EQ(reader.header()["subject"]["name"], "acme");
  ResultsReader::Json line;
  ASSERT_TRUE(reader.next(line));
  EXPECT_EQ(line["id"], "a.1");
  EXPECT_EQ(reader.text(), kA);
  EXPECT_FALSE(reader.footer());
  ASSERT_TRUE(reader.next(line));
  EXPECT_FALSE(reader.next(line));
  ASSERT_TRUE(reader.footer());
  EXPECT_EQ((*reader.footer())["cases"], 2);
  EXPECT_FALSE(reader.next(line));
}

// printf '%s\n' '{"id":"a.1","dialect":"rs274","verdict":"pass-exact"}' | sha256sum
TEST(ResultsReader, HashLeavesOutTimeAndAttempts) {
  const Scratch scratch;
  ResultsReader reader(scratch.write("r.jsonl", results_text({kA})));
  ResultsReader::Json line;
  ASSERT_TRUE(reader.next(line));
  EXPECT_EQ(reader.sha256(), "e5389c27310e8b1cddfd30908025e642a516098972a345fd86d1a0082195653b");
}

TEST(ResultsReader, HashIsOfTheValuesNotOfTheBlanks) {
  const Scratch scratch;
  const std::string spaced =
      R"({ "id": "a.1", "dialect": "rs274", "verdict": "pass-exact", "us": 3, "attempts": 1 })";
  std::string text = results_text({kA});
  text.replace(text.find(kA), kA.size(), spaced);
  ResultsReader reader(scratch.write("r.jsonl", text));
  CaseHead head;
  ASSERT_TRUE(reader.next(head));
  EXPECT_EQ(head.id, "a.1");
  EXPECT_EQ(head.microseconds, 3U);
  EXPECT_FALSE(reader.next(head));
  EXPECT_TRUE(reader.footer());
  EXPECT_EQ(reader.sha256(), "e5389c27310e8b1cddfd30908025e642a516098972a345fd86d1a0082195653b");
}

TEST(ResultsReader, FileWithoutFooterIsReadAndIsIncomplete) {
  const Scratch scratch;
  ResultsReader reader(scratch.write("r.jsonl", std::string(kHeaderLine) + "\n" + kA + "\n"));
  ResultsReader::Json line;
  EXPECT_TRUE(reader.next(line));
  EXPECT_FALSE(reader.next(line));
  EXPECT_FALSE(reader.footer());
}

TEST(ResultsReader, SaysThatAFileIsMissing) {
  try {
    ResultsReader reader("/nowhere/results.jsonl");
    FAIL();
  } catch (const ResultsError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/results.jsonl cannot be opened.");
  }
}

TEST(ResultsReader, SaysThatAFileIsEmpty) {
  EXPECT_EQ(fault_of(""), " is empty: a results file begins with its header.");
}

TEST(ResultsReader, SaysThatTheFirstLineIsNoHeader) {
  EXPECT_EQ(fault_of(kA + "\n"), ": line 1 is not the header of a results file.");
}

TEST(ResultsReader, SaysThatTheFormatIsAnother) {
  EXPECT_EQ(fault_of("{\"format\":3}\n"),
            ": line 1 names the format 3; this program reads 1 to 2.");
}

// The header with other values of some keys.
std::string header_with(std::string_view changes) {
  ResultsReader::Json header = ResultsReader::Json::parse(kHeaderLine);
  header.merge_patch(ResultsReader::Json::parse(changes));
  return header.dump() + "\n";
}

TEST(ResultsReader, SaysOfAHeaderWhichValueIsOfAnotherKind) {
  for (const auto& [changes, place] : std::initializer_list<std::pair<const char*, const char*>>{
           {R"({"argv":{"0":"certify"}})", "list of texts at /argv"},
           {R"({"argv":["certify",1]})", "list of texts at /argv"},
           {R"({"selection":[]})", "object at /selection"},
           {R"({"selection":{"only":"*"}})", "list of texts at /selection/only"},
           {R"({"subject":7})", "object at /subject"},
           {R"({"subject":{"features":"m"}})", "list of texts at /subject/features"},
           {R"({"subject":{"dialects":{"rs274":[1]}}})",
            "object of lists of texts at /subject/dialects"},
           {R"({"readings":{"a":"b"}})", "list of texts at /readings"},
           {R"({"corpus":"2026.6.0"})", "object at /corpus"},
           {R"({"profile":[]})", "object at /profile"},
           {R"({"seed":-1})", "count at /seed"},
           {R"({"shards":[{"seed":1,"argv":[],"fresh":{}}]})", "list of shards at /shards"},
           {R"({"strict":"no"})", "true or false at /strict"}}) {
    EXPECT_EQ(fault_of(header_with(changes)), std::string(": line 1 has no ") + place + ".")
        << changes;
  }
}

TEST(ResultsReader, TakesAHeaderThatKnowsNothingOfItsSubject) {
  EXPECT_EQ(fault_of(header_with(R"({"subject":{"dialects":{}},"selection":{"only":[]}})")), "");
}

TEST(ResultsReader, SaysOfAFooterWhichValueIsOfAnotherKind) {
  std::string text = results_text({});
  const std::string totals = "\"totals\":{";
  text.insert(text.find(totals) + totals.size(), "\"skip\":\"many\"");
  EXPECT_EQ(fault_of(text), ": line 2 has no object of counts at /totals.");
}

TEST(ResultsReader, SaysThatANumberIsTooLarge) {
  EXPECT_EQ(fault_of("{\"format\":1e999}\n"), ": line 1 holds a number that is too large.");
  EXPECT_EQ(fault_of(std::string(kHeaderLine) + "\n{\"id\":\"a.1\",\"us\":1e999}\n"),
            ": line 2 holds a number that is too large.");
}

TEST(ResultsReader, SaysThatALineIsCutOff) {
  EXPECT_EQ(fault_of(std::string(kHeaderLine) + "\n" + kA + "\n{\"id\":\"b"),
            ": line 3 is cut off: it has no line end.");
}

TEST(ResultsReader, SaysThatAFooterWithoutLineEndIsCutOff) {
  std::string text = results_text({kA});
  text.pop_back();
  EXPECT_EQ(fault_of(text), ": line 3 is cut off: it has no line end.");
}

TEST(ResultsReader, SaysThatACaseStandsTwice) {
  EXPECT_EQ(fault_of(results_text({kA, kA})), ": line 3 holds the case a.1 a second time.");
}

TEST(ResultsReader, SaysThatCasesAreNotSorted) {
  EXPECT_EQ(fault_of(results_text({kB, kA})),
            ": line 3 holds the case a.1 after b.1: the lines are not sorted by id.");
}

TEST(ResultsReader, SaysThatTheHashIsAnother) {
  const std::string told(64, '0');
  const std::string text =
      std::string(kHeaderLine) + "\n" + kA + "\n{\"totals\":{},\"sha256\":\"" + told + "\"}\n";
  EXPECT_TRUE(fault_of(text).starts_with(": line 3 says that the case lines have the SHA-256 " +
                                         told + ", but they have e5389c27"));
}

TEST(ResultsReader, SaysThatTheFooterHasNoHash) {
  const std::string text = std::string(kHeaderLine) + "\n{\"totals\":{}}\n";
  EXPECT_TRUE(fault_of(text).starts_with(
      ": line 2 says that the case lines have the SHA-256 (none), but they have "));
}

TEST(ResultsReader, SaysThatTheNumberOfCasesIsAnother) {
  std::string text = results_text({kA});
  text.replace(text.find("\"cases\":1"), 9, "\"cases\":7");
  EXPECT_EQ(fault_of(text), ": line 3 says that the file has 7 cases, but it has 1.");
}

TEST(ResultsReader, SaysThatALineIsNoJson) {
  EXPECT_EQ(fault_of(std::string(kHeaderLine) + "\n{\"id\":\n"),
            ": line 2 is no JSON: it cannot be read from byte 7 on.");
}

TEST(ResultsReader, SaysThatALineIsNoObject) {
  EXPECT_EQ(fault_of(std::string(kHeaderLine) + "\n[1]\n"), ": line 2 is no JSON object.");
}

TEST(ResultsReader, SaysThatALineIsNeitherCaseNorFooter) {
  EXPECT_EQ(fault_of(std::string(kHeaderLine) + "\n{\"id\":\"a\"}\n"),
            ": line 2 is neither a case nor the footer.");
}

TEST(ResultsReader, SaysThatAVerdictIsUnknown) {
  EXPECT_EQ(fault_of(std::string(kHeaderLine) +
                     "\n{\"id\":\"a\",\"dialect\":\"rs274\",\"verdict\":\"splendid\"}\n"),
            ": line 2 has the verdict \"splendid\", which this program does not know.");
}

TEST(ResultsReader, SaysThatALineFollowsTheFooter) {
  EXPECT_EQ(fault_of(results_text({kA}) + kB + "\n"),
            ": line 4 follows the footer, which is the last line.");
}

TEST(ResultsReader, JournalMayBeInAnyOrderAndEndInAHalfLine) {
  EXPECT_EQ(fault_of(std::string(kHeaderLine) + "\n" + kB + "\n" + kA + "\n{\"id\":\"c",
                     ResultsReader::Order::as_run),
            "");
}

TEST(ResultsReader, JournalSaysHowManyBytesAreWhole) {
  const Scratch scratch;
  const std::string whole = std::string(kHeaderLine) + "\n" + kB + "\n";
  ResultsReader reader(scratch.write("r", whole + "{\"id"), ResultsReader::Order::as_run);
  ResultsReader::Json line;
  EXPECT_TRUE(reader.next(line));
  EXPECT_FALSE(reader.next(line));
  EXPECT_EQ(reader.whole_bytes(), whole.size());
}

}  // namespace
}  // namespace gonogo::oracle
