// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/program_text.hpp"

#include <gtest/gtest.h>

#include "secret_subject.hpp"

namespace gonogo::identify {
namespace {

using reference::Number;
using testing::default_machine;

ProgramText text_of(const char* program, const char* dialect = "gsk988ta") {
  return {default_machine(dialect), program};
}

// Every word of the address doubled.
std::optional<std::string> doubled(const ProgramText& program, const char* address) {
  return edited(program,
                [&](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
                  if (word.address != address || !word.value) return std::nullopt;
                  return with_value(block, word, *word.value * 2);
                });
}

TEST(ProgramText, KeepsWhatIsNotEdited) {
  const char* program = "G00 X1 (a comment)\r\n\r\n; rest\nG94 X-0.5 R.5\n";
  EXPECT_EQ(text_of(program).text(), program);
}

TEST(ProgramText, ReplacesAWordWhereItStands) {
  EXPECT_EQ(doubled(text_of("G94 X10R-.5 Z-30\nX20 (R1)\n"), "R"), "G94 X10R-1 Z-30\nX20 (R1)\n");
}

TEST(ProgramText, SaysWhenNothingChanges) {
  EXPECT_EQ(doubled(text_of("G00 X10\n"), "R"), std::nullopt);
}

TEST(ProgramText, ReplacesNamedWordsOfSinumerik) {
  EXPECT_EQ(doubled(text_of("G1 X=AC(10) CR=-3\nR105=2.5\n", "sinumerik802s"), "X"),
            "G1 X=AC(20) CR=-3\nR105=2.5\n");
  EXPECT_EQ(doubled(text_of("G2 X10 CR=-3\n", "sinumerik840d"), "CR"), "G2 X10 CR=-6\n");
  EXPECT_EQ(doubled(text_of("R105=2.5\n", "sinumerik802s"), "R105"), "R105=5\n");
}

TEST(ProgramText, KnowsTheModesOfABlock) {
  const ProgramText program = text_of("G17 G20\nG94 X1\nX2\nG4 X1\nX3\n");
  EXPECT_EQ(program.blocks[1].motion, "G94");
  EXPECT_TRUE(program.blocks[1].own_motion);
  EXPECT_EQ(program.blocks[2].motion, "G94");
  EXPECT_FALSE(program.blocks[2].own_motion);
  EXPECT_EQ(program.blocks[3].motion, "G4");
  EXPECT_EQ(program.blocks[4].motion, "G94");
  EXPECT_EQ(program.blocks[4].plane, 17);
  EXPECT_TRUE(program.blocks[4].inch);
}

TEST(ProgramText, WritesAQuotientThatHasNoLastDecimal) {
  const ProgramText program = text_of("G00 X1\n");
  const TextBlock& block = program.blocks[0];
  // 1 / 25.4 = 0.03937007874015748...
  EXPECT_EQ(with_value(block, *block.find("X"), Number(5) / 127), "X0.039370078740157");
}

}  // namespace
}  // namespace gonogo::identify
