// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/candidates.hpp"
#include "reference/reading_literal.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

namespace gonogo::identify {
namespace {

constexpr ReadingKey kA = "gsk.g94.rewrite"_key;
constexpr ReadingKey kB = "gsk.pocket.end"_key;
constexpr ReadingKey kC = "gsk.decimals"_key;
constexpr std::size_t kMost = 1'000;

// 2 x 2 x 3 assignments.
Candidates three() {
  Candidates candidates;
  candidates.add(kA, 2);
  candidates.add(kB, 2);
  candidates.add(kC, 3);
  return candidates;
}

TEST(Candidates, CountsTheAssignmentsInBits) {
  Candidates candidates;
  candidates.add(kA, 2);
  candidates.add(kC, 4);
  EXPECT_EQ(candidates.bits(), 3);  // 2 * 4 = 2^3
}

TEST(Candidates, StrikesOutAValue) {
  Candidates candidates = three();
  const PartialAssignment left[] = {{{kC, 0}}, {{kC, 2}}};
  ASSERT_TRUE(candidates.keep(std::vector{kC}, left, kMost));
  EXPECT_EQ(candidates.values(kC), (std::vector<ReadingValue>{0, 2}));
  EXPECT_EQ(candidates.values(kA), (std::vector<ReadingValue>{0, 1}));
}

TEST(Candidates, KeepsValuesThatDependOnEachOtherTogether) {
  Candidates candidates = three();
  // Both or neither: of the 4 rows of A and B two are left, and each still has both values.
  const PartialAssignment left[] = {{{kA, 0}, {kB, 0}}, {{kA, 1}, {kB, 1}}};
  ASSERT_TRUE(candidates.keep(std::vector{kA, kB}, left, kMost));
  EXPECT_EQ(candidates.values(kA).size(), 2U);
  const PartialAssignment a_is_1[] = {{{kA, 1}}};
  ASSERT_TRUE(candidates.keep(std::vector{kA}, a_is_1, kMost));
  EXPECT_EQ(candidates.values(kB), (std::vector<ReadingValue>{1}));
}

TEST(Candidates, TakesIndependentReadingsApartAgain) {
  Candidates candidates = three();
  const PartialAssignment left[] = {{{kA, 0}}};  // says nothing of B
  ASSERT_TRUE(candidates.keep(std::vector{kA, kB}, left, kMost));
  EXPECT_EQ(candidates.joined(std::vector{kA}, kMost)->keys, std::vector{kA});
}

TEST(Candidates, AnImpossibleStrikeChangesNothing) {
  Candidates candidates = three();
  EXPECT_FALSE(candidates.keep(std::vector{kA}, {}, kMost));
  EXPECT_EQ(candidates.values(kA).size(), 2U);
}

TEST(Candidates, JoinsNoMoreRowsThanAskedFor) {
  EXPECT_FALSE(three().joined(std::vector{kA, kB, kC}, 11).has_value());
  EXPECT_EQ(three().joined(std::vector{kA, kB, kC}, 12)->rows.size(), 12U);
}

// Against a plain list of all twelve assignments.
RC_GTEST_PROP(Candidates, StrikesLikeAPlainList, ()) {
  std::set<std::vector<int>> plain;
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) {
      for (int c = 0; c < 3; ++c) plain.insert({a, b, c});
    }
  }
  Candidates candidates = three();
  const auto strikes = *rc::gen::container<std::vector<std::vector<std::vector<int>>>>(
      rc::gen::container<std::vector<std::vector<int>>>(
          rc::gen::container<std::vector<int>>(3, rc::gen::inRange(-1, 3))));
  const std::vector<ReadingKey> keys = {kA, kB, kC};
  for (const auto& strike : strikes) {
    std::vector<PartialAssignment> left;
    std::set<std::vector<int>> rest;
    for (const std::vector<int>& one : strike) {
      PartialAssignment& partial = left.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        if (one[i] >= 0) partial.emplace_back(keys[i], static_cast<ReadingValue>(one[i]));
      }
      for (const auto& row : plain) {
        bool agrees = true;
        for (std::size_t i = 0; i < 3; ++i) agrees = agrees && (one[i] < 0 || one[i] == row[i]);
        if (agrees) rest.insert(row);
      }
    }
    RC_ASSERT(candidates.keep(keys, left, kMost) == !rest.empty());
    if (!rest.empty()) plain = rest;
    for (std::size_t i = 0; i < 3; ++i) {
      std::set<ReadingValue> values;
      for (const auto& row : plain) values.insert(static_cast<ReadingValue>(row[i]));
      RC_ASSERT(candidates.values(keys[i]) ==
                std::vector<ReadingValue>(values.begin(), values.end()));
    }
    RC_ASSERT(candidates.joined(keys, kMost)->rows.size() == plain.size());
  }
}

}  // namespace
}  // namespace gonogo::identify
