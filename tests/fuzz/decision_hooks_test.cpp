// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mutator through the function that an engine calls, where there is no libFuzzer behind it.
#include "fuzz/targets/decision_hooks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "fuzz/generate/decision_mutator.hpp"

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed);

namespace gonogo::fuzz {
namespace {

constexpr std::size_t kSize = 32;
constexpr std::size_t kMost = 64;
int times_decided = 0;

}  // namespace

// The target: as many decisions among a thousand as the first one says.
void decide(generate::Choices& choices) {
  ++times_decided;
  for (std::uint32_t left = choices.below(16); left > 0; --left) choices.below(1000);
}

namespace {

std::vector<std::uint8_t> input(std::uint8_t first) {
  std::vector<std::uint8_t> bytes(kMost + 8, 0xAA);
  std::fill(bytes.begin(), bytes.begin() + kSize, std::uint8_t{1});
  bytes[0] = first;
  return bytes;
}

std::vector<generate::NotedDecision> decisions_of(const std::vector<std::uint8_t>& bytes) {
  std::vector<generate::NotedDecision> noted;
  generate::Choices choices({bytes.data(), kSize});
  choices.note_in(noted);
  decide(choices);
  return noted;
}

TEST(DecisionHooks, MutateInPlaceWhatTheInputDecides) {
  for (unsigned int seed = 0; seed < 500; ++seed) {
    std::vector<std::uint8_t> bytes = input(static_cast<std::uint8_t>(seed));
    const auto noted = decisions_of(bytes);
    ASSERT_EQ(noted.size(), 1 + seed % 16);
    const auto want = generate::mutate_decisions({bytes.data(), kSize}, noted, kMost, seed);
    ASSERT_EQ(LLVMFuzzerCustomMutator(bytes.data(), kSize, kMost, seed), kMost);
    EXPECT_TRUE(std::ranges::equal(want, std::span(bytes).first(kMost)));
    EXPECT_EQ(bytes[kMost], 0xAA);
  }
}

TEST(DecisionHooks, DecideAgainOnlyForAnotherInputThanTheLast) {
  std::vector<std::uint8_t> bytes = input(3);
  generate::Choices choices = choices_of(bytes.data(), kSize);
  decide(choices);
  const int before = times_decided;
  std::vector<std::uint8_t> same = bytes;
  LLVMFuzzerCustomMutator(same.data(), kSize, kMost, 1);
  EXPECT_EQ(times_decided, before);
  std::vector<std::uint8_t> other = input(4);
  LLVMFuzzerCustomMutator(other.data(), kSize, kMost, 1);
  EXPECT_EQ(times_decided, before + 1);
}

}  // namespace
}  // namespace gonogo::fuzz
