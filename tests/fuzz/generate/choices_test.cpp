// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/choices.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace gonogo::generate {
namespace {

using Bytes = std::vector<std::uint8_t>;

using Noted = std::vector<NotedDecision>;

// 5 = 4 + 1; 0x0102 = 258; 7 of 10 is -3 where 0 is -10; one of one is no decision.
TEST(Choices, NoteWhichBytesDecideAndAmongHowMany) {
  const Bytes bytes = {5, 1, 2, 7, 0, 0, 9};
  Noted decisions;
  Choices choices(bytes);
  choices.note_in(decisions);
  EXPECT_EQ(choices.below(4), 1U);
  EXPECT_EQ(choices.below(1), 0U);
  EXPECT_EQ(choices.below(1000), 258U);
  EXPECT_EQ(choices.between(-10, -1), -3);
  EXPECT_EQ(choices.between(4, 4), 4);
  EXPECT_EQ(choices.between(4, 3), 4);  // empty
  EXPECT_EQ(choices.between(0, 65'536), 9);
  EXPECT_EQ(decisions, (Noted{{0, 1, 4}, {1, 2, 1000}, {3, 1, 10}, {4, 3, 65'537}}));
}

TEST(Choices, NoteNoDecisionWhoseBytesAreNotAllThere) {
  const Bytes bytes = {3, 7};
  Noted decisions;
  Choices choices(bytes);
  choices.note_in(decisions);
  choices.below(8);
  EXPECT_EQ(choices.below(1000), 792U);  // the missing byte is 0: 7 * 256 = 1792
  EXPECT_EQ(choices.below(8), 0U);
  EXPECT_TRUE(choices.exhausted());
  EXPECT_EQ(decisions, (Noted{{0, 1, 8}}));
}

}  // namespace
}  // namespace gonogo::generate
