// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sandbox_options.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "subjects/sandbox.hpp"

namespace gonogo::cli {
namespace {

constexpr std::string_view kMayChange = ":rw";

bool starts_processes(const std::string& subject) {
  return subject.starts_with("pipe:") || subject.starts_with("oneshot:") ||
         subject.starts_with("lib:");
}

void add_bound(oracle::Sandbox& sandbox, std::string path) {
  const bool may_change = path.ends_with(kMayChange);
  if (may_change) path.resize(path.size() - kMayChange.size());
  if (!std::filesystem::exists(path)) {
    throw UsageError(fmt::format("--bind {}: there is no such file or folder.", path));
  }
  (may_change ? sandbox.changed : sandbox.bound).push_back(path);
}

}  // namespace

void add_sandbox_options(Command& command, SandboxOptions& options, const std::string& by_default) {
  options.wish = by_default;
  command.option("--sandbox", options.wish,
                 fmt::format("run the subject in bubblewrap: auto (where it can be had), off, "
                             "required ({})",
                             by_default));
  command.repeated_option("--bind", options.bound,
                          "a file or folder that the subject sees in its sandbox as well; "
                          "PATH:rw for one that it may change");
}

oracle::Limits sandboxed(oracle::Limits limits, const SandboxOptions& options,
                         const std::string& subject, const std::vector<std::string>& hidden) {
  if (options.wish != "auto" && options.wish != "off" && options.wish != "required") {
    throw UsageError(
        fmt::format("--sandbox takes auto, off or required, not \"{}\".", options.wish));
  }
  if (options.wish == "off" || !starts_processes(subject)) return limits;
  static const oracle::SandboxSearch found = oracle::find_sandbox();
  if (found.program.empty() && options.wish == "required") {
    throw UsageError(fmt::format(
        "--sandbox required: {}. Install it (Debian's package bubblewrap) and allow user "
        "namespaces, or write --sandbox off.",
        found.why_not));
  }
  limits.sandbox.program = found.program;
  for (const std::string& folder : hidden) {
    if (!folder.empty()) limits.sandbox.hidden.push_back(folder);
  }
  for (const std::string& path : options.bound) add_bound(limits.sandbox, path);
  // A build that is measured writes there what ran.
  if (const char* measured = std::getenv("LLVM_PROFILE_FILE")) {
    limits.sandbox.changed.push_back(std::filesystem::absolute(measured).parent_path().string());
  }
  return limits;
}

std::string sandbox_name(const oracle::Limits& limits, const std::string& subject) {
  if (!starts_processes(subject)) return {};
  return limits.sandbox.is_on() ? "bubblewrap" : "none";
}

}  // namespace gonogo::cli
