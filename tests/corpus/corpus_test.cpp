// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checked-in corpus as a whole.
#include "corpus/io/corpus.hpp"

#include <gtest/gtest.h>

#include "corpus/io/recheck.hpp"
#include "corpus/io/sha256.hpp"
#include "corpus/recipes/corpus_text.hpp"
#include "corpus_testing.hpp"
#include "tests/has.hpp"

namespace gonogo::testing {
namespace {

const std::string kRecipes = corpus_folder() + "/recipes";

TEST(CheckedInCorpus, HasItsVersionAndAHash) {
  const oracle::Corpus corpus(corpus_folder());
  EXPECT_EQ(corpus.version(), kCorpusVersion);
  EXPECT_EQ(corpus.sha256().size(), 64U);
}

TEST(CheckedInCorpus, HasHundredsOfCases) {
  EXPECT_GE(checked_in_cases().size(), 250U);
}

TEST(CheckedInCorpus, IsWhatTheRecipesGiveByteForByte) {
  const recipes::CorpusText made = recipes::corpus_from_recipes(kRecipes);
  for (const auto& [name, text] : made.files) {
    EXPECT_TRUE(bytes_of(corpus_folder() + "/" + name) == text)
        << name << " is not what its recipe gives: run gonogo corpus build";
  }
  EXPECT_EQ(oracle::Corpus(corpus_folder()).files().size(), made.files.size() - 1);
}

TEST(CheckedInCorpus, EveryExpectationIsWhatTheReferenceSays) {
  std::size_t cases = 0;
  const oracle::Corpus corpus(corpus_folder());
  for (const std::string& file : corpus.files()) {
    EXPECT_NO_THROW(cases += oracle::recheck_file(corpus_folder() + "/" + file)) << file;
  }
  EXPECT_EQ(cases, checked_in_cases().size());
}

TEST(CheckedInCorpus, ARecheckFindsAWrongNumber) {
  const ScratchFolder scratch;
  std::string text = bytes_of(corpus_folder() + "/vectors/gsk988ta/g94.json");
  const std::size_t place = text.find(R"("z":"-40")");
  ASSERT_NE(place, std::string::npos);
  text.replace(place, 9, R"("z":"-41")");
  const std::string file = scratch.write("g94.json", text);
  EXPECT_TRUE(
      has(corpus_error([&] { oracle::recheck_file(file); }), "The reference says otherwise"));
}

TEST(CheckedInCorpus, FilesComeInTheOrderOfNamesAndCasesOfIds) {
  std::string last_file;
  const oracle::Corpus corpus(corpus_folder());
  for (const std::string& file : corpus.files()) {
    EXPECT_LT(last_file, file);
    last_file = file;
    std::string last_id;
    for (const oracle::Case& test : oracle::read_vector_file(corpus_folder() + "/" + file)) {
      EXPECT_LT(last_id, test.id);
      last_id = test.id;
    }
  }
}

TEST(CheckedInCorpus, TheHashChangesWithAByteOfAFile) {
  const ScratchFolder scratch;
  const std::string manifest =
      R"({"format":1,"version":"1.0.0","license":"x","files":["vectors/a.json"],"retired":[]})";
  scratch.write("manifest.json", manifest);
  scratch.write("vectors/a.json", "{}");
  const std::string before = oracle::Corpus(scratch.path().string()).sha256();
  scratch.write("vectors/a.json", "{} ");
  EXPECT_NE(oracle::Corpus(scratch.path().string()).sha256(), before);
}

TEST(Sha256, IsThatOfFips180) {
  oracle::Sha256 hash;
  hash.update("a");
  hash.update("bc");
  EXPECT_EQ(hash.hex(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(hash.hex(), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace gonogo::testing
