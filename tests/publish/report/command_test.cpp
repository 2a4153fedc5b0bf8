// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/command.hpp"

#include <gtest/gtest.h>

namespace gonogo::oracle::report {
namespace {

Json header_of(const std::string& spec, const Json& argv) {
  return {{"subject", {{"spec", spec}}}, {"seed", 7U}, {"shard", "1/1"}, {"argv", argv}};
}

std::string fresh_corpus(const std::string& spec, const Json& argv) {
  const std::string command = command_for_case(header_of(spec, argv), CaseOf::fresh);
  const std::string begin = "--corpus ";
  const std::size_t at = command.find(begin) + begin.size();
  return command.substr(at, command.find(' ', at) - at);
}

// Where `certify` leaves its report with these words.
TEST(CaseCommand, NamesTheFolderInWhichTheRunLeftItsFreshPrograms) {
  EXPECT_EQ(fresh_corpus("builtin:gsk", {"certify", "--subject", "builtin:gsk"}), "report/fresh");
  EXPECT_EQ(fresh_corpus("builtin:gsk", {"certify", "--subject", "builtin:gsk", "--report=r"}),
            "r/fresh");
  EXPECT_EQ(fresh_corpus("builtin:gsk",
                         {"certify", "--subject", "builtin:gsk", "--case", "a", "--fresh"}),
            "again/fresh");
  const Json two = {"certify",  "--subject", "builtin:gsk", "--subject", "pipe:./a b",
                    "--report", "r"};
  EXPECT_EQ(fresh_corpus("builtin:gsk", two), "r/builtin-gsk/fresh");
  EXPECT_EQ(fresh_corpus("pipe:./a b", two), "r/pipe-.-a-b/fresh");
  EXPECT_EQ(fresh_corpus("builtin:gsk", {"certify"}), "report/gsk/fresh");
}

TEST(CaseCommand, OfAMergedRunHasTheFilesAndLimitsOfItsShards) {
  Json header = header_of("builtin:gsk", {"merge", "one", "two", "--out", "both"});
  Json shard = {{"shard", "1/2"}, {"seed", 7}, {"fresh", Json::object()}};
  shard["argv"] = {
      "certify",     "--subject", "builtin:gsk",      "--shard", "1/2",       "--profile", "m.toml",
      "--alarm-map", "a.toml",    "--known-failures", "k.toml",  "--timeout", "9"};
  header["shards"] = {shard, shard};
  const std::string command = command_for_case(header);
  for (const char* words :
       {"--profile m.toml", "--alarm-map a.toml", "--known-failures k.toml", "--timeout 9"}) {
    EXPECT_NE(command.find(words), std::string::npos) << command;
  }
  EXPECT_EQ(command.find("--shard"), std::string::npos) << command;
}

// What an earlier case left behind shows again after it, and never alone.
TEST(CaseCommand, OfAStateLeakRunsAllCasesInTheirOrder) {
  Json header = header_of("builtin:gsk", {"certify", "--subject", "builtin:gsk", "--dialect",
                                          "gsk988ta", "--cycle", "g94", "--jobs", "8"});
  header["selection"] = {
      {"dialects", {"gsk988ta"}}, {"only", Json::array()}, {"case", nullptr}, {"cycles", {"g94"}}};
  const std::string command = command_for_run(header);
  EXPECT_TRUE(command.ends_with(" --dialect gsk988ta --cycle g94 --seed 7 --jobs 1 --report again"))
      << command;
  EXPECT_EQ(command.find("--case"), std::string::npos) << command;
}

}  // namespace
}  // namespace gonogo::oracle::report
