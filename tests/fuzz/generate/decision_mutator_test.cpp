// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers are those of the properties in the header.
#include "fuzz/generate/decision_mutator.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "fuzz/generate/generator.hpp"
#include "oracle/differential/differential.hpp"

namespace gonogo::generate {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Noted = std::vector<NotedDecision>;
constexpr std::size_t kRoom = 128;

std::string decided_program(const Generator& generator, const Bytes& bytes, Noted* noted) {
  Choices choices(bytes);
  if (noted != nullptr) choices.note_in(*noted);
  const GeneratedProgram program = generator.generate(choices, in_process_settings(), nullptr);
  return oracle::profile_text(program.profile) + program.text;
}

Bytes random_bytes(std::uint64_t seed) {
  Choices random(seed);
  Bytes bytes(kRoom);
  std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(random.below(256)); });
  return bytes;
}

std::uint64_t value_of(const Bytes& bytes, const NotedDecision& decision) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < decision.bytes; ++i) value = value << 8 | bytes[decision.at + i];
  return value % decision.count;
}

RC_GTEST_PROP(DecisionMutator, FillsTheRoomAndFollowsFromItsArguments,
              (Bytes bytes, std::uint32_t seed)) {
  const Generator& generator = *rc::gen::elementOf(generators());
  const auto room = *rc::gen::inRange<std::size_t>(0, 300);
  Noted noted;
  decided_program(generator, bytes, &noted);
  RC_ASSERT(deciding_bytes(noted) <= bytes.size());
  const Bytes after = mutate_decisions(bytes, noted, room, seed);
  RC_ASSERT(after.size() == room);                                 // (1)
  RC_ASSERT(mutate_decisions(bytes, noted, room, seed) == after);  // (2)
}

// Decisions of one, two and five bytes.
TEST(DecisionMutator, DecidesOtherwise) {
  const Noted noted = {{0, 1, 2}, {1, 2, 501}, {3, 5, 1ULL << 33}, {8, 1, 256}};
  const Bytes bytes = random_bytes(7);
  std::size_t moved = 0;
  for (std::uint32_t seed = 0; seed < 2'000; ++seed) {
    const Bytes after = mutate_decisions(bytes, noted, kRoom, seed);
    moved += std::ranges::any_of(noted, [&](const NotedDecision& decision) {
      return value_of(after, decision) != value_of(bytes, decision);
    });
  }
  EXPECT_GE(moved, 1'900U);  // (3); what is made once more may be the same as before
}

TEST(DecisionMutator, HasRandomBytesWhereThereWereNoDecisions) {
  const Bytes after = mutate_decisions({}, {}, kRoom, 1);
  EXPECT_EQ(after.size(), kRoom);
  EXPECT_NE(after, mutate_decisions({}, {}, kRoom, 2));
}

// What a mutator of bytes does not give: nearly all that it changes shows, where the bytes decide
// all of a program and nothing else; a tenth of the decisions are rarely taken, as is one word of
// forty.
TEST(DecisionMutator, MakesMostlyOtherPrograms) {
  constexpr std::size_t kPrograms = 500;
  for (const Generator& generator : generators()) {
    std::size_t other = 0;
    for (std::uint32_t seed = 0; seed < kPrograms; ++seed) {
      const Bytes bytes = random_bytes(seed);
      Noted noted;
      const std::string before = decided_program(generator, bytes, &noted);
      const Bytes after = mutate_decisions(bytes, noted, kRoom, seed);
      other += decided_program(generator, after, nullptr) == before ? 0U : 1U;
    }
    EXPECT_GT(other * 10, kPrograms * 6) << generator.dialect << ": " << other;
  }
}

}  // namespace
}  // namespace gonogo::generate
