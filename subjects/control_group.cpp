// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/control_group.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <system_error>
#include <thread>

namespace gonogo::oracle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kName = "gonogo-";
constexpr int kRoundsToEnd = 200;  // of a millisecond, until the kernel has ended what it was told to
// How much wider the kernel's bounds are than those that are measured. It counts threads.
constexpr std::size_t kMemoryFactor = 2;
constexpr std::size_t kThreadsPerProcess = 8;

// Where the hierarchy of version 2 is mounted; empty: nowhere.
std::string mount_point() {
  std::ifstream mounts("/proc/self/mountinfo");
  for (std::string line; std::getline(mounts, line);) {
    if (line.find(" - cgroup2 ") == std::string::npos) continue;
    std::istringstream words(line);
    std::string word;
    std::string root;
    std::string point;
    words >> word >> word >> word >> root >> point;
    if (root == "/") return point;
  }
  return {};
}

// This program's own group, from the root of the hierarchy.
std::string own_group() {
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    if (line.starts_with("0::/")) return line.substr(3);
  }
  return {};
}

// Groups of runs that were killed.
void remove_left(const fs::path& place) {
  std::error_code ignored;
  for (fs::directory_iterator group(place, ignored), last; !ignored && group != last;
       group.increment(ignored)) {
    const std::string name = group->path().filename().string();
    pid_t owner = 0;
    if (!name.starts_with(kName)) continue;
    std::istringstream(name.substr(kName.size())) >> owner;
    if (owner > 0 && ::kill(owner, 0) != 0 && errno == ESRCH) ::rmdir(group->path().c_str());
  }
}

// The folder for new groups; empty: there is none.
fs::path place_of_groups() {
  const std::string mount = mount_point();
  const std::string own = own_group();
  if (mount.empty() || own.empty() || own.find("/..") != std::string::npos) return {};
  const fs::path place = own == "/" ? fs::path(mount) : fs::path(mount + own).parent_path();
  remove_left(place);
  return place;
}

}  // namespace

ControlGroup ControlGroup::make(std::size_t memory_bytes, std::size_t processes) {
  static const fs::path kPlace = place_of_groups();
  static std::atomic<unsigned> made = 0;
  static std::atomic<bool> is_refused = kPlace.empty();
  if (is_refused) return {};
  const fs::path folder = kPlace / fmt::format("{}{}-{}", kName, ::getpid(), ++made);
  if (::mkdir(folder.c_str(), 0755) != 0) {
    is_refused = true;
    return {};
  }
  ControlGroup group(folder.string());
  group.limit(memory_bytes, processes);
  return group;
}

ControlGroup::~ControlGroup() {
  if (!exists()) return;
  kill();
  for (int round = 0; round < kRoundsToEnd && ::rmdir(folder_.c_str()) != 0 && errno == EBUSY; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

bool ControlGroup::write(const char* file, const std::string& text) const {
  if (!exists()) return false;
  const int fd = ::open((folder_ + '/' + file).c_str(), O_WRONLY | O_CLOEXEC);
  if (fd < 0) return false;
  const bool is_written =
      ::write(fd, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  ::close(fd);
  return is_written;
}

void ControlGroup::limit(std::size_t memory_bytes, std::size_t processes) const {
  write("memory.max", fmt::format("{}", kMemoryFactor * memory_bytes));
  write("memory.swap.max", "0");
  write("pids.max", fmt::format("{}", kThreadsPerProcess * processes));
}

// By itself, since what somebody else puts into it may have begun others by then.
std::vector<std::string> ControlGroup::entering(std::vector<std::string> words) const {
  if (!exists()) return words;
  std::vector<std::string> all = {"/bin/sh", "-c", R"({ echo 0 >"$0"; } 2>/dev/null; exec "$@")",
                                  folder_ + "/cgroup.procs"};
  all.insert(all.end(), std::make_move_iterator(words.begin()),
             std::make_move_iterator(words.end()));
  return all;
}

std::vector<pid_t> ControlGroup::processes() const {
  std::vector<pid_t> all;
  if (!exists()) return all;
  std::ifstream list(folder_ + "/cgroup.procs");
  for (pid_t process = 0; list >> process;) all.push_back(process);
  return all;
}

void ControlGroup::kill() const {
  if (write("cgroup.kill", "1")) return;
  for (const pid_t process : processes()) ::kill(process, SIGKILL);  // before Linux 5.14
}

}  // namespace gonogo::oracle
