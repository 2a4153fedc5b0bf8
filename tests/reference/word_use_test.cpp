// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every word beside every code that the gauge reads is used, passed over by a rule that is listed,
// refused under a clause, or not covered by its name: none is dropped in silence.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "grammar/line_source.hpp"
#include "reference/dialect.hpp"

namespace gonogo::reference::testing {
namespace {

// What the reference says of a program: its records as text, and how it ends.
struct Said {
  std::string records;
  std::optional<Alarm> alarm;
  std::optional<NotCovered> not_covered;

  std::string ending() const {
    if (alarm) return fmt::format("alarm {}", name(alarm->alarm));
    return not_covered ? "not covered: " + not_covered->code : "end";
  }
};

Said said_of(const std::string& program, const Profile& profile) {
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  Expander expander(profile, lines, OpenPaths::shown);
  Said said;
  while (const Item* item = expander.next()) {
    if (auto* record = std::get_if<Record>(item)) {
      append_json(*record, said.records);
    } else if (auto* renaming = std::get_if<Renaming>(item)) {
      for (const Axis axis : kAllAxes) said.records += renaming->shift[axis].text() + " ";
    } else if (auto* report = std::get_if<AlarmReport>(item)) {
      said.alarm = report->alarms.front();
    } else if (auto* outside = std::get_if<NotCovered>(item)) {
      said.not_covered = *outside;
    }
  }
  return said;
}

// Whether the words of a rule hold the address: "K R E", "I J K", "H<n>=".
bool names(std::string_view words, const std::string& address) {
  std::istringstream in{std::string(words)};
  for (std::string word; in >> word;) {
    if (word == address || (word == "H<n>=" && address == "H3=")) return true;
  }
  return false;
}

bool is_passed_over(const Dialect& dialect, int code, const std::string& address) {
  const auto holds = [&](const PassedOver& rule) { return names(rule.words, address); };
  const Descriptor& known = *dialect.descriptor;
  return std::ranges::any_of(known.passed_everywhere, holds) ||
         std::ranges::any_of(known.find(fmt::format("G{}", code))->passed, holds);
}

// A block of one code: its words, and what stands before and behind it.
struct Bench {
  std::string before;
  std::map<std::string, std::string> words;  // by address
  std::string behind;                        // uses what the block leaves in force
};

std::string program_of(const Bench& bench, const std::string& code) {
  std::string block = code;
  for (const auto& [address, value] : bench.words) block += " " + address + value;
  return bench.before + "\n" + block + "\n" + bench.behind + "\n";
}

// The word with one value beside the code: what became of it, where that is not allowed.
std::string dropped(const Dialect& dialect, const Profile& profile, Bench bench, int code,
                    const std::string& name, const std::string& address, const std::string& value) {
  if (bench.words.contains(address) && bench.words[address] == value) return "";
  const Said without = said_of(program_of(bench, name), profile);
  bench.words[address] = value;
  const std::string program = program_of(bench, name);
  const Said with = said_of(program, profile);
  if (with.alarm) {
    return with.alarm->clause == kNoClause ? "an alarm without a clause: " + program : "";
  }
  if (with.not_covered) {
    const bool named = with.not_covered->code == address ||
                       with.not_covered->message.find("word " + address) != std::string::npos ||
                       with.not_covered->code.starts_with(address);
    return named ? "" : "not covered, but not by the name of the word: " + program;
  }
  const bool changes = with.records != without.records || with.ending() != without.ending();
  if (changes || is_passed_over(dialect, code, address)) return "";
  return fmt::format("{}{} is dropped in silence: {}", address, value, program);
}

// The whole G codes that the dialect reads.
std::set<int> codes_read(const Profile& profile) {
  std::set<int> codes;
  for (int code = 0; code < 260; ++code) {
    const Said said = said_of(fmt::format("G{}\n", code), profile);
    const bool undefined = said.alarm && said.alarm->alarm == AlarmClass::undefined_code;
    const bool outside = said.not_covered && said.not_covered->code == fmt::format("G{:02}", code);
    if (!undefined && !outside) codes.insert(code);
  }
  return codes;
}

Profile profile_of(std::string_view dialect) {
  return std::get<Profile>(default_profile(dialect));
}

const std::vector<std::string> kValues = {"2", "0.5", "30"};

TEST(WordUse, NoneIsDroppedInSilenceByTheHnc21t) {
  const Dialect& dialect = *find_dialect("hnc21t");
  Profile profile = profile_of("hnc21t");
  ASSERT_FALSE(set_reading(profile, "hnc.g75.mode3", "off"));
  const Bench plain{"G00 X50 Z5 F90", {{"X", "40"}, {"Z", "-5"}}, "X38 Z-6\nG01 X37 Z-7"};
  std::map<int, Bench> benches;
  const auto set = [&](int code, std::map<std::string, std::string> words,
                       const std::string& behind = "X38 Z-6\nG01 X37 Z-7") {
    benches[code] = {plain.before, std::move(words), behind};
  };
  set(2, {{"X", "40"}, {"Z", "-10"}, {"R", "20"}}, "G01 X37 Z-7");
  set(3, {{"X", "40"}, {"Z", "-10"}, {"R", "20"}}, "G01 X37 Z-7");
  set(4, {{"P", "100"}}, "G01 X37 Z-7");
  set(32, {{"X", "40"}, {"Z", "-5"}, {"F", "2"}});
  set(74, {{"Z", "-20"}, {"R", "1"}, {"Q", "3"}});
  set(75, {{"X", "20"}, {"Z", "0"}, {"R", "1"}, {"Q", "3"}, {"I", "3"}});
  set(80, {{"X", "40"}, {"Z", "-5"}});
  set(81, {{"X", "40"}, {"Z", "-5"}});
  set(82, {{"X", "40"}, {"Z", "-5"}, {"F", "2"}, {"P", "10"}});
  set(92, {{"X", "40"}, {"Z", "-5"}}, "G01 X37 Z-7");
  std::size_t tried = 0;
  for (const int code : codes_read(profile)) {
    const auto own = benches.find(code);
    const Bench& bench = own == benches.end() ? plain : own->second;
    for (const char letter : std::string_view("ABCDEFHIJKLMPQRSTUVWXYZ")) {
      for (const std::string& value : kValues) {
        ++tried;
        EXPECT_EQ(dropped(dialect, profile, bench, code, fmt::format("G{:02}", code),
                          std::string(1, letter), value),
                  "");
      }
    }
  }
  EXPECT_GT(tried, 30U * 23 * 3);
}

TEST(WordUse, NoneIsDroppedInSilenceByTheGsk988ta) {
  const Dialect& dialect = *find_dialect("gsk988ta");
  const Profile profile = profile_of("gsk988ta");
  const std::string before = "G18 G00 X50 Y9 Z5 F90";
  const Bench plain{before, {{"X", "40"}, {"Z", "-5"}}, "X38 Z-6\nG01 X37 Z-7 C1"};
  std::map<int, Bench> benches;
  const auto set = [&](int code, std::map<std::string, std::string> words,
                       const std::string& behind) {
    benches[code] = {before, std::move(words), behind};
  };
  const std::string cut = "G01 X37 Z-7";
  set(2, {{"X", "40"}, {"Z", "-10"}, {"R", "20"}}, cut);
  set(3, {{"X", "40"}, {"Z", "-10"}, {"K", "-10"}, {"I", "0"}}, cut);
  set(4, {{"P", "100"}}, cut);
  set(90, {{"X", "40"}, {"Z", "-5"}}, "X38\n" + cut);
  set(92, {{"X", "40"}, {"Z", "-5"}, {"F", "2"}, {"J", "0"}, {"K", "0"}}, "X38\n" + cut);
  set(94, {{"X", "40"}, {"Z", "-5"}}, "X38\n" + cut);
  const std::map<std::string, std::string> pocket = {{"X", "20"}, {"Z", "10"},  {"Y", "-9"},
                                                     {"I", "9"},  {"L", "1.5"}, {"Q", "4"},
                                                     {"D", "3"},  {"R", "-1"},  {"P", "1"}};
  const std::map<std::string, std::string> thread = {
      {"X", "20"}, {"Z", "10"}, {"Y", "-9"}, {"I", "2"}, {"E", "24"}, {"P", "1"},
      {"Q", "1"},  {"D", "3"},  {"R", "-1"}, {"J", "1"}, {"K", "45"}};
  for (const int code : {110, 111, 112, 113}) {
    set(code, pocket, "X1 Z1 Y-8\n" + cut);
    if (code >= 112) benches[code].words["L"] = "3";
  }
  for (const int code : {114, 115, 116, 117}) set(code, thread, cut);
  std::size_t tried = 0;
  for (const int code : codes_read(profile)) {
    const auto own = benches.find(code);
    const Bench& bench = own == benches.end() ? plain : own->second;
    for (const char letter : std::string_view("ABCDEFHIJKLMPQRSTUVWXYZ")) {
      for (const std::string& value : kValues) {
        ++tried;
        EXPECT_EQ(dropped(dialect, profile, bench, code, fmt::format("G{:02}", code),
                          std::string(1, letter), value),
                  "");
      }
    }
  }
  EXPECT_GT(tried, 30U * 23 * 3);
}

// Addresses, and names that a control of the family has.
const std::vector<std::string> kSinumerikWords = {
    "A",    "B",     "C",     "D",     "E",      "F",      "H",     "I",   "J",   "K",
    "M",    "O",     "P",     "Q",     "S",      "T",      "U",     "V",   "W",   "X",
    "Y",    "Z",     "L",     "I1=",   "J1=",    "K1=",    "CR=",   "AR=", "AP=", "RP=",
    "H3=",  "RPL=",  "TURN=", "CHF=",  "CHR=",   "RND=",   "L1=",   "E=",  "X1=", "M2=",
    "FRC=", "FRCM=", "ANG=",  "RNDM=", "SETAL=", "DEPTH=", "OFFN=", "F1="};

void expect_none_dropped(std::string_view name) {
  const Dialect& dialect = *find_dialect(name);
  const Profile profile = profile_of(name);
  const std::string before = "G17 G90 G1 X50 Y9 Z5 F90 S100 M3";
  const Bench plain{before, {{"X", "40"}, {"Y", "-5"}}, "G1 X38 Y-6 Z1 A1"};
  std::map<int, Bench> benches;
  benches[2] = {before, {{"X", "40"}, {"Y", "9"}, {"CR=", "20"}}, "G1 X38 Y-6"};
  benches[3] = {before, {{"X", "40"}, {"Y", "9"}, {"I", "-5"}, {"J", "0"}}, "G1 X38 Y-6"};
  benches[4] = {before, {{"F", "2"}}, "G1 X38 Y-6"};
  for (const int code : {110, 111, 112}) {
    benches[code] = {before, {{"X", "4"}, {"Y", "9"}}, "G1 AP=30 RP=10"};
  }
  for (const int code : {258, 259}) benches[code] = {before, {{"RPL=", "45"}}, "G1 X38 Y-6"};
  std::size_t tried = 0;
  for (const int code : codes_read(profile)) {
    const auto own = benches.find(code);
    const Bench& bench = own == benches.end() ? plain : own->second;
    for (const std::string& address : kSinumerikWords) {
      for (const std::string& value : kValues) {
        ++tried;
        const std::string said =
            dropped(dialect, profile, bench, code, fmt::format("G{}", code), address, value);
        // What is named is the address without its sign of equality.
        if (said.find("not by the name") != std::string::npos && address.back() == '=') {
          Bench changed = bench;
          changed.words[address] = value;
          const Said with = said_of(program_of(changed, fmt::format("G{}", code)), profile);
          EXPECT_EQ(with.not_covered->code + "=", address) << said;
          continue;
        }
        EXPECT_EQ(said, "");
      }
    }
  }
  EXPECT_GT(tried, 25U * kSinumerikWords.size() * 3);
}

TEST(WordUse, NoneIsDroppedInSilenceByTheSinumerik840d) {
  expect_none_dropped("sinumerik840d");
}

TEST(WordUse, NoneIsDroppedInSilenceByTheSinumerik802s) {
  expect_none_dropped("sinumerik802s");
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
