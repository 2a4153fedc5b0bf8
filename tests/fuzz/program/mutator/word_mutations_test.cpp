// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/mutator/word_mutations.hpp"

#include <gtest/gtest.h>

#include <set>

namespace gonogo::program {
namespace {

// Everything that one change makes of a program, over many seeds.
template <typename Change>
std::set<std::string> results(const std::string& program, Change change) {
  std::set<std::string> texts;
  for (std::uint64_t seed = 0; seed < 4'000; ++seed) {
    Dice dice(seed);
    std::vector<program::TextLine> lines = program::lines_of(program);
    change(dice, lines);
    texts.insert(text_of(lines));
  }
  return texts;
}

void expect_all(const std::set<std::string>& texts, std::initializer_list<const char*> wanted) {
  for (const char* text : wanted) EXPECT_TRUE(texts.contains(text)) << text;
}

TEST(WordMutations, SpellNumbersInOtherWays) {
  expect_all(results("X-2.5\n", change_spelling),
             {"X-2.6\n", "X-7.5\n", "X2.5\n", "X+2.5\n", "X-25\n", "X-.25\n", "X-25.\n", "X-02.5\n",
              "X-2.50\n", "X-2.5000\n", "X-2.50001\n"});
  expect_all(results("X5\n", change_spelling), {"X-5\n", "X+5\n", "X.5\n", "X5.\n", "X5.0005\n"});
}

TEST(WordMutations, LeaveWordsWithoutNumbersAlone) {
  EXPECT_EQ(results("(note 5)\n", change_spelling), std::set<std::string>{"(note 5)\n"});
  EXPECT_EQ(results("", change_spelling), std::set<std::string>{""});
}

constexpr auto kEntries = std::to_array<std::string_view>({"G94", "X7", "M30"});
const std::vector<std::string> kWords(kEntries.begin(), kEntries.end());

TEST(WordMutations, PutEntriesIntoABlock) {
  expect_all(
      results("G0 X5\nZ1", [](Dice& dice, auto& lines) { insert_entry(dice, lines, kWords); }),
      {"G0 X5\nZ1 M30", "G0 X5 X7\nZ1", "G0 G94 X5\nZ1", "G0M30 X5\nZ1"});
}

TEST(WordMutations, PutEntriesInPlacesOfWords) {
  expect_all(
      results("G0 X5", [](Dice& dice, auto& lines) { replace_by_entry(dice, lines, kWords); }),
      {"G94 X5", "G0 X7", "G0 M30", "M30 X5"});
}

TEST(WordMutations, PutEntriesAsBlocks) {
  const auto change = [](Dice& dice, auto& lines) { insert_block(dice, lines, kWords); };
  EXPECT_EQ(results("", change), (std::set<std::string>{"G94\n", "X7\n", "M30\n"}));
  expect_all(results("G0\nX5", change), {"G94\nG0\nX5\n", "G0\nM30\nX5\n", "G0\nX5\nX7\n"});
}

TEST(WordMutations, ChangeWhatGrammarsReadOver) {
  expect_all(results("g0 X5\nZ1\n", change_looks),
             {"G0 X5\nZ1\n", "g0X5\nZ1\n", "g0 x5\nZ1\n", "g0 X5\r\nZ1\n", "g0 X5\rZ1\n",
              "g0 X5 \nZ1\n", "g0 X5;\nZ1\n"});
}

TEST(WordMutations, DoNothingWithoutEntries) {
  const std::vector<std::string> none;
  Dice dice(1);
  std::vector<program::TextLine> lines = program::lines_of("G0 X5\n");
  insert_entry(dice, lines, none);
  replace_by_entry(dice, lines, none);
  insert_block(dice, lines, none);
  EXPECT_EQ(text_of(lines), "G0 X5\n");
}

}  // namespace
}  // namespace gonogo::program
