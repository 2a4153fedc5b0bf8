// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rules of docs/judging.md and what cites them: no citation without a rule, no rule that
// nothing carries, and of what is compared and of paths none that no test holds.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

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
  static const std::regex kRule(R"(\bJ-(CMP|PATH|CYC|THR|PKT|ALM|RUN|PROP|CONST)-[0-9]{2}\b)");
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

// A rule is what begins a paragraph: **J-PATH-03** ...
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
      cited_in({"grammar", "reference", "oracle", "fuzz", "cli", "expanders", "checker"});
  return kCited;
}

const std::map<std::string, std::string>& tests() {
  static const auto kCited = cited_in({"tests"});
  return kCited;
}

TEST(JudgingRules, AreWrittenOnce) {
  const auto written = rules();
  EXPECT_GT(written.size(), 30U);
  for (const std::string& id : written) EXPECT_EQ(written.count(id), 1U) << id;
}

TEST(JudgingRules, EveryOneThatIsCitedIsWritten) {
  const auto written = rules();
  for (const auto& cited : {code(), tests(), cited_in({"docs"})}) {
    for (const auto& [id, file] : cited) EXPECT_TRUE(written.contains(id)) << id << " in " << file;
  }
}

TEST(JudgingRules, EveryOneThatIsWrittenIsCited) {
  for (const std::string& id : rules()) {
    EXPECT_TRUE(code().contains(id) || tests().contains(id)) << id;
  }
}

TEST(JudgingRules, OfWhatIsComparedAndOfPathsAreInCodeAndTests) {
  for (const std::string& id : rules()) {
    if (!id.starts_with("J-CMP-") && !id.starts_with("J-PATH-")) continue;
    EXPECT_TRUE(code().contains(id)) << id << " is in no source";
    EXPECT_TRUE(tests().contains(id)) << id << " is in no test";
  }
}

}  // namespace
}  // namespace gonogo
