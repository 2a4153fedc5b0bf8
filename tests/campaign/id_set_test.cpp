// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/id_set.hpp"

#include <gtest/gtest.h>

#include <string>

namespace gonogo::oracle {
namespace {

TEST(IdSet, HasWhatWasInsertedAndNothingElse) {
  IdSet ids;
  EXPECT_FALSE(ids.contains("a.0"));
  for (int i = 0; i < 10'000; ++i) EXPECT_TRUE(ids.insert("a." + std::to_string(i)));
  for (int i = 0; i < 10'000; ++i) EXPECT_TRUE(ids.contains("a." + std::to_string(i)));
  EXPECT_FALSE(ids.contains("a.10000"));
  EXPECT_EQ(ids.size(), 10'000U);
}

TEST(IdSet, TellsASecondInsertionOfAnId) {
  IdSet ids;
  EXPECT_TRUE(ids.insert("gsk.g94.000001"));
  EXPECT_FALSE(ids.insert("gsk.g94.000001"));
  EXPECT_EQ(ids.size(), 1U);
}

}  // namespace
}  // namespace gonogo::oracle
