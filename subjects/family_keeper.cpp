// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/family_keeper.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>

namespace gonogo::oracle {
namespace {

// Reads until the other end of its input is gone with the gauge. A process may be made while others
// are ended, so that it looks until it finds none.
constexpr const char* kScript =
    "trap '' HUP INT QUIT TERM\n"
    "while read -r line; do :; done\n"
    "round=0\n"
    "while [ $round -lt 50 ]; do\n"
    "  found=$(grep -lsFa -e \"$1\" /proc/[0-9]*/environ)\n"
    "  [ -n \"$found\" ] || exit 0\n"
    "  for file in $found; do file=${file#/proc/}; kill -9 ${file%/environ}; done\n"
    "  round=$((round + 1))\n"
    "done\n";

class Keeper {
 public:
  Keeper() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
    pid_ = spawn(ends[0]);
    ::close(ends[0]);
    gone_with_us_ = ends[1];
  }
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;
  ~Keeper() {
    if (pid_ > 0 && ::getpid() == gauge_) {  // and in no copy of the gauge that ends
      ::kill(pid_, SIGKILL);
      while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
      }
    }
    if (gone_with_us_ >= 0) ::close(gone_with_us_);
  }

 private:
  // Nothing of this program's is left open in it: neither its output nor the lock of a folder.
  static pid_t spawn(int input) {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
      posix_spawn_file_actions_addopen(&files, descriptor, "/dev/null", O_WRONLY, 0);
    }
    posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
    std::string shell = "sh";
    std::string option = "-c";
    std::string script = kScript;
    std::string mark = family_mark();
    const std::array<char*, 6> words = {shell.data(), option.data(), script.data(),
                                        shell.data(), mark.data(),   nullptr};
    std::string path = "PATH=/usr/bin:/bin";
    const std::array<char*, 2> environment = {path.data(), nullptr};
    pid_t pid = -1;
    const int error =
        posix_spawn(&pid, "/bin/sh", &files, nullptr, words.data(), environment.data());
    posix_spawn_file_actions_destroy(&files);
    return error == 0 ? pid : -1;
  }

  const pid_t gauge_ = ::getpid();
  pid_t pid_ = -1;
  int gone_with_us_ = -1;  // the end of the pipe that closes with this program
};

}  // namespace

const std::string& family_mark() {
  static const std::string kMark =
      fmt::format("GONOGO_FAMILY={}-{}", ::getpid(),
                  std::chrono::steady_clock::now().time_since_epoch().count());
  return kMark;
}

void start_family_keeper() {
  static const Keeper kKeeper;
}

}  // namespace gonogo::oracle
