// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers are those of the properties in the header.
#include "fuzz/program/mutator/program_mutator.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "grammar/parser.hpp"
#include "fuzz/program/text.hpp"

namespace gonogo::program {
namespace {

constexpr const char* kTaperFaceCut = "G00 X100 Z5\nG94 X50 Z-10 R-2.5 F100\n";

// Bytes of any kind, or a program.
rc::Gen<std::string> any_text() {
  return rc::gen::oneOf(
      rc::gen::arbitrary<std::string>(),
      rc::gen::element<std::string>(kTaperFaceCut, "", "\n", "%\r\n(\xE5\xAD\x97)\r",
                                    "R1=R2+SIN(30)", "G1X1Y1"));
}

std::size_t any_room() {
  return *rc::gen::inRange<std::size_t>(0, 600);
}

RC_GTEST_PROP(ProgramMutator, KeepsWithinTheRoomAndChanges, (std::uint32_t seed)) {
  const std::string text = *any_text();
  const std::size_t room = any_room();
  const std::string after = mutate_program(text, room, seed, nullptr);
  RC_ASSERT(after.size() <= room);                                // (1)
  RC_ASSERT(room == 0 || after != text);                          // (3)
  RC_ASSERT(mutate_program(text, room, seed, nullptr) == after);  // (2)
}

RC_GTEST_PROP(ProgramMutator, CrossesWithinTheRoom, (std::uint32_t seed)) {
  const std::string one = *any_text();
  const std::string other = *any_text();
  const std::size_t room = any_room();
  const std::string after = cross_programs(one, other, room, seed);
  RC_ASSERT(after.size() <= room);                             // (1)
  RC_ASSERT(cross_programs(one, other, room, seed) == after);  // (2)
}

TEST(ProgramMutator, ChangesATextThatFillsItsRoom) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const std::string after = mutate_program("X1", 2, seed, nullptr);
    EXPECT_LE(after.size(), 2U);
    EXPECT_NE(after, "X1");
  }
}

TEST(ProgramMutator, TakesWordsOfTheDialectAsked) {
  const Dictionary words{"none", {"QQQ7"}};
  std::size_t with_word = 0;
  for (std::uint32_t seed = 0; seed < 1'000; ++seed) {
    const std::string after = mutate_program(kTaperFaceCut, 200, seed, &words);
    with_word += after.find("QQQ") != std::string::npos ? 1U : 0U;
  }
  EXPECT_GT(with_word, 200U);
}

// What a mutator of bytes does not give: most of the blocks can still be read.
TEST(ProgramMutator, KeepsMostBlocksReadable) {
  std::size_t blocks = 0;
  std::size_t readable = 0;
  for (std::uint32_t seed = 0; seed < 2'000; ++seed) {
    const std::string after = mutate_program(kTaperFaceCut, 500, seed, find_dictionary("gsk988ta"));
    for (const program::TextLine& line : program::lines_of(after)) {
      grammar::Block block;
      const std::string text = program::text_of({{line.words, line.rest, ""}});
      ++blocks;
      readable += grammar::parse_block(grammar::Dialect::gsk988ta, text, block) ? 0U : 1U;
    }
  }
  EXPECT_GT(readable * 10, blocks * 8) << readable << " of " << blocks;
}

TEST(ProgramMutator, MakesMostlyDifferentTexts) {
  std::set<std::string> texts;
  for (std::uint32_t seed = 0; seed < 1'000; ++seed) {
    texts.insert(mutate_program(kTaperFaceCut, 500, seed, nullptr));
  }
  EXPECT_GT(texts.size(), 850U);
}

TEST(CrossPrograms, PutsBlocksOfBothTogether) {
  std::set<std::string> texts;
  for (std::uint32_t seed = 0; seed < 2'000; ++seed) {
    texts.insert(cross_programs("A1\nA2\nA3", "B1\nB2\n", 100, seed));
  }
  for (const char* text : {"A1\nB2\n", "A1\nA2\nA3\nB1\nB2\n", "A1\nB1\nA2\nA3",
                           "A1\nB1\nA2\nB2\nA3", "B1\nB2\n", "A1\nA2\nA3"}) {
    EXPECT_TRUE(texts.contains(text)) << text;
  }
}

TEST(CrossPrograms, CutsWholeBlocksWhereItMust) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    const std::string text = cross_programs("A1\nA2\nA3\n", "B1\nB2\n", 7, seed);
    EXPECT_EQ(text.size() % 3, 0U) << text;
  }
}

}  // namespace
}  // namespace gonogo::program
