// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a subject may have at once, and the control group that it runs in.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "run_subject.hpp"
#include "subjects/control_group.hpp"

namespace gonogo::oracle {
namespace {

namespace fs = std::filesystem;

class ProcessLimits : public testing::Test {
 protected:
  ProcessLimits() : folder_(fs::path(testing::TempDir()) / fmt::format("limits-{}", getpid())) {
    fs::create_directories(folder_);
  }
  ~ProcessLimits() override { fs::remove_all(folder_); }

  RunEnd end_of(const std::string& script) const {
    auto subject = make_oneshot_subject(fmt::format("sh -c '{}' subject", script), limits_);
    subject->configure(gsk_profile());
    return run(*subject).end;
  }

  fs::path folder_;
  Limits limits_ = patient_limits();
};

TEST_F(ProcessLimits, TooManyProcessesAtOnceEndARun) {
  limits_.processes = 20;
  const RunEnd end = end_of(
      "for i in 1 2 3 4 5 6; do (sleep 60 & sleep 60 & sleep 60 & "
      "sleep 60 & wait) & done; wait");
  EXPECT_EQ(end.kind, Kind::out_of_memory);
  EXPECT_EQ(end.message, "The subject had more than 20 processes at once.");
}

TEST_F(ProcessLimits, AFileIsNoLongerThanTheMemory) {
  limits_.memory_bytes = std::size_t{32} << 20;
  const fs::path file = folder_ / "long";
  end_of(fmt::format("head -c 40000000 /dev/zero >{}", file.string()));
  EXPECT_EQ(fs::file_size(file), limits_.memory_bytes);
}

TEST_F(ProcessLimits, ACrashLeavesNoCore) {
  const fs::path seen = folder_ / "seen";
  end_of(fmt::format("ulimit -c >{}", seen.string()));
  std::string most;
  std::ifstream(seen) >> most;
  EXPECT_EQ(most, "0");
}

TEST_F(ProcessLimits, AGroupIsGivenTheLimitsThatItKnows) {
  // A group whose place has a controller for memory and none for processes.
  std::ofstream(folder_ / "memory.max") << "max";
  ControlGroup(folder_.string()).limit(1000, 8);
  std::string most;
  std::ifstream(folder_ / "memory.max") >> most;
  EXPECT_EQ(most, "2000");
  EXPECT_FALSE(fs::exists(folder_ / "pids.max"));
}

TEST_F(ProcessLimits, AGroupEndsWhatLeftItsParentAndItsSession) {
  ControlGroup group = ControlGroup::make(std::size_t{1} << 30, 100);
  if (!group.exists()) GTEST_SKIP() << "no control group can be made here";
  const fs::path seen = folder_ / "pid";
  const std::vector<std::string> words = group.entering(
      {"/bin/sh", "-c",
       fmt::format("setsid sh -c 'echo $$ >{0}~; mv {0}~ {0}; exec sleep 60' & exit 0",
                   seen.string())});
  const pid_t first = ::fork();
  if (first == 0) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::execv(arguments.front(), arguments.data());
    ::_exit(127);
  }
  ::waitpid(first, nullptr, 0);
  pid_t left = 0;
  while (left == 0) std::ifstream(seen) >> left;
  const std::vector<pid_t> in_it = group.processes();
  EXPECT_EQ(std::ranges::count(in_it, left), 1);
  group = ControlGroup();  // the old one ends with this statement
  while (::waitpid(left, nullptr, WNOHANG) == 0) {
  }
  EXPECT_FALSE(is_alive(left));
}

}  // namespace
}  // namespace gonogo::oracle
