// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every word beside every code that the gauge reads is used, ignored by a rule that is listed,
// refused under a clause, or not covered by its name: none is dropped in silence. And the table of
// the dialect says which.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "word_bench.hpp"

namespace gonogo::reference::testing {
namespace {

std::string without_equals(const std::string& address) {
  return address.back() == '=' ? address.substr(0, address.size() - 1) : address;
}

// Whether the words of a rule hold the address: "K R E", "I J K", "H<n>=".
bool names(std::string_view words, const std::string& address) {
  std::istringstream in{std::string(words)};
  for (std::string word; in >> word;) {
    if (word == address || (word == "H<n>=" && address == "H3=")) return true;
  }
  return false;
}

bool is_ignored(const Dialect& dialect, const Code& code, const std::string& address) {
  // A code without effect takes its words with it.
  if (code.treatment == Treatment::without_effect && code.find(address) != nullptr) return true;
  const auto holds = [&](const IgnoredWords& rule) { return names(rule.words, address); };
  return std::ranges::any_of(dialect.descriptor->passed_everywhere, holds) ||
         std::ranges::any_of(code.passed, holds);
}

// The word with one value beside the code: what became of it, where that is not allowed.
std::string dropped(const Dialect& dialect, const Profile& profile, Bench bench, const Code& code,
                    const std::string& address, const std::string& value) {
  if (bench.words.contains(address) && bench.words[address] == value) return "";
  const Said without = said_of(bench.program(code), profile);
  bench.words[address] = value;
  const std::string program = bench.program(code);
  const Said with = said_of(program, profile);
  if (with.alarm) {
    return with.alarm->clause == kNoClause ? "an alarm without a clause: " + program : "";
  }
  if (with.not_covered) {
    const std::string name = without_equals(address);
    const bool named = with.not_covered->code == name ||
                       with.not_covered->message.find("word " + name) != std::string::npos ||
                       with.not_covered->code.starts_with(name);
    return named ? "" : "not covered, but not by the name of the word: " + program;
  }
  if (!(with == without) || is_ignored(dialect, code, address)) return "";
  return fmt::format("{}{} is dropped in silence: {}", address, value, program);
}

TEST(WordUse, NoneIsDroppedInSilence) {
  for (const Dialect& dialect : dialects()) {
    const Profile profile = bench_profile(dialect);
    std::size_t tried = 0;
    for (const Code* code : codes_with_words(dialect)) {
      const Bench bench = bench_of(dialect, *code);
      for (const std::string& address : candidate_words(dialect)) {
        for (const char* value : kValues) {
          ++tried;
          EXPECT_EQ(dropped(dialect, profile, bench, *code, address, value), "") << dialect.name;
        }
      }
    }
    EXPECT_GT(tried, 20U * 23 * 3) << dialect.name;
  }
}

// The fates of a word beside a code, over planes and with the other words of the code or without.
std::vector<Fate> fates_of(const Dialect& dialect, const Code& code, const std::string& address) {
  const Profile profile = bench_profile(dialect);
  std::vector<Fate> fates;
  for (const char* plane : {"", " G17", " G18", " G19"}) {
    if (*plane != '\0' && dialect.name == "hnc21t") continue;
    for (const bool alone : {false, true}) {
      Bench bench = bench_of(dialect, code);
      if (*plane != '\0') bench.before.replace(0, 3, plane + 1);
      if (alone) bench.words.clear();
      bench.words.erase(address);
      for (const char* value : kValues) {
        fates.push_back(fate_of(profile, bench, code, address, value));
      }
    }
  }
  return fates;
}

// The row of a code and the rows beside it that take words of the block, too.
bool takes(const Dialect& dialect, const Code& code, const std::string& address) {
  if (code.find(address) != nullptr) return true;
  const bool is_sinumerik = dialect.name.starts_with("sinumerik");
  // A mode stands beside the motion in force; in RS274 a dwell, too.
  const Code& in_force = *dialect.descriptor->find(is_sinumerik ? "G1" : "G0");
  const bool goes_along = code.kind == Kind::mode || dialect.name == "rs274";
  if (goes_along && code.group != Group::motion && in_force.find(address) != nullptr) return true;
  const bool stands_alone = is_sinumerik && code.group == Group::once && code.kind != Kind::mode;
  return !stands_alone && dialect.descriptor->find_word(nullptr, address) != nullptr;
}

TEST(WordUse, TheTableTellsUsedWordsFromOthers) {
  for (const Dialect& dialect : dialects()) {
    for (const Code* code : codes_with_words(dialect)) {
      for (const std::string& address : candidate_words(dialect)) {
        const std::vector<Fate> fates = fates_of(dialect, *code, address);
        const auto count = [&](Fate fate) { return std::ranges::count(fates, fate); };
        const std::string what = fmt::format("{} {} {}", dialect.name, code->name, address);
        if (takes(dialect, *code, without_equals(address))) {
          EXPECT_LT(count(Fate::refused), std::ssize(fates)) << what << " is never used";
        } else {
          EXPECT_EQ(count(Fate::used), 0) << what << " is used, and not described";
          if (!is_ignored(dialect, *code, address)) {
            EXPECT_EQ(count(Fate::idle), 0) << what;
          }
        }
      }
    }
  }
}

// The lists are not empty, say why, and stand on clauses of their own dialect.
TEST(WordUse, EveryRuleSaysWhyAndUnderWhichClause) {
  for (const Dialect& dialect : dialects()) {
    for (const PassedWords& rule : passed_words(*dialect.descriptor)) {
      EXPECT_FALSE(rule.codes.empty() || rule.words.empty() || rule.why.empty()) << dialect.name;
      const std::string_view id = clause_name(rule.clause);
      EXPECT_EQ(id.substr(0, 3), clause_name(dialect.syntax_clause).substr(0, 3)) << id;
    }
  }
}

}  // namespace
}  // namespace gonogo::reference::testing
