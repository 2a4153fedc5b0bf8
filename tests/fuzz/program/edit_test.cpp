// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/edit.hpp"

#include <gtest/gtest.h>

namespace gonogo::program {
namespace {

using reference::Number;
using reference::Profile;

ProgramText text_of(const char* program, const char* dialect = "gsk988ta") {
  return {std::get<Profile>(reference::default_profile(dialect)), program};
}

// Every word of the address doubled.
std::optional<std::string> doubled(const ProgramText& program, const char* address) {
  return edited(program, [&](const TextBlock&, const TextWord& word) -> std::optional<std::string> {
    const auto value = exact_value_of(word);
    if (name_of(word) != address || !value) return std::nullopt;
    return with_value(word, *value * 2);
  });
}

TEST(ProgramEdit, KeepsWhatIsNotEdited) {
  const char* program = "G00 X1 (a comment)\r\n\r\n; rest\nG94 X-0.5 R.5\n";
  EXPECT_EQ(text_of(program).text(), program);
}

TEST(ProgramEdit, ReplacesAWordWhereItStands) {
  EXPECT_EQ(doubled(text_of("G94 X10R-.5 Z-30\nX20 (R1)\n"), "R"), "G94 X10R-1 Z-30\nX20 (R1)\n");
}

TEST(ProgramEdit, SaysWhenNothingChanges) {
  EXPECT_EQ(doubled(text_of("G00 X10\n"), "R"), std::nullopt);
}

TEST(ProgramEdit, ReplacesNamedWordsOfSinumerik) {
  EXPECT_EQ(doubled(text_of("G1 X=AC(10) CR=-3\nR105=2.5\n", "sinumerik802s"), "X"),
            "G1 X=AC(20) CR=-3\nR105=2.5\n");
  EXPECT_EQ(doubled(text_of("G2 X10 CR=-3\n", "sinumerik840d"), "CR"), "G2 X10 CR=-6\n");
  EXPECT_EQ(doubled(text_of("R105=2.5\n", "sinumerik802s"), "R105"), "R105=5\n");
}

TEST(ProgramEdit, WritesAQuotientThatHasNoLastDecimal) {
  const ProgramText program = text_of("G00 X1\n");
  const TextBlock& block = program.blocks[0];
  // 1 / 25.4 = 0.03937007874015748...
  EXPECT_EQ(with_value(*block.find("X"), Number(5) / 127), "X0.039370078740157");
}

}  // namespace
}  // namespace gonogo::program
