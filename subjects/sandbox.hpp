// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sandbox of a subject: bubblewrap, where it is installed. The subject has no network, its own
// processes and temporary files, and reads the system without changing it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gonogo::oracle {

struct Sandbox {
  std::string program;               // bubblewrap's; empty: the subject runs without a sandbox
  std::vector<std::string> hidden;   // folders that the subject does not see
  std::vector<std::string> bound;    // files and folders that it reads all the same
  std::vector<std::string> changed;  // and those that it may change

  bool is_on() const { return !program.empty(); }
};

// Returns the program and the words with which /bin/sh runs `command` in the sandbox. The current
// folder and the files that the command names can be read, with all of their folder below /tmp,
// unless they are hidden. `temporary_bytes` bounds what the subject writes to its own /tmp.
std::vector<std::string> sandbox_words(const Sandbox& sandbox, const std::string& command,
                                       std::size_t temporary_bytes);

struct SandboxSearch {
  std::string program;  // that works here; empty: there is none
  std::string why_not;  // "bubblewrap (bwrap) is not installed"
};
// Starts the sandbox once, to see whether this machine allows it.
SandboxSearch find_sandbox();

}  // namespace gonogo::oracle
