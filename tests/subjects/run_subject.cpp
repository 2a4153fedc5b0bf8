// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_subject.hpp"

#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "subjects/family_keeper.hpp"

namespace gonogo::oracle {

std::unique_ptr<Subject> fake_pipe(const std::string& mode, const Limits& limits) {
  auto subject = make_pipe_subject(std::string(FAKE_PIPE) + " " + mode, limits);
  subject->configure(gsk_profile());
  return subject;
}

RunEnd pipe_end(const std::string& mode) {
  return run(*fake_pipe(mode)).end;
}

std::size_t open_descriptors() {
  start_family_keeper();  // of the program, and of no subject
  const std::filesystem::directory_iterator folder("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(folder), end(folder)));
}

bool has_children() {
  start_family_keeper();
  std::size_t children = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream list(task.path() / "children");
    for (int child = 0; list >> child;) ++children;
  }
  return children > 1;
}

bool is_alive(int pid) {
  if (kill(pid, 0) != 0) return false;
  std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
  const std::string text(std::istreambuf_iterator<char>(stat), {});
  const std::size_t name_end = text.rfind(')');
  return name_end != std::string::npos && text[name_end + 2] != 'Z';
}

}  // namespace gonogo::oracle
