// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/errata.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "corpus_testing.hpp"
#include "tests/has.hpp"

namespace gonogo::testing {
namespace {

// What is wrong with an errata file of this text.
std::string errata_error(std::string_view text) {
  const ScratchFolder scratch;
  scratch.write("errata.toml", text);
  return corpus_error([&] { oracle::read_errata(scratch.path().string()); });
}

constexpr std::string_view kGoodErratum =
    "[[erratum]]\nid = \"a.b.000001\"\nversion = \"2026.9.0\"\nwhat = \"A sentence.\"\n"
    "since = \"2026.10.0\"\n";

TEST(Errata, ACorpusWithoutAFileHasNone) {
  EXPECT_TRUE(oracle::read_errata(ScratchFolder().path().string()).empty());
}

TEST(Errata, AnEntryHasFourTexts) {
  const ScratchFolder scratch;
  scratch.write("errata.toml", kGoodErratum);
  const auto errata = oracle::read_errata(scratch.path().string());
  ASSERT_EQ(errata.size(), 1U);
  EXPECT_EQ(errata[0].id, "a.b.000001");
  EXPECT_EQ(errata[0].what, "A sentence.");
}

TEST(Errata, AMissingTextIsNamed) {
  std::string text(kGoodErratum);
  text.erase(text.find("what"), text.find("since") - text.find("what"));
  EXPECT_TRUE(has(errata_error(text), "needs the text what"));
}

TEST(Errata, AnUnknownKeyIsNamed) {
  EXPECT_TRUE(has(errata_error(std::string(kGoodErratum) + "why = \"x\"\n"), "no key why"));
}

// 2026.10.0 is after 2026.9.0 though it sorts before it as a text.
TEST(Errata, VersionsAreComparedByTheirNumbers) {
  EXPECT_TRUE(oracle::is_before("2026.9.0", "2026.10.0"));
  EXPECT_FALSE(oracle::is_before("2026.10.0", "2026.10.0"));
  EXPECT_FALSE(oracle::is_before("2027.0.0", "2026.10.0"));
}

TEST(Errata, WhatWasWrongWasWrongBeforeItWasRight) {
  std::string text(kGoodErratum);
  text.replace(text.find("2026.10.0"), 9, "2026.9.0");
  EXPECT_TRUE(has(errata_error(text), "which is not before 2026.9.0"));
}

TEST(Errata, OneMayBeOfManyCases) {
  EXPECT_TRUE(oracle::is_covered("ngc.*", "ngc.arc-r.000001"));
  EXPECT_TRUE(oracle::is_covered("ngc.arc-r.000001", "ngc.arc-r.000001"));
  EXPECT_FALSE(oracle::is_covered("ngc.*", "gsk.ngc.000001"));
  EXPECT_FALSE(oracle::is_covered("ngc.arc-r.000001", "ngc.arc-r.000002"));
}

TEST(Errata, TheCheckedInOnesAreOfCasesThatAreThereOrRetired) {
  const oracle::Corpus corpus(corpus_folder());
  std::set<std::string> ids(corpus.retired().begin(), corpus.retired().end());
  corpus.for_each([&](const oracle::Case& test) { ids.insert(test.id); });
  const auto errata = oracle::read_errata(corpus_folder());
  EXPECT_GE(errata.size(), 7U);
  for (const oracle::Erratum& erratum : errata) {
    EXPECT_TRUE(std::ranges::any_of(ids, [&](const std::string& id) {
      return oracle::is_covered(erratum.id, id);
    })) << erratum.id;
  }
}

}  // namespace
}  // namespace gonogo::testing
