// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/spawn_shell.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <system_error>
#include <vector>

#include "subjects/family_keeper.hpp"
#include "subjects/sandbox.hpp"

namespace gonogo::oracle {
namespace {

constexpr std::size_t kBlock = 512;  // bytes, the unit of ulimit

// What a subject learns of this program's environment besides what is asked for: what a command is
// found and run by, and what a build for testing reads. No token and no place of this run.
constexpr std::string_view kPassedOn[] = {
    "PATH",         "HOME",          "USER",         "LOGNAME",      "SHELL",
    "LANG",         "LANGUAGE",      "TZ",           "TMPDIR",       "LD_LIBRARY_PATH",
    "ASAN_OPTIONS", "UBSAN_OPTIONS", "LSAN_OPTIONS", "TSAN_OPTIONS", "LLVM_PROFILE_FILE"};

std::vector<std::string> environment_of(const Limits& limits) {
  std::vector<std::string> environment;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::string_view name = text.substr(0, text.find('='));
    if (name.starts_with("LC_") || std::ranges::find(kPassedOn, name) != std::end(kPassedOn) ||
        std::ranges::find(limits.environment, name) != limits.environment.end()) {
      environment.emplace_back(text);
    }
  }
  // NAME=VALUE, which need not be in this program's environment.
  std::ranges::copy_if(
      limits.environment, std::back_inserter(environment),
      [](const std::string& entry) { return entry.find('=') != std::string::npos; });
  environment.push_back(family_mark());
  return environment;
}

// The command, with no core files and no file longer than the memory that it may have.
std::string limited(const std::string& command, const Limits& limits) {
  return fmt::format("ulimit -c 0 2>/dev/null; ulimit -f {} 2>/dev/null; {}",
                     limits.memory_bytes / kBlock, command);
}

// As exec() takes them: up to a null pointer.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

// The settings of a new process: own session, no blocked or ignored signals, three pipes.
class SpawnSettings {
 public:
  SpawnSettings(int in, int out, int err) {
    posix_spawn_file_actions_init(&files_);
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_adddup2(&files_, in, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files_, out, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files_, err, STDERR_FILENO);
    sigset_t none;
    sigemptyset(&none);
    sigset_t all;
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setflags(&attributes_,
                             POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  const posix_spawn_file_actions_t& files() const { return files_; }
  const posix_spawnattr_t& attributes() const { return attributes_; }

 private:
  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

}  // namespace

pid_t spawn_shell(const std::string& command, const Limits& limits, const ControlGroup& group,
                  int in, int out, int err) {
  const SpawnSettings settings(in, out, err);
  const std::string script = limited(command, limits);
  std::vector<std::string> words = group.entering(
      limits.sandbox.is_on() ? sandbox_words(limits.sandbox, script, limits.memory_bytes)
                             : std::vector<std::string>{"/bin/sh", "-c", script});
  std::vector<std::string> environment = environment_of(limits);
  pid_t pid = -1;
  const int error =
      posix_spawn(&pid, words.front().c_str(), &settings.files(), &settings.attributes(),
                  pointers_to(words).data(), pointers_to(environment).data());
  if (error != 0) {
    throw std::system_error(error, std::generic_category(), "posix_spawn " + words.front());
  }
  return pid;
}

}  // namespace gonogo::oracle
