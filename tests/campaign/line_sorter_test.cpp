// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/line_sorter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "campaign_testing.hpp"

namespace gonogo::oracle {
namespace {

std::vector<std::string> sorted(const std::vector<std::string>& lines, std::size_t run_bytes) {
  const Scratch scratch;
  LineSorter sorter(scratch.path("."), run_bytes);
  for (const std::string& line : lines) sorter.add(line);
  std::vector<std::string> all;
  sorter.for_each([&](const std::string&, const std::string& line) { all.push_back(line); });
  return all;
}

// 3,000 lines of some 30 bytes in runs of 100 bytes: runs of three levels.
TEST(LineSorter, ManyRunsComeBackInTheOrderOfTheIds) {
  std::vector<std::string> lines;
  for (int i = 0; i < 3'000; ++i) {
    lines.push_back("{\"id\":\"t." + std::to_string(100'000 + i) + "\",\"n\":1}");
  }
  std::vector<std::string> shuffled = lines;
  std::ranges::shuffle(shuffled, std::mt19937(1));
  EXPECT_EQ(sorted(shuffled, 100), lines);
  EXPECT_EQ(sorted(shuffled, std::size_t{1} << 20), lines);
}

TEST(LineSorter, ComparesIdsAndNotTheirEscapes) {
  // "a!" stands before "a\"" (0x21, 0x22); as bytes of JSON the backslash would stand behind "a#".
  const std::vector<std::string> lines = {R"({"id":"a!"})", R"({"id":"a\""})", R"({"id":"a#"})"};
  EXPECT_EQ(sorted({lines[2], lines[1], lines[0]}, 1), lines);
}

TEST(LineSorter, AFolderThatCannotBeWrittenIsTold) {
  LineSorter sorter("/nowhere", 1);
  EXPECT_THROW(sorter.add("{\"id\":\"a\"}"), ResultsUnwritable);
}

TEST(StoredLines, AreThoseOfTheFileFromItsBeginning) {
  const FileHandle file(std::tmpfile());
  std::fputs("first\n\nlast\n", file.get());
  StoredLines lines(file.get(), "The file");
  std::vector<std::string> all;
  for (std::string line; lines.next(line);) all.push_back(line);
  EXPECT_EQ(all, (std::vector<std::string>{"first", "", "last"}));
}

// Else the results would end there, with a footer that says that they are whole.
TEST(StoredLines, WhatCannotBeReadIsNoEnd) {
  const Scratch scratch;
  const FileHandle file(std::fopen(scratch.path("lines").c_str(), "we"));  // not to be read
  StoredLines lines(file.get(), "The file");
  std::string line;
  EXPECT_THROW(lines.next(line), ResultsUnwritable);
}

}  // namespace
}  // namespace gonogo::oracle
