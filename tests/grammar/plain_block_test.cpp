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

std::string any_number(Trials& trials) {
  std::string text = trials.once_in(3) ? "-" : trials.once_in(9) ? "+" : "";
  for (std::size_t i = trials.below(4); i > 0; --i) {
    text += static_cast<char>('0' + trials.below(10));
  }
  if (trials.once_in(2)) text += '.';
  for (std::size_t i = trials.below(4); i > 0; --i) {
    text += static_cast<char>('0' + trials.below(10));
  }
  return text;
}

// A line as programs have them.
std::string usual_line(Trials& trials) {
  std::string text = trials.once_in(3) ? "N" + std::to_string(trials.below(10000)) : "";
  for (std::size_t i = trials.below(6); i > 0; --i) {
    if (!trials.once_in(3)) text += ' ';
    if (trials.once_in(12)) {
      text += trials.one_of({"CR=", "AR = ", "RP=", "(a)", "X=", "TURN="});
    } else {
      text += trials.one_of(kLetters);
    }
    if (trials.once_in(12)) text += ' ';
    text += any_number(trials);
  }
  if (trials.once_in(4)) text += trials.once_in(2) ? ";" : " ; done";
  return text;
}

// Some of its bytes changed, taken out or put in.
void mutate(std::string& text, Trials& trials) {
  for (std::size_t i = trials.below(3); i > 0; --i) {
    const std::size_t at = trials.below(text.size() + 1);
    const std::string piece(trials.one_of(kPieces));
    const std::size_t removed = trials.once_in(2) ? trials.below(3) : 0;
    text.replace(at, std::min(removed, text.size() - at), piece);
  }
}

std::string any_text(Trials& trials) {
  std::string text;
  if (trials.once_in(3)) {
    for (std::size_t i = trials.below(9); i > 0; --i) text += trials.one_of(kPieces);
    return text;
  }
  text = usual_line(trials);
  mutate(text, trials);
  return text;
}

TEST(PlainBlock, ReadsEveryTextAsTheGrammarsDo) {
  Trials trials(20'000);
  long plain = 0;
  Block block;
  for (long i = 0; i < trials.count; ++i) {
    const std::string text = any_text(trials);
    for (const Dialect dialect : kDialects) {
      ASSERT_NO_FATAL_FAILURE(expect_both_read_alike(dialect, text));
      block.clear();
      if (read_plain_block(dialect, text, block)) {
        ++plain;
      } else {
        ASSERT_EQ(block, Block()) << text;
      }
    }
  }
  // Both ways are taken, else there would be nothing to compare.
  EXPECT_GT(plain, trials.count / 2);
  EXPECT_LT(plain, 3 * trials.count);
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
