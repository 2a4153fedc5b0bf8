// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/minimise.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace gonogo::cover {
namespace {

using Purposes = std::vector<std::set<std::string>>;

TEST(SmallestCover, LeavesOutWhatOthersServe) {
  EXPECT_EQ(smallest_cover(Purposes{{"a"}, {"a", "b"}, {"b"}}), (std::vector<std::size_t>{1}));
}

TEST(SmallestCover, KeepsTheFirstOfEquals) {
  EXPECT_EQ(smallest_cover(Purposes{{"a"}, {"a"}}), (std::vector<std::size_t>{0}));
}

// Greedy takes the case of four purposes first, and the two others then serve all that it did.
TEST(SmallestCover, LeavesOutAgainWhatBecameSuperfluous) {
  const Purposes purposes = {{"b", "c", "e", "f"}, {"a", "b", "c"}, {"d", "e", "f"}};
  EXPECT_EQ(smallest_cover(purposes), (std::vector<std::size_t>{1, 2}));
}

RC_GTEST_PROP(SmallestCover, ServesAllAndCannotBeSmaller, ()) {
  const auto numbers = *rc::gen::container<std::vector<std::vector<int>>>(
      rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 12)));
  Purposes purposes;
  std::set<std::string> all;
  for (const std::vector<int>& own : numbers) {
    std::set<std::string>& texts = purposes.emplace_back();
    for (const int number : own) texts.insert(std::to_string(number));
    all.insert(texts.begin(), texts.end());
  }
  const std::vector<std::size_t> kept = smallest_cover(purposes);
  const auto served = [&](std::size_t without) {
    std::set<std::string> some;
    for (const std::size_t i : kept) {
      if (i != without) some.insert(purposes[i].begin(), purposes[i].end());
    }
    return some;
  };
  RC_ASSERT(served(purposes.size()) == all);
  for (const std::size_t i : kept) RC_ASSERT(served(i) != all);
}

}  // namespace
}  // namespace gonogo::cover
