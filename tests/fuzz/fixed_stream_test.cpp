// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stream of inputs of the test command, through the mutator of decisions.
#include "fuzz/targets/fixed_stream.hpp"

#include <gtest/gtest.h>

#include <set>

#include "fuzz/targets/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t*, std::size_t) {
  return 0;
}

namespace gonogo::fuzz {
namespace {

constexpr std::size_t kMostBytes = 24;
const std::vector<Bytes> kStored = {Bytes(5, 1), Bytes(40, 2)};

TEST(FixedStream, GivesAnInputByItsNumberWhateverCameBefore) {
  const FixedStream one(kStored, 7, kMostBytes);
  const FixedStream other(kStored, 7, kMostBytes);
  std::vector<Bytes> forwards;
  for (std::uint64_t number = 0; number < 200; ++number) forwards.push_back(one.input(number));
  for (std::uint64_t number = 200; number-- > 0;) {
    EXPECT_EQ(other.input(number), forwards[number]) << number;
  }
}

TEST(FixedStream, StaysWithinTheBytesAndHardlyRepeats) {
  const FixedStream stream(kStored, 7, kMostBytes);
  std::set<Bytes> different;
  for (std::uint64_t number = 0; number < 500; ++number) {
    const Bytes input = stream.input(number);
    EXPECT_LE(input.size(), kMostBytes);
    different.insert(input);
  }
  EXPECT_GT(different.size(), 450U);
}

TEST(FixedStream, IsAnotherOneWithAnotherSeedAndNeedsNothingStored) {
  const FixedStream one({}, 1, kMostBytes);
  const FixedStream other({}, 2, kMostBytes);
  std::size_t equal = 0;
  for (std::uint64_t number = 0; number < 100; ++number) {
    EXPECT_FALSE(one.input(number).empty());
    if (one.input(number) == other.input(number)) ++equal;
  }
  EXPECT_LT(equal, 5U);
}

}  // namespace
}  // namespace gonogo::fuzz
