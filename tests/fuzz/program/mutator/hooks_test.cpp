// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mutator through the functions that an engine calls, where there is no libFuzzer behind them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

#include "fuzz/targets/fixed_stream.hpp"
#include "fuzz/targets/target.hpp"
#include "fuzz/program/mutator/program_mutator.hpp"

using Bytes = std::vector<std::uint8_t>;

extern "C" {
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                    unsigned int seed);
std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* one, std::size_t one_size,
                                      const std::uint8_t* other, std::size_t other_size,
                                      std::uint8_t* out, std::size_t most, unsigned int seed);
// The stream runs it; these tests only look at inputs.
int LLVMFuzzerTestOneInput(const std::uint8_t*, std::size_t) {
  return 0;
}
}

namespace gonogo::program {
namespace {

constexpr std::string_view kFaceCut = "G94 X50 Z-10 F100\n";
constexpr std::size_t kRoom = 64;
constexpr std::uint8_t kBeyond = 0xAA;  // what stands behind the room

Bytes buffer() {
  Bytes bytes(kRoom + 8, kBeyond);
  std::ranges::copy(kFaceCut, bytes.begin());
  return bytes;
}

void expect_kept_within(const Bytes& bytes, std::size_t size) {
  EXPECT_LE(size, kRoom);
  EXPECT_TRUE(std::all_of(bytes.begin() + kRoom, bytes.end(),
                          [](std::uint8_t byte) { return byte == kBeyond; }));
}

TEST(MutatorHooks, MutateInPlaceWithTheTargetsDictionary) {
  for (unsigned int seed = 0; seed < 500; ++seed) {
    Bytes bytes = buffer();
    const std::size_t size = LLVMFuzzerCustomMutator(bytes.data(), kFaceCut.size(), kRoom, seed);
    expect_kept_within(bytes, size);
    EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)),
              mutate_program(kFaceCut, kRoom, seed, find_dictionary(GONOGO_FUZZ_DIALECT)));
  }
}

TEST(MutatorHooks, CrossIntoTheRoom) {
  const Bytes one(kFaceCut.begin(), kFaceCut.end());
  for (unsigned int seed = 0; seed < 500; ++seed) {
    Bytes out(kRoom + 8, kBeyond);
    const std::size_t size = LLVMFuzzerCustomCrossOver(one.data(), one.size(), one.data(),
                                                       one.size(), out.data(), kRoom, seed);
    expect_kept_within(out, size);
  }
}

// Programs of two stored ones, changed: the same for the same number, and most of them keep a word of an axis.
TEST(MutatorHooks, MakeAFixedStreamOfPrograms) {
  const std::vector<Bytes> stored = {buffer(), Bytes(kFaceCut.begin(), kFaceCut.end())};
  const fuzz::FixedStream one(stored, 3, kRoom);
  const fuzz::FixedStream other(stored, 3, kRoom);
  int with_axis = 0;
  for (std::uint64_t number = 0; number < 300; ++number) {
    const Bytes input = one.input(number);
    EXPECT_EQ(input, other.input(number));
    EXPECT_LE(input.size(), kRoom);
    if (std::ranges::find_first_of(input, std::string_view("XZ")) != input.end()) ++with_axis;
  }
  EXPECT_GT(with_axis, 200);
}

}  // namespace
}  // namespace gonogo::program
