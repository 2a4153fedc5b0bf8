// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/selection.hpp"

#include <fnmatch.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace gonogo::checker {
namespace {

TEST(CheckerGlob, TakesWhatPeopleWriteForIds) {
  EXPECT_TRUE(matches_glob("ngc.arc-r.00000[1-3]", "ngc.arc-r.000002"));
  EXPECT_FALSE(matches_glob("ngc.arc-r.00000[1-3]", "ngc.arc-r.000004"));
  EXPECT_TRUE(matches_glob("ngc.arc-r.00000[!1-3]", "ngc.arc-r.000004"));
  EXPECT_FALSE(matches_glob("ngc.arc-r.00000[!1-3]", "ngc.arc-r.000002"));
  EXPECT_TRUE(matches_glob("ngc.*.??000[ab1]", "ngc.basic.000001"));
  EXPECT_TRUE(matches_glob("ngc\\.b*", "ngc.basic.000001"));
  EXPECT_FALSE(matches_glob("ngc.\\*", "ngc.basic.000001"));
  EXPECT_TRUE(matches_glob("ngc.\\*", "ngc.*"));
}

// The gauge selects by fnmatch, and the two must take the same cases: all globs of up to five of
// these letters, on all texts of up to two.
TEST(CheckerGlob, IsThatOfTheSystem) {
  constexpr std::string_view kOfGlob = "a1[]!-\\*?";
  constexpr std::string_view kOfText = "a1-]!";
  std::vector<std::string> texts = {""};
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (texts[i].size() == 2) break;
    for (const char c : kOfText) texts.push_back(texts[i] + c);
  }
  std::vector<std::string> globs = {""};
  for (std::size_t i = 0; i < globs.size(); ++i) {
    for (const std::string& text : texts) {
      ASSERT_EQ(matches_glob(globs[i], text), ::fnmatch(globs[i].c_str(), text.c_str(), 0) == 0)
          << globs[i] << " on " << text;
    }
    if (globs[i].size() == 5) continue;
    for (const char c : kOfGlob) globs.push_back(globs[i] + c);
  }
}

}  // namespace
}  // namespace gonogo::checker
