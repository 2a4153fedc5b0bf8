// SPDX-License-Identifier: GPL-3.0-or-later
//
// The checker shares no code with what it checks.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

namespace {

namespace fs = std::filesystem;

TEST(CheckerIndependence, IncludesNothingButItselfGmpAndTheStandardLibrary) {
  static const std::regex kInclude(R"re(#include ([<"])([^>"]+)[>"])re");
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(GONOGO_SOURCE_DIR) / "checker")) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".cpp" && ending != ".hpp") continue;
    ++files;
    std::ifstream file(entry.path());
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    for (std::sregex_iterator it(text.begin(), text.end(), kInclude), end; it != end; ++it) {
      const std::string name = (*it)[2];
      if ((*it)[1] == "\"") {
        EXPECT_TRUE(name.starts_with("checker/")) << entry.path() << " includes " << name;
      } else {
        EXPECT_TRUE(name == "gmpxx.h" || name.find_first_of("./") == std::string::npos)
            << entry.path() << " includes " << name;
      }
    }
  }
  EXPECT_GT(files, 10U);
}

TEST(CheckerIndependence, HasNoFloatingPoint) {
  static const std::regex kFloat(R"(\b(double|float)\b)");
  static const std::regex kNoise(R"(//[^\n]*|"(\\.|[^"\\\n])*")");
  for (const auto& entry : fs::directory_iterator(fs::path(GONOGO_SOURCE_DIR) / "checker")) {
    std::ifstream file(entry.path());
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    EXPECT_FALSE(std::regex_search(std::regex_replace(text, kNoise, ""), kFloat)) << entry.path();
  }
}

}  // namespace
