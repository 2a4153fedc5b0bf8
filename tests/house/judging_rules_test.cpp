// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules of docs/judging.md and what cites them: no citation without a rule, and no rule that no
// code carries or no test holds. And its constants, which stand in one table.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace gonogo {
namespace {

namespace fs = std::filesystem;

const fs::path kSources = GONOGO_SOURCE_DIR;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

const std::regex& rule_id() {
  static const std::regex kRule(R"(\bJ-(CMP|PATH|CYC|THR|PKT|ALM|READ|RUN|PROP|CONST)-[0-9]{2}\b)");
  return kRule;
}

std::multiset<std::string> ids_in(const std::string& text) {
  std::multiset<std::string> ids;
  if (text.find("J-") == std::string::npos) return ids;
  for (std::sregex_iterator it(text.begin(), text.end(), rule_id()), end; it != end; ++it) {
    ids.insert(it->str());
  }
  return ids;
}

// The ids that a folder's sources cite, each with a file that does.
std::map<std::string, std::string> cited_in(std::initializer_list<std::string_view> folders) {
  const std::set<std::string> kEndings = {".cpp", ".hpp", ".md", ".py", ".mjs", ""};
  std::map<std::string, std::string> cited;
  for (const std::string_view folder : folders) {
    for (auto it = fs::recursive_directory_iterator(kSources / folder);
         it != fs::recursive_directory_iterator(); ++it) {
      if (it->path().filename() == "node_modules") it.disable_recursion_pending();
      if (!it->is_regular_file() || !kEndings.contains(it->path().extension().string())) continue;
      for (const std::string& id : ids_in(text_of(it->path()))) {
        cited.emplace(id, fs::relative(it->path(), kSources).string());
      }
    }
  }
  return cited;
}

// A rule is what begins a paragraph: **J-PATH-09** ...
std::multiset<std::string> rules() {
  static const std::regex kBegin(R"((^|\n)\*\*(J-[A-Z]+-[0-9]{2})\*\* )");
  const std::string text = text_of(kSources / "docs" / "judging.md");
  std::multiset<std::string> ids;
  for (std::sregex_iterator it(text.begin(), text.end(), kBegin), end; it != end; ++it) {
    ids.insert((*it)[2]);
  }
  return ids;
}

const std::map<std::string, std::string>& code() {
  static const auto kCited =
      cited_in({"grammar", "reference", "oracle", "subjects", "corpus", "campaign", "capture",
                "publish", "fuzz", "cli", "expanders", "checker"});
  return kCited;
}

const std::map<std::string, std::string>& tests() {
  static const auto kCited = cited_in({"tests"});
  return kCited;
}

TEST(JudgingRules, AreWrittenOnce) {
  const auto written = rules();
  EXPECT_GT(written.size(), 20U);
  for (const std::string& id : written) EXPECT_EQ(written.count(id), 1U) << id;
}

TEST(JudgingRules, EveryOneThatIsCitedIsWritten) {
  const auto written = rules();
  for (const auto& cited : {code(), tests(), cited_in({"docs"})}) {
    for (const auto& [id, file] : cited) EXPECT_TRUE(written.contains(id)) << id << " in " << file;
  }
}

// What holds of the relation itself is in tests alone.
TEST(JudgingRules, EveryOneThatIsWrittenIsInCodeAndTests) {
  for (const std::string& id : rules()) {
    EXPECT_TRUE(code().contains(id) || id.starts_with("J-PROP-")) << id << " is in no source";
    EXPECT_TRUE(tests().contains(id)) << id << " is in no test";
  }
}

// A constant of oracle/region/constants.hpp as its row in the page: above it stand its unit, what
// it does and its rules, with bars between them.
std::vector<std::string> rows_of_constants() {
  static const std::regex kConstant(R"(inline constexpr \S+ (k\w+)(?:\[\])? = \{?([^;}]*)\}?;)");
  std::istringstream header(text_of(kSources / "oracle" / "region" / "constants.hpp"));
  std::vector<std::string> rows;
  std::string comment;
  for (std::string line; std::getline(header, line);) {
    std::smatch constant;
    if (line.starts_with("// ")) {
      comment += (comment.empty() ? "" : " ") + line.substr(3);
      continue;
    }
    if (std::regex_match(line, constant, kConstant)) {
      EXPECT_EQ(std::ranges::count(comment, '|'), 2) << line;
      const std::string value = std::regex_replace(constant.str(2), std::regex("'"), ",");
      rows.push_back("| `" + constant.str(1) + "` | " + value + " | " + comment + " |");
    }
    comment.clear();
  }
  return rows;
}

TEST(JudgingConstants, AreThoseOfThePage) {
  const std::string page = text_of(kSources / "docs" / "judging.md");
  const std::vector<std::string> rows = rows_of_constants();
  EXPECT_GT(rows.size(), 30U);
  std::string table;
  for (const std::string& row : rows) table += row + "\n";
  EXPECT_TRUE(page.ends_with("|---|---|---|---|---|\n" + table)) << table;
}

// Neither by name nor as a small number. 1e-300 keeps a length from being none.
TEST(JudgingConstants, StandInOneTable) {
  static const std::regex kNamed(
      R"(constexpr (const )?(static )?(int|double|float|auto|(std::)?\w+_t)\s+\w+(\[\])?\s*=\s*[-{]?[\d.])");
  static const std::regex kSmallNumber(R"(\d[eE]-\d+)");
  for (const char* room : {"region", "motion", "steps", "open", "judge"}) {
    for (const auto& file : fs::directory_iterator(kSources / "oracle" / room)) {
      if (file.path().filename() == "constants.hpp") continue;
      std::istringstream text(text_of(file.path()));
      for (std::string line; std::getline(text, line);) {
        line.resize(std::min(line.size(), line.find("//")));
        EXPECT_FALSE(std::regex_search(line, kNamed)) << file.path() << ": " << line;
        const std::string rest = std::regex_replace(line, std::regex("1e-300"), "");
        EXPECT_FALSE(std::regex_search(rest, kSmallNumber)) << file.path() << ": " << line;
      }
    }
  }
}

}  // namespace
}  // namespace gonogo
