// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is written is read again, to the byte.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "corpus_testing.hpp"
#include "oracle/records/text.hpp"
#include "tests/has.hpp"

namespace gonogo::testing {
namespace {

TEST(RoundTrip, EveryCheckedInFileIsWrittenAsItStands) {
  const oracle::Corpus corpus(corpus_folder());
  for (const std::string& file : corpus.files()) {
    const std::string path = corpus_folder() + "/" + file;
    EXPECT_TRUE(oracle::vector_file_text(corpus.version(), oracle::read_vector_file(path)) ==
                bytes_of(path))
        << file;
  }
}

TEST(RoundTrip, TheOrderOfTheCasesDoesNotMatter) {
  const std::string path = corpus_folder() + "/vectors/gsk988ta/g94.json";
  auto cases = oracle::read_vector_file(path);
  std::ranges::reverse(cases);
  EXPECT_TRUE(oracle::vector_file_text(kCorpusVersion, cases) == bytes_of(path));
}

oracle::Case case_of(const std::string& program) {
  oracle::Case test;
  test.id = "t.a.000001";
  test.comment = "a \"quoted\" \\ comment";
  test.program = program;
  test.dialect = "gsk988ta";
  test.cycle = "g94";
  test.group = "t.a";
  test.features = {"g94"};
  test.clauses = {"GSK-G94-01"};
  test.provenance = "property";
  test.expect = {oracle::expectation_of(test.profile, program)};
  return test;
}

RC_GTEST_PROP(RoundTrip, AProgramOfAnyBytes, (const std::string& program)) {
  const ScratchFolder scratch;
  const oracle::Case test = case_of(program);
  const auto file = scratch.write("a.json", oracle::vector_file_text("2026.2.0", {test}));
  const auto again = oracle::read_vector_file(file);
  RC_ASSERT(again.size() == 1U);
  RC_ASSERT(again[0].program == program);
  RC_ASSERT(again[0].comment == test.comment);
  RC_ASSERT(expectation_json(again[0].expect.at(0)) == expectation_json(test.expect[0]));
}

RC_GTEST_PROP(RoundTrip, Base64, (const std::string& bytes)) {
  RC_ASSERT(oracle::decode_base64(oracle::base64(bytes)) == bytes);
}

TEST(RoundTrip, ProgramsThatAreNotUtf8AreBase64) {
  const std::string text = oracle::vector_file_text("2026.2.0", {case_of("(\xbd\xe1)\n")});
  EXPECT_TRUE(has(text, "\"program\": {\"base64\": \"KL3hKQo=\"}"));
}

TEST(RoundTrip, CasesOfOneGroupMustAgree) {
  oracle::Case other = case_of("");
  other.id = "t.a.000002";
  other.clauses = {"GSK-G94-02"};
  EXPECT_NE(corpus_error([&] { oracle::vector_file_text("1", {case_of(""), other}); }), "");
}

TEST(RoundTrip, CasesOfTwoCyclesAreTwoFiles) {
  oracle::Case other = case_of("");
  other.id = "t.a.000002";
  other.cycle = "g110";
  EXPECT_NE(corpus_error([&] { oracle::vector_file_text("1", {case_of(""), other}); }), "");
}

}  // namespace
}  // namespace gonogo::testing
