// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/mutator/dictionary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "fuzz/hunt/program_text.hpp"
#include "grammar/parser.hpp"
#include "reference/dialect.hpp"

namespace gonogo::fuzz {
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

// Families stand there by one of theirs: letters with a number, CYCLE<n>, G505 to G599.
bool is_of_family(std::string_view code) {
  return code.find('<') != std::string_view::npos ||
         (code.starts_with("G5") && code.size() == 4 && code != "G500");
}

TEST(Dictionary, HasEveryCodeOfTheCatalog) {
  for (const reference::Dialect& dialect : reference::dialects()) {
    std::vector<std::string> codes;
    for (const auto& outside : reference::outside_codes(*dialect.descriptor)) codes.emplace_back(outside.code);
    for (const std::string& code : reference::codes_without_effect(*dialect.descriptor)) codes.emplace_back(code);
    for (const std::string& code : codes) {
      if (is_of_family(code)) continue;
      const std::string wanted = code_of({"", code});
      const bool has = std::ranges::any_of(
          find_dictionary(dialect.name)->entries, [&](const std::string& entry) {
            return code.size() == 1 ? entry.starts_with(code) : code_of({"", entry}) == wanted;
          });
      EXPECT_TRUE(has) << dialect.name << ": " << code;
    }
  }
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
      blocks += lines_of(entry).front().words.size() > 1 ? 1U : 0U;
    }
    EXPECT_GE(blocks, 8U) << dialect.name;
  }
}

}  // namespace
}  // namespace gonogo::fuzz
