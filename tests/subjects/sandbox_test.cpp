// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/sandbox.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace gonogo::oracle {
namespace {

namespace fs = std::filesystem;

// A folder below /tmp with a subject and, beside it, a corpus and a report.
class SandboxWords : public testing::Test {
 protected:
  SandboxWords() : folder_(fs::path("/tmp") / ("gonogo-sandbox-" + std::to_string(getpid()))) {
    for (const char* name : {"bin", "corpus", "report"}) fs::create_directories(folder_ / name);
    std::ofstream(folder_ / "bin/subject") << "exit 0\n";
    sandbox_.program = "/usr/bin/bwrap";
  }
  ~SandboxWords() override { fs::remove_all(folder_); }

  std::string at(const char* name) const { return (folder_ / name).string(); }
  // Whether the words have `option`, `path` one behind the other; and where.
  static std::ptrdiff_t place(const std::vector<std::string>& words, const std::string& option,
                              const std::string& path) {
    const std::vector<std::string> two = {option, path};
    const auto found = std::ranges::search(words, two);
    return found.empty() ? -1 : found.begin() - words.begin();
  }

  fs::path folder_;
  Sandbox sandbox_;
};

TEST_F(SandboxWords, TheFolderBelowTmpOfAFileThatTheCommandNamesIsRead) {
  const auto words = sandbox_words(sandbox_, "exec '" + at("bin/subject") + "' --fast", 1000);
  const auto own = place(words, "--tmpfs", "/tmp");
  const auto bound = place(words, "--ro-bind", folder_.string());
  ASSERT_GE(own, 0);
  EXPECT_GT(bound, own);
  EXPECT_EQ(words.back(), "exec '" + at("bin/subject") + "' --fast");
}

TEST_F(SandboxWords, WhatIsHiddenIsHiddenThoughTheCommandNamesIt) {
  sandbox_.hidden = {at("corpus"), at("report")};
  const auto words = sandbox_words(sandbox_, "cat " + at("corpus"), 1000);
  const auto bound = place(words, "--ro-bind", folder_.string());
  ASSERT_GT(bound, 0);
  EXPECT_GT(place(words, "--tmpfs", at("corpus")), bound);
  EXPECT_GT(place(words, "--tmpfs", at("report")), bound);
}

TEST_F(SandboxWords, AFolderInAHiddenOneLeavesNoTraceOfItself) {
  fs::create_directories(folder_ / "report/traces");
  sandbox_.hidden = {at("report"), at("report/traces")};
  EXPECT_EQ(place(sandbox_words(sandbox_, "true", 1000), "--tmpfs", at("report/traces")), -1);
}

TEST_F(SandboxWords, WhatIsBoundByHandIsSeenThoughItIsHidden) {
  sandbox_.hidden = {at("corpus")};
  sandbox_.bound = {at("corpus")};
  sandbox_.changed = {at("bin")};
  const auto words = sandbox_words(sandbox_, "true", 1000);
  EXPECT_GT(place(words, "--ro-bind", at("corpus")), place(words, "--tmpfs", at("corpus")));
  EXPECT_GT(place(words, "--bind", at("bin")), 0);
}

TEST_F(SandboxWords, TheFolderInWhichTheSubjectStandsStaysVisible) {
  sandbox_.hidden = {"."};
  const auto words = sandbox_words(sandbox_, "true", 1000);
  EXPECT_EQ(place(words, "--tmpfs", fs::current_path().string()), -1);
}

}  // namespace
}  // namespace gonogo::oracle
