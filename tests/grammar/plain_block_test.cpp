// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filter for plain blocks gives what the grammars give, and gives way to them where it does not
// know better. GONOGO_TRIALS says how many texts are tried.
#include "grammar/plain_block.hpp"

#include <gtest/gtest.h>

#include "tests/grammar/both_readings.hpp"
#include "tests/trials.hpp"

namespace gonogo::grammar {
namespace {

// What blocks are made of, plain and not; the seams between them are where a filter goes wrong.
// clang-format off
constexpr std::string_view kPieces[] = {
    "X", "Y", "Z", "G", "M", "F", "N", "O", "R", "L", "E", "EX", "x", "g", "n", "r", "e", "ex", "P",
    "I", "1", "0", "12", "007", ".5", "5.", ".", "0.00", "-1", "+2", "--3", "- ", "+", "-", "1.25",
    "123456789", "1234567890123456789", "000000000000000000001", "0.0000000000000000001",
    " ", "\t", "  ", ";", "; a", "(", ")", "(a)", "()", "/", "%", ":", "=", "=AC(", "#1", "[", "]",
    "$A", "_", "\"", "\x01", "\x7F", "\xC3\xA9", "\xB0\xA1", "'", "CR=5", "CR = -5", "cr=.5", "AP=",
    "AR=30.5", "RP=", "TURN=2", "DIV", "OR", "IF", "GOTO", "SIN", "ABS", "R1=2", "X1=3", "X=",
    "MSG(\"a\")", "RPL45", "END", "P[T1]"};
// clang-format on
constexpr std::string_view kLetters = "XYZACUVWIJKRGMFSTDHPQLENOBxgn";

std::string any_number(Chance& chance) {
  std::string text = chance.once_in(3) ? "-" : chance.once_in(9) ? "+" : "";
  for (std::size_t i = chance.below(4); i > 0; --i) {
    text += static_cast<char>('0' + chance.below(10));
  }
  if (chance.once_in(2)) text += '.';
  for (std::size_t i = chance.below(4); i > 0; --i) {
    text += static_cast<char>('0' + chance.below(10));
  }
  return text;
}

// A line as programs have them.
std::string usual_line(Chance& chance) {
  std::string text = chance.once_in(3) ? "N" + std::to_string(chance.below(10000)) : "";
  for (std::size_t i = chance.below(6); i > 0; --i) {
    if (!chance.once_in(3)) text += ' ';
    if (chance.once_in(12)) {
      text += chance.one_of({"CR=", "AR = ", "RP=", "(a)", "X=", "TURN="});
    } else {
      text += chance.one_of(kLetters);
    }
    if (chance.once_in(12)) text += ' ';
    text += any_number(chance);
  }
  if (chance.once_in(4)) text += chance.once_in(2) ? ";" : " ; done";
  return text;
}

// Some of its bytes changed, taken out or put in.
void mutate(std::string& text, Chance& chance) {
  for (std::size_t i = chance.below(3); i > 0; --i) {
    const std::size_t at = chance.below(text.size() + 1);
    const std::string piece(chance.one_of(kPieces));
    const std::size_t removed = chance.once_in(2) ? chance.below(3) : 0;
    text.replace(at, std::min(removed, text.size() - at), piece);
  }
}

std::string any_text(Chance& chance) {
  std::string text;
  if (chance.once_in(3)) {
    for (std::size_t i = chance.below(9); i > 0; --i) text += chance.one_of(kPieces);
    return text;
  }
  text = usual_line(chance);
  mutate(text, chance);
  return text;
}

TEST(PlainBlock, ReadsEveryTextAsTheGrammarsDo) {
  constexpr long kTrials = 20'000;
  long plain = 0;
  Block block;
  each_trial(kTrials, [&](Chance& chance) {
    const std::string text = any_text(chance);
    for (const Dialect dialect : kDialects) {
      ASSERT_NO_FATAL_FAILURE(expect_both_read_alike(dialect, text));
      block.clear();
      if (read_plain_block(dialect, text, block)) {
        ++plain;
      } else {
        ASSERT_EQ(block, Block()) << text;
      }
    }
  });
  // Both ways are taken, else there would be nothing to compare.
  EXPECT_GT(plain, trial_count(kTrials) / 2);
  EXPECT_LT(plain, 3 * trial_count(kTrials));
}

TEST(PlainBlock, TakesTheBlocksThatProgramsConsistOf) {
  for (const Dialect dialect : kDialects) {
    Block block;
    EXPECT_TRUE(read_plain_block(dialect, "N10 G01 X12.345 Z-6.789 F200", block));
    EXPECT_EQ(block.words.size() + block.named.size(), 4U);
    EXPECT_EQ(block.sequence_number->magnitude, 10U);
  }
}

}  // namespace
}  // namespace gonogo::grammar
