// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-PROP-07: no trace that is wrong is GO, and none is left undecided.
#include <gtest/gtest.h>

#include "bench.hpp"

namespace gonogo::mutations {
namespace {

TEST(Mutations, NoneThatIsWrongIsGo) {
  Chance chance(trial_seed());
  const RawCases cases = cases_of_corpus(GONOGO_SOURCE_DIR "/corpus");
  Bench bench(cases);
  bench.run(chance, trial_count(60'000));
  bench.print();
  EXPECT_TRUE(bench.survivors().empty());
  EXPECT_TRUE(bench.faults().empty());
  EXPECT_TRUE(bench.untried().empty()) << bench.untried().front();
}

}  // namespace
}  // namespace gonogo::mutations
