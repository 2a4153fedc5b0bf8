// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/program/mutator/dictionary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "grammar/parser.hpp"
#include "fuzz/program/text.hpp"
#include "reference/dialect.hpp"

namespace gonogo::program {
namespace {

std::vector<std::string> entries(std::string_view text) {
  return std::get<std::vector<std::string>>(read_dictionary(text));
}

std::size_t first_fault(std::string_view text) {
  return std::get<std::size_t>(read_dictionary(text));
}

TEST(Dictionary, ReadsEntriesCommentsAndEscapes) {
  EXPECT_EQ(entries("# codes\n\n\"G94\"\n\"MSG(\\\"a\\\")\"\n\"\\xE5\\\\\"\n"),
            (std::vector<std::string>{"G94", "MSG(\"a\")", "\xE5\\"}));
  EXPECT_TRUE(entries("").empty());
}

TEST(Dictionary, NamesTheLineThatIsNone) {
  for (const char* line :
       {"G94", "\"G94", "\"\"", "\"a\"b\"", "\"\\n\"", "\"\\xZZ\"", "\"\\x4\"", "\"ends in \\\""}) {
    EXPECT_EQ(first_fault("\"G0\"\n" + std::string(line) + "\n\"G1\"\n"), 2U) << line;
  }
  EXPECT_EQ(first_fault("\"" + std::string(kLongestEntry + 1, 'X') + "\""), 1U);
}

TEST(Dictionary, OneIsThereForEachDialect) {
  for (const reference::Dialect& dialect : reference::dialects()) {
    EXPECT_NE(find_dictionary(dialect.name), nullptr) << dialect.name;
  }
  EXPECT_EQ(dictionaries().size(), reference::dialects().size());
  EXPECT_EQ(find_dictionary("acme"), nullptr);
}

TEST(Dictionary, HasNoEntryTwice) {
  for (const Dictionary& dictionary : dictionaries()) {
    std::set<std::string> seen;
    for (const std::string& entry : dictionary.entries) {
      EXPECT_TRUE(seen.insert(entry).second) << dictionary.dialect << ": " << entry;
    }
  }
}

TEST(Dictionary, HasEveryCodeAndWordOfTheTable) {
  for (const reference::Dialect& dialect : reference::dialects()) {
    const std::vector<std::string>& all = find_dictionary(dialect.name)->entries;
    for (const reference::Code& code : dialect.descriptor->codes) {
      if (code.name.find('<') != std::string_view::npos) continue;
      EXPECT_NE(std::ranges::find(all, code.name), all.end()) << dialect.name << code.name;
      for (const auto& list : code.words) {
        for (const reference::CodeWord& word : list) {
          if (word.address.find(' ') != std::string_view::npos) continue;
          EXPECT_TRUE(std::ranges::any_of(all,
                                          [&](const std::string& entry) {
                                            return program::name_of({"", entry}) == word.address;
                                          }))
              << dialect.name << code.name << word.address;
        }
      }
    }
  }
}

// As the engines read it; for a target that reads every dialect all of them in one.
TEST(Dictionary, IsWrittenAsItIsRead) {
  for (const reference::Dialect& dialect : reference::dialects()) {
    std::vector<std::string> all = find_dictionary(dialect.name)->entries;
    std::vector<std::string> written = entries(dictionary_text(dialect.name));
    std::ranges::sort(all);
    std::ranges::sort(written);
    EXPECT_EQ(written, all);
  }
  EXPECT_GT(entries(dictionary_text("any")).size(), find_dictionary("rs274")->entries.size());
}

// What begins with G is a code or a block that the grammar reads.
TEST(Dictionary, HasBlocksThatParse) {
  for (const reference::Dialect& dialect : reference::dialects()) {
    std::size_t blocks = 0;
    for (const std::string& entry : find_dictionary(dialect.name)->entries) {
      if (!entry.starts_with("G") || entry.starts_with("GOTO")) continue;
      grammar::Block block;
      EXPECT_FALSE(grammar::parse_block(dialect.grammar, entry, block))
          << dialect.name << ": " << entry;
      blocks += program::lines_of(entry).front().words.size() > 1 ? 1U : 0U;
    }
    EXPECT_GE(blocks, 8U) << dialect.name;
  }
}

}  // namespace
}  // namespace gonogo::program
