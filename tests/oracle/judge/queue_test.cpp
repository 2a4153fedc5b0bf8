// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/steps/queue.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>
#include <memory>
#include <vector>

namespace gonogo::oracle {
namespace {

// Below zero: one goes out; else the number comes in.
RC_GTEST_PROP(Queue, IsThatOfTheStandardLibrary, ()) {
  Queue<int> queue;
  std::deque<int> expected;
  for (const int step : *rc::gen::container<std::vector<int>>(rc::gen::inRange(-60, 100))) {
    if (step >= 0) {
      queue.push_back(step);
      expected.push_back(step);
    } else if (!expected.empty()) {
      queue.pop_front();
      expected.pop_front();
    }
    RC_ASSERT(queue.size() == expected.size());
    RC_ASSERT(std::vector<int>(queue.begin(), queue.end()) ==
              std::vector<int>(expected.begin(), expected.end()));
  }
}

// A queue that is never empty gives up what has gone out: at most as much as is still in it.
TEST(Queue, DoesNotKeepWhatHasGone) {
  Queue<std::shared_ptr<int>> queue;
  const auto counted = std::make_shared<int>();
  queue.push_back(counted);
  for (int i = 0; i < 1'000; ++i) {
    queue.push_back(counted);
    queue.pop_front();
    EXPECT_LE(counted.use_count(), 1 + 2 + 1);
  }
}

}  // namespace
}  // namespace gonogo::oracle
