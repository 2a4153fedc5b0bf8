// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pages in docs/dialects: current, whole, and without a dead link.
#include "publish/manual/examples.hpp"
#include "publish/manual/page.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "reference/reading.hpp"

namespace gonogo::oracle::manual {
namespace {

namespace fs = std::filesystem;

const fs::path kPages = fs::path(GONOGO_SOURCE_DIR) / "docs/dialects";

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class EveryDialect : public testing::TestWithParam<std::string> {
 protected:
  const reference::Dialect& dialect() const { return *reference::find_dialect(GetParam()); }
  std::vector<PageFile> files() const { return page_of(dialect()); }
};

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const reference::Dialect& dialect : reference::dialects()) all.emplace_back(dialect.name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Pages, EveryDialect, testing::ValuesIn(names()),
                         [](const auto& name) { return name.param; });

TEST_P(EveryDialect, PageInDocsIsWhatTheProgramWrites) {
  std::set<std::string> written;
  for (const PageFile& file : files()) {
    EXPECT_TRUE(written.insert(file.name).second) << file.name << " is written twice";
    EXPECT_TRUE(read(kPages / file.name) == file.text)
        << "docs/dialects/" << file.name
        << " is not what the program writes; run: "
           "./gonogo spec --format markdown --out docs/dialects";
  }
  for (const auto& entry : fs::directory_iterator(kPages / GetParam())) {
    const std::string name = fs::relative(entry.path(), kPages).string();
    EXPECT_TRUE(written.contains(name)) << name << " stands on no page; remove it";
  }
}

TEST_P(EveryDialect, PageHasEveryClauseAndReading) {
  const std::string page = files().front().text;
  for (const reference::Clause& clause : dialect().clauses) {
    EXPECT_NE(page.find("</a>" + std::string(clause.id) + " |"), std::string::npos) << clause.id;
  }
  for (const reference::Reading& reading : reference::readings()) {
    // One that two dialects share stands on the page of the first.
    if (reading.dialect != GetParam()) continue;
    EXPECT_NE(page.find("#### " + std::string(reading.name) + "\n"), std::string::npos)
        << reading.name;
  }
}

// Every section of a manual that has a page here has a drawing on it.
TEST_P(EveryDialect, EverySectionHasADrawingOrPointsToOne) {
  const std::string page = files().front().text;
  std::size_t at = page.find("<a id=\"section-1\">");
  ASSERT_NE(at, std::string::npos);
  while (page.compare(at, 15, "<a id=\"section-") == 0) {
    const std::size_t end =
        std::min(page.find("<a id=\"section-", at + 1), page.find("<a id=\"outside\">"));
    const std::string section = page.substr(at, end - at);
    EXPECT_TRUE(section.find("![") != std::string::npos ||
                section.find("Drawings, readings and alarms are those of") != std::string::npos)
        << section.substr(0, 120);
    at = end;
  }
}

// A value of an address as it was before it was written for one.
std::string decoded(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    out += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
    i += 2;
  }
  return out;
}

const char* const kPlayground = "../../build/playground/page/index.html";

TEST_P(EveryDialect, EveryExampleOpensInThePlayground) {
  std::multiset<std::string> wanted;
  const auto add = [&](const auto& example) { wanted.insert(example.program + example.profile); };
  for (const Examples& part : examples_of(GetParam())) {
    if (part.dialect != GetParam()) continue;  // stand on the page of that one
    for (const auto& example : part.examples) add(example);
    for (const auto& example : part.readings) add(example);
    for (const auto& example : part.alarms) add(example);
  }
  const std::string page = files().front().text;
  static const std::regex link(
      R"rx(page/index\.html#dialect=([a-z0-9]+)&program=([^&)]*)(?:&profile=([^)]*))?\))rx");
  std::multiset<std::string> linked;
  for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it) {
    EXPECT_EQ(it->str(1), GetParam());
    linked.insert(decoded(it->str(2)) + decoded(it->str(3)));
  }
  EXPECT_GT(linked.size(), 10U);
  EXPECT_EQ(linked, wanted);
}

TEST_P(EveryDialect, LinksLeadSomewhere) {
  const std::string page = files().front().text;
  static const std::regex link(R"rx(\]\(([^)#]*)(?:#([^)]*))?\))rx");
  std::size_t links = 0;
  for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it) {
    const std::string file = it->str(1);
    if (file == kPlayground) continue;  // built by a script of its own
    ++links;
    const std::string target =
        file.ends_with(".md") ? read(kPages / file) : (file.empty() ? page : "");
    if (!file.empty()) {
      EXPECT_TRUE(fs::exists(kPages / file)) << it->str();
    }
    if (!it->str(2).empty()) {
      EXPECT_NE(target.find("<a id=\"" + it->str(2) + "\">"), std::string::npos) << it->str();
    }
  }
  EXPECT_GT(links, 20U);
}

}  // namespace
}  // namespace gonogo::oracle::manual
