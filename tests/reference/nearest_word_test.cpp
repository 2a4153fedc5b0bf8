// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/nearest_word.hpp"

#include <gtest/gtest.h>

namespace gonogo::reference {
namespace {

const std::vector<std::string> kKnown = {"gsk988ta", "hnc21t", "rs274", "g94", "g92", "taper-sign"};

TEST(NearestWord, OneLetterIsWrongMissingOrTooMany) {
  EXPECT_EQ(nearest_word("taper-sing", kKnown), "taper-sign");
  EXPECT_EQ(nearest_word("rs27", kKnown), "rs274");
  EXPECT_EQ(nearest_word("hnc221t", kKnown), "hnc21t");
}

TEST(NearestWord, TwoLettersHaveChangedPlaces) {
  EXPECT_EQ(nearest_word("g49", kKnown), "g94");
}

TEST(NearestWord, TheBeginningOfANameStandsForIt) {
  EXPECT_EQ(nearest_word("GSK", kKnown), "gsk988ta");
  EXPECT_EQ(nearest_word("h", kKnown), "");
}

TEST(NearestWord, NothingIsNear) {
  EXPECT_EQ(nearest_word("certify", kKnown), "");
  EXPECT_EQ(nearest_word(std::string(1'000, 'g'), kKnown), "");
}

TEST(NearestWord, TheSameWordInOtherLettersIsNearest) {
  EXPECT_EQ(nearest_word("G94", {"g74", "g94", "g940"}), "g94");
}

}  // namespace
}  // namespace gonogo::reference
