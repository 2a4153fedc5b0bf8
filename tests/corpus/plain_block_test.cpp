// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every line of every program of the corpus is read alike by the filter for plain blocks and by the
// grammars, in each dialect.
#include <gtest/gtest.h>

#include "corpus/io/corpus.hpp"
#include "grammar/line_source.hpp"
#include "tests/grammar/both_readings.hpp"

namespace gonogo::grammar {
namespace {

TEST(PlainBlock, ReadsEveryLineOfTheCorpusAsTheGrammarsDo) {
  const oracle::Corpus corpus(std::string(GONOGO_SOURCE_DIR) + "/corpus");
  std::size_t lines_read = 0;
  corpus.for_each([&](const oracle::Case& test) {
    if (::testing::Test::HasFatalFailure()) return;
    MemorySource bytes(test.program);
    LineSource lines(bytes);
    for (Line line; lines.next(line); ++lines_read) {
      for (const Dialect dialect : kDialects) expect_both_read_alike(dialect, line.text);
    }
  });
  EXPECT_GT(lines_read, 10'000U);
}

}  // namespace
}  // namespace gonogo::grammar
