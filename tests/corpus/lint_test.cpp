// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/lint.hpp"
#include "reference/reading_literal.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "corpus/io/corpus_diff.hpp"
#include "corpus/io/folder_writer.hpp"
#include "corpus_testing.hpp"
#include "tests/has.hpp"

namespace gonogo::testing {
namespace {

using oracle::Case;
using oracle::CorpusFolder;

constexpr const char* kFile = "vectors/gsk988ta/g94.json";

// Three cases at a limit, as the generator makes them.
CorpusFolder triple() {
  CorpusFolder folder{"2026.1.0", {}, {}};
  const char* const words[] = {"R9.999", "R10", "R10.001"};
  const char* const sides[] = {"GSK-G94-09:-", "GSK-G94-09:0", "GSK-G94-09:+"};
  for (int i = 0; i < 3; ++i) {
    Case test;
    test.id = "gsk.g94.sign-0123456789.00000" + std::to_string(i + 1);
    test.comment = "a limit";
    test.program = std::string("G00 X100 Z50\nG94 X60 W-10 ") + words[i] + " F100\n";
    test.dialect = "gsk988ta";
    test.cycle = "g94";
    test.group = "gsk.g94.sign";
    test.features = {"g94"};
    test.clauses = {"GSK-G94-09"};
    test.profile.readings.set("gsk.g94.taper-limit=alarm"_reading);
    test.tags_sign = {sides[i]};
    test.provenance = "hand";
    test.expect = {oracle::expectation_of(test.profile, test.program)};
    folder.files[kFile].push_back(std::move(test));
  }
  return folder;
}

std::string written(const ScratchFolder& scratch, const char* name, const CorpusFolder& folder) {
  const std::string path = (scratch.path() / name).string();
  oracle::write_corpus(path, folder);
  return path;
}

// The sentences about a corpus.
std::vector<std::string> findings(const std::string& folder, bool part) {
  std::vector<std::string> said;
  oracle::lint(oracle::Corpus(folder), {part},
               [&](const std::string& sentence) { said.push_back(sentence); });
  return said;
}

bool any_has(const std::vector<std::string>& texts, std::string_view part) {
  return std::ranges::any_of(
      texts, [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

TEST(Lint, ThePartThatKeepsItsPromises) {
  const ScratchFolder scratch;
  EXPECT_EQ(findings(written(scratch, "a", triple()), true), std::vector<std::string>{});
}

TEST(Lint, AWholeCorpusHitsEveryClause) {
  const ScratchFolder scratch;
  const auto said = findings(written(scratch, "a", triple()), false);
  EXPECT_TRUE(any_has(said, "The clause GSK-G94-01 stands in no group."));
  EXPECT_FALSE(any_has(said, "The clause GSK-G94-09"));
}

TEST(Lint, AWholeCorpusSetsEveryAlternativeOfAReading) {
  const ScratchFolder scratch;
  const auto said = findings(written(scratch, "a", triple()), false);
  EXPECT_TRUE(any_has(said, "The reading gsk.g94.rewrite=clear stands in no profile."));
  EXPECT_FALSE(any_has(said, "gsk.g94.rewrite=keep"));
}

// One of three is 33 in a hundred, none of two is too few.
TEST(Lint, AWholeCorpusHasItsShareOfAlarms) {
  const ScratchFolder scratch;
  EXPECT_FALSE(any_has(findings(written(scratch, "a", triple()), false), "end in an alarm"));
  CorpusFolder calm = triple();
  calm.files[kFile].pop_back();
  EXPECT_TRUE(
      any_has(findings(written(scratch, "b", calm), false), "0 of 2 cases end in an alarm"));
}

TEST(Lint, ATripleIsWhole) {
  const ScratchFolder scratch;
  CorpusFolder folder = triple();
  folder.files[kFile].erase(folder.files[kFile].begin());
  EXPECT_TRUE(any_has(findings(written(scratch, "a", folder), false),
                      "below, on and above the limit only 2 are there"));
}

TEST(Lint, AnExpectationIsTheReferences) {
  const ScratchFolder scratch;
  const std::string folder = written(scratch, "a", triple());
  std::string text = bytes_of(folder + "/" + kFile);
  const std::size_t place = text.find("\"taper-limit\"");
  ASSERT_NE(place, std::string::npos);
  text.replace(place, 13, "\"value-sign\"");
  scratch.write(std::string("a/") + kFile, text);
  EXPECT_TRUE(any_has(findings(folder, true), "The reference says otherwise"));
}

TEST(Lint, AnIdHasItsForm) {
  const ScratchFolder scratch;
  CorpusFolder folder = triple();
  folder.files[kFile].resize(1);
  folder.files[kFile][0].id = "gsk.g94.1";
  EXPECT_TRUE(any_has(findings(written(scratch, "a", folder), true), "six digits"));
}

TEST(Lint, AnErratumIsOfACase) {
  const ScratchFolder scratch;
  const std::string folder = written(scratch, "a", triple());
  scratch.write("a/errata.toml",
                "[[erratum]]\nid = \"gsk.g95.000001\"\nversion = \"2025.1.0\"\nwhat = \"x\"\n"
                "since = \"2026.2.0\"\n");
  const auto said = findings(folder, false);
  EXPECT_TRUE(any_has(said, "gsk.g95.000001 is of no case"));
  EXPECT_TRUE(any_has(said, "put right in 2026.2.0, after this corpus"));
}

TEST(WriteCorpus, RefusesAFolderThatIsNotEmpty) {
  const ScratchFolder scratch;
  const std::string folder = written(scratch, "a", triple());
  EXPECT_TRUE(has(corpus_error([&] { oracle::write_corpus(folder, triple()); }), "is not empty"));
}

TEST(WriteCorpus, RefusesAnExpectationThatTheReferenceDoesNotConfirm) {
  const ScratchFolder scratch;
  CorpusFolder folder = triple();
  folder.files[kFile][0].expect[0].records.clear();
  folder.files[kFile][0].expect[0].not_covered = true;
  EXPECT_TRUE(has(corpus_error([&] { written(scratch, "a", folder); }), "says otherwise"));
}

TEST(CorpusDiff, ACorpusIsTheSameAsItself) {
  const ScratchFolder scratch;
  const std::string folder = written(scratch, "a", triple());
  EXPECT_TRUE(oracle::diff(oracle::Corpus(folder), oracle::Corpus(folder)).same());
}

TEST(CorpusDiff, NamesWhatWasAddedAndRemoved) {
  const ScratchFolder scratch;
  CorpusFolder fewer = triple();
  fewer.files[kFile].pop_back();
  const oracle::Corpus all(written(scratch, "a", triple()));
  const oracle::Corpus some(written(scratch, "b", fewer));
  const std::vector<std::string> id = {"gsk.g94.sign-0123456789.000003"};
  EXPECT_EQ(oracle::diff(some, all).added, id);
  EXPECT_EQ(oracle::diff(all, some).removed, id);
  EXPECT_EQ(oracle::diff(all, some).not_retired, id);
  fewer.retired.insert(id[0]);
  const oracle::Corpus retired(written(scratch, "c", fewer));
  EXPECT_TRUE(oracle::diff(all, retired).not_retired.empty());
}

TEST(CorpusDiff, NamesAnIdThatHasAnotherProgram) {
  const ScratchFolder scratch;
  CorpusFolder other = triple();
  Case& test = other.files[kFile][0];
  test.program = "G00 X100\n";
  test.expect = {oracle::expectation_of(test.profile, test.program)};
  const auto result = oracle::diff(oracle::Corpus(written(scratch, "a", triple())),
                                   oracle::Corpus(written(scratch, "b", other)));
  EXPECT_EQ(result.reused, std::vector<std::string>{test.id});
}

TEST(CorpusDiff, NamesAnExpectationThatChanged) {
  const ScratchFolder scratch;
  const std::string before = written(scratch, "a", triple());
  const std::string now = written(scratch, "b", triple());
  std::string text = bytes_of(now + "/" + kFile);
  text.replace(text.find("\"taper-limit\""), 13, "\"value-sign\"");
  scratch.write(std::string("b/") + kFile, text);
  const auto result = oracle::diff(oracle::Corpus(before), oracle::Corpus(now));
  EXPECT_EQ(result.changed, std::vector<std::string>{"gsk.g94.sign-0123456789.000003"});
  EXPECT_EQ(result.changed_ends,
            std::vector<std::string>{
                "gsk.g94.sign-0123456789.000003: taper-limit@2 value-out-of-range@2, now "
                "value-out-of-range@2 value-sign@2"});
}

}  // namespace
}  // namespace gonogo::testing
