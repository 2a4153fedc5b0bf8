// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/process_family.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace gonogo::oracle {
namespace {

// What goes on to make processes while it is ended is given up after so many rounds.
constexpr int kRounds = 200;
constexpr std::size_t kMostProcesses = 4096;

struct Families {
  std::mutex mutex;
  std::map<pid_t, ControlGroup> first;  // of each subject that runs, with its group
};

Families& families() {
  static Families all;
  return all;
}

std::size_t resident_bytes_of(pid_t process) {
  static const auto kPage = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  std::ifstream statm("/proc/" + std::to_string(process) + "/statm");
  std::size_t total = 0;
  std::size_t resident = 0;
  statm >> total >> resident;
  return statm ? resident * kPage : 0;
}

void add_children(const std::string& process, std::vector<pid_t>& out) {
  std::error_code error;
  for (std::filesystem::directory_iterator task("/proc/" + process + "/task", error), last;
       !error && task != last; task.increment(error)) {
    std::ifstream children(task->path() / "children");
    for (pid_t child = 0; children >> child;) out.push_back(child);
  }
}

// Children of this program that are no subject: orphans of one. Those of the session of `first`,
// and those of none that runs; of `first` 0, the latter alone.
std::vector<pid_t> orphans_of(pid_t first) {
  std::vector<pid_t> children;
  add_children("self", children);
  std::erase_if(children, [&](pid_t child) {
    if (families().first.contains(child)) return true;
    const pid_t session = ::getsid(child);
    return session == ::getsid(0) || (session != first && families().first.contains(session));
  });
  return children;
}

void add_descendants(std::vector<pid_t>& family) {
  for (std::size_t i = 0; i < family.size() && family.size() < kMostProcesses; ++i) {
    add_children(std::to_string(family[i]), family);
  }
}

// Ends what `collect` finds until it finds nothing that is left.
template <typename Collect>
void end_all(const Collect& collect) {
  for (int round = 0; round < kRounds; ++round) {
    std::vector<pid_t> orphans = collect();
    std::vector<pid_t> all = orphans;
    add_descendants(all);
    for (const pid_t process : all) ::kill(process, SIGKILL);
    for (const pid_t orphan : orphans) ::waitpid(orphan, nullptr, WNOHANG);
    if (all.empty()) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

}  // namespace

pid_t begin_family(const std::function<pid_t(const ControlGroup&)>& spawn, ControlGroup group) {
  static const bool adopts = ::prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) == 0;
  static_cast<void>(adopts);
  const std::lock_guard lock(families().mutex);
  const pid_t first = spawn(group);
  families().first.emplace(first, std::move(group));
  return first;
}

FamilySize size_of_family(pid_t first) {
  std::vector<pid_t> found;
  std::vector<pid_t> grouped;
  {
    const std::lock_guard lock(families().mutex);
    found = orphans_of(first);
    grouped = families().first.at(first).processes();
  }
  found.push_back(first);
  add_descendants(found);
  std::set<pid_t> family(found.begin(), found.end());
  family.insert(grouped.begin(), grouped.end());
  FamilySize size{0, family.size()};
  for (const pid_t process : family) size.resident_bytes += resident_bytes_of(process);
  return size;
}

int end_family(pid_t first) {
  const std::lock_guard lock(families().mutex);
  std::vector<pid_t> family = {first};
  add_descendants(family);
  families().first.at(first).kill();
  ::kill(-first, SIGKILL);
  for (const pid_t process : family) ::kill(process, SIGKILL);
  int status = 0;
  while (::waitpid(first, &status, 0) < 0 && errno == EINTR) {
  }
  // What it had has come to this program by now, and what it had that in turn comes when it ends.
  end_all([&] {
    std::vector<pid_t> orphans = orphans_of(first);
    std::erase_if(orphans, [&](pid_t orphan) { return ::getsid(orphan) != first; });
    return orphans;
  });
  families().first.erase(first);
  if (families().first.empty()) end_all([] { return orphans_of(0); });
  return status;
}

}  // namespace gonogo::oracle
