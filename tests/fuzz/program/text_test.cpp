// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/text.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "grammar/line_source.hpp"

namespace gonogo::program {
namespace {

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  for (const TextLine& cut : lines_of(line)) {
    for (const TextWord& word : cut.words) words.push_back(word.text);
  }
  return words;
}

using Words = std::vector<std::string>;

// Texts of the bytes that programs consist of.
rc::Gen<std::string> programs() {
  return rc::gen::container<std::string>(
      rc::gen::elementOf(std::string("GMXZR019.-+=(); \t\r\n%/\xE5")));
}

RC_GTEST_PROP(ProgramText, IsPutTogetherAsItWas, ()) {
  const std::string text = *programs();
  RC_ASSERT(text_of(lines_of(text)) == text);
}

RC_GTEST_PROP(ProgramText, HasTheLinesOfTheGrammar, ()) {
  const std::string text = *programs();
  grammar::MemorySource bytes(text);
  grammar::LineSource source(bytes);
  std::size_t lines = 0;
  for (grammar::Line line; source.next(line);) ++lines;
  RC_ASSERT(lines_of(text).size() == lines);
}

TEST(ProgramText, WordsEndWhereTheNextLetterBegins) {
  EXPECT_EQ(words_of("N10G01X-5.5 F200"), (Words{"N10", "G01", "X-5.5", "F200"}));
}

// NGC-COM-04; in the other dialects no number follows another.
TEST(ProgramText, BlanksMayPartTheDigitsOfANumber) {
  EXPECT_EQ(words_of("G 3  3.1M3X5\t.1 Y - 0 . 5 (7) 8"),
            (Words{"G 3  3.1", "M3", "X5\t.1", "Y - 0 . 5", "(7)", "8"}));
  EXPECT_EQ(code_of({"", "G 3  3.1"}), "G33.1");
  EXPECT_EQ(value_of({"", "X - 1 2 . 5 0"}), (SmallDecimal{-1250, 2}));
}

TEST(ProgramText, ExpressionsAndCallsAreOneWord) {
  EXPECT_EQ(words_of("R101=R1+SIN(R2) X=AC(3)Y2"), (Words{"R101=R1+SIN(R2)", "X=AC(3)", "Y2"}));
}

TEST(ProgramText, CommentsAreOneWord) {
  EXPECT_EQ(words_of("G1(X1 Z2)F3;and so on"), (Words{"G1", "(X1 Z2)", "F3", ";and so on"}));
}

TEST(ProgramText, BlankLinesAreNoBlocks) {
  EXPECT_EQ(count_blocks("G0 X1\n\n \nM30"), 2U);
}

TEST(ProgramText, CodesLoseTheirZeros) {
  EXPECT_EQ(code_of({"", "g01"}), "G1");
  EXPECT_EQ(code_of({"", "G00"}), "G0");
  EXPECT_EQ(code_of({"", "G90.1"}), "G90.1");
  EXPECT_EQ(code_of({"", "LCYC75"}), "LCYC75");
  EXPECT_EQ(code_of({"", "X10"}), "");
}

TEST(ProgramText, NumbersKeepSignAndScale) {
  EXPECT_EQ(value_of({"", "X-12.50"}), (SmallDecimal{-1250, 2}));
  EXPECT_EQ((SmallDecimal{-1250, 2}).text(), "-12.5");
  EXPECT_EQ((SmallDecimal{5, 3}).text(), "0.005");
}

TEST(ProgramText, TheIndexOfAnAssignmentIsNoValue) {
  const std::vector<NumberPlace> places = numbers_of({"", "R101=-7"});
  ASSERT_EQ(places.size(), 1U);
  EXPECT_EQ(places[0].number, (SmallDecimal{-7, 0}));
}

TEST(ProgramText, ASignAfterADigitIsAnOperator) {
  const std::vector<NumberPlace> places = numbers_of({"", "X=5-3"});
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[1].number, (SmallDecimal{3, 0}));
}

TEST(ProgramText, NumbersTooLongAreLeftAlone) {
  EXPECT_TRUE(numbers_of({"", "X" + std::string(40, '7')}).empty());
}

}  // namespace
}  // namespace gonogo::program
