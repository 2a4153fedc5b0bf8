// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/subjects/process_memory.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace gonogo::oracle {
namespace {

std::size_t resident_bytes_of(const std::string& folder) {
  static const auto kPage = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  std::ifstream statm(folder + "/statm");
  std::size_t total = 0;
  std::size_t resident = 0;
  statm >> total >> resident;
  return statm ? resident * kPage : 0;
}

void add_children(const std::string& folder, std::vector<pid_t>& out) {
  std::error_code error;
  for (std::filesystem::directory_iterator task(folder + "/task", error), last;
       !error && task != last; task.increment(error)) {
    std::ifstream children(task->path() / "children");
    for (pid_t child = 0; children >> child;) out.push_back(child);
  }
}

}  // namespace

std::size_t resident_bytes(pid_t process) {
  constexpr std::size_t kMostProcesses = 256;
  std::vector<pid_t> family = {process};
  std::size_t sum = 0;
  for (std::size_t i = 0; i < family.size() && i < kMostProcesses; ++i) {
    const std::string folder = "/proc/" + std::to_string(family[i]);
    sum += resident_bytes_of(folder);
    add_children(folder, family);
  }
  return sum;
}

}  // namespace gonogo::oracle
