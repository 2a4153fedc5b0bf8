// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/mutator/mutate.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

namespace gonogo::program {
namespace {

constexpr const char* kProgram = "G00 X100 Z5\nG94 X50 Z-10 R-2.5 F100\n";
constexpr const char* kOther = "G21\nG110 X1 Y2 R5 I6 L1 Q1 D5\nM30\n";

RC_GTEST_PROP(Mutate, TheSameSeedMakesTheSameText, (std::uint64_t seed)) {
  Dice one(seed);
  Dice two(seed);
  RC_ASSERT(mutate_text(one, kProgram, kOther) == mutate_text(two, kProgram, kOther));
}

RC_GTEST_PROP(Mutate, BytesStayBounded, (std::uint64_t seed, std::vector<std::uint8_t> bytes)) {
  Dice dice(seed);
  RC_ASSERT(mutate_bytes(dice, std::move(bytes), std::vector<std::uint8_t>(4'000)).size() <=
            2'048U);
}

RC_GTEST_PROP(Mutate, AnyTextCanBeMutated, (std::uint64_t seed, const std::string& text)) {
  Dice dice(seed);
  mutate_text(dice, text, text);
  mutate_text(dice, text, "");
}

std::set<std::string> mutants() {
  std::set<std::string> texts;
  for (std::uint64_t seed = 0; seed < 40'000; ++seed) {
    Dice dice(seed);
    texts.insert(mutate_text(dice, kProgram, kOther));
  }
  return texts;
}

TEST(Mutate, MakesTheTextsThatOneStepCanMake) {
  const std::set<std::string> texts = mutants();
  for (const char* text : {
           "G94 X50 Z-10 R-2.5 F100\n",                    // a block less
           "G00 X100 Z5\nG94 X50 R-2.5 F100\n",            // a word less
           "G00 X100 Z5\nG94 X50 Z-10 R2.5 F100\n",        // a sign
           "G00 X100 Z5\nG94 X50 Z-10 R-10 F100\n",        // as another word
           "G00 X100 Z5\nG95 X50 Z-10 R-2.5 F100\n",       // a code beside it
           "G00 X100 Z5\nM30\nG94 X50 Z-10 R-2.5 F100\n",  // another's block
           "G00 X100 Z5\nG94 X50 Z-10 R-2.4 F100\n",       // one digit more
       }) {
    EXPECT_TRUE(texts.contains(text)) << text;
  }
}

}  // namespace
}  // namespace gonogo::program
