// SPDX-License-Identifier: GPL-3.0-or-later
//
// The predicates of the reference, found from outside: values from the clauses.
#include "fuzz/generate/cover/boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace gonogo::cover {
namespace {

reference::Profile profile_of(std::string_view dialect) {
  return std::get<reference::Profile>(reference::default_profile(dialect));
}

// The triples of the word with this address.
std::vector<Triple> triples_of(std::string_view dialect, const std::string& program,
                               std::string_view address) {
  for (const VariedWord& word : varied_words(program, 2, 99)) {
    if (word.address == address) return boundary_triples(profile_of(dialect), program, word, 3);
  }
  return {};
}

bool has(const std::vector<Triple>& triples, std::string_view clause,
         const std::array<std::string, 3>& words) {
  return std::ranges::any_of(triples, [&](const Triple& triple) {
    if (triple.clause != clause) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      if (triple.programs[i].find(words[i] + " ") == std::string::npos) return false;
    }
    return true;
  });
}

TEST(VariedWords, AreTheNumbersOfAddressesThatMeasure) {
  const std::string program = "G0 X1\nG94 X-60.5 R9 F100 M8 R101=4 CR=-2 X=IC(3)\n";
  std::vector<std::string> words;
  for (const VariedWord& word : varied_words(program, 2, 2)) {
    words.push_back(word.address + "|" + program.substr(word.begin, word.length));
  }
  EXPECT_EQ(words, (std::vector<std::string>{"X|-60.5", "R|9", "F|100", "R101=|4", "CR=|-2"}));
}

// GSK-G90-09: the travel along X is -20, so R of the other sign may be up to 20.
TEST(Boundary, FindsTheLimitOfATaper) {
  EXPECT_TRUE(has(triples_of("gsk988ta", "G18 G00 X100 Z50\nG90 X60 W-10 R5 F100\n", "R"),
                  "GSK-G90-09", {"R19.999", "R20", "R20.001"}));
}

// GSK-G110-03: I = 5 alarms, 5.001 does not.
TEST(Boundary, FindsWhereAnEqualValueAlarms) {
  EXPECT_TRUE(
      has(triples_of("gsk988ta", "G17 G00 X0 Y0 Z0\nG110 X0 Y0 Z-4 I20 L4 Q4 D5 F100\n", "I"),
          "GSK-G110-03", {"I4.999", "I5", "I5.001"}));
}

// HNC-G74-02: 12 deep by 4 is three pecks exactly; by 3.999 it takes a fourth.
TEST(Boundary, FindsWhereAnotherPeckBegins) {
  EXPECT_TRUE(has(triples_of("hnc21t", "G00 X0 Z0\nG74 Z-12 R1 Q8 F100\n", "Q"), "HNC-G74-02",
                  {"Q11.999", "Q12", "Q12.001"}));
}

TEST(Boundary, AWordWithoutALimitGivesNone) {
  EXPECT_TRUE(triples_of("rs274", "G0 X1\nG0 X5 Y7\n", "Y").empty());
}

}  // namespace
}  // namespace gonogo::cover
