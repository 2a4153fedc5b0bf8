// SPDX-License-Identifier: GPL-3.0-or-later
//
// The steps of `./gonogo test`: CONTRIBUTING.md says of each what it is for.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <string>

namespace gonogo {
namespace {

// What the first group of the pattern matches, line by line; how many lines match.
struct Named {
  std::set<std::string> names;
  std::size_t lines = 0;
};

Named named_in(const std::string& file, const std::regex& pattern) {
  std::ifstream lines(std::string(GONOGO_SOURCE_DIR) + "/" + file);
  Named named;
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_search(line, match, pattern)) continue;
    named.names.insert(match[1]);
    ++named.lines;
  }
  return named;
}

TEST(Steps, OfATestRunStandInTheTableOfContributing) {
  const Named steps = named_in("tests/run-all", std::regex(R"re(^ *step "([^"]+)")re"));
  const Named rows = named_in("CONTRIBUTING.md", std::regex(R"(^\| \*\*([^*|]+)\*\* \|)"));
  EXPECT_GE(steps.names.size(), 7U);
  EXPECT_EQ(steps.lines, steps.names.size()) << "two steps have one name";
  for (const std::string& step : steps.names) {
    EXPECT_TRUE(rows.names.contains(step)) << "CONTRIBUTING.md has no row of the step " << step;
  }
}

// What builds or tests stands behind a step, so that its time has an entry; tests leave theirs in a file.
TEST(Steps, HoldAllThatATestRunDoes) {
  std::ifstream lines(std::string(GONOGO_SOURCE_DIR) + "/tests/run-all");
  const std::regex work(R"(^ *(build|run_tests|cmake/install-packages|npm|tests/tidy|fuzz/short-run|build/)\b)");
  bool in_step = false;
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("step \"") != std::string::npos) in_step = true;
    if (line.starts_with("build()") || line.starts_with("run_tests()")) continue;
    if (line.find("ctest ") != std::string::npos && !line.starts_with("#")) {
      EXPECT_TRUE(line.starts_with("run_tests() ")) << line;
    }
    if (!std::regex_search(line, work)) continue;
    ++count;
    EXPECT_TRUE(in_step) << line;
  }
  EXPECT_GE(count, 8U);
}

}  // namespace
}  // namespace gonogo
