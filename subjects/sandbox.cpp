// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/sandbox.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <system_error>

#include "oracle/records/text.hpp"
#include "subjects/process.hpp"

namespace gonogo::oracle {
namespace {

namespace fs = std::filesystem;

// Sockets of services lie there, and what other programs left.
constexpr std::string_view kOwn[] = {"/tmp", "/var/tmp", "/run"};
constexpr std::size_t kTrialBytes = std::size_t{1} << 20;

bool lies_in(const fs::path& path, const fs::path& folder) {
  const auto [in_folder, in_path] = std::ranges::mismatch(folder, path);
  return in_folder == folder.end();
}

fs::path absolute(const std::string& path) {
  std::error_code ignored;
  fs::path whole = fs::absolute(path, ignored).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

// The words of a shell command, as far as they can be files: without quotes.
std::vector<std::string> plain_words(const std::string& command) {
  std::vector<std::string> words(1);
  for (const char c : command) {
    if (c == '\'' || c == '"') continue;
    const bool ends = std::string_view(" \t\n;&|<>()=").find(c) != std::string_view::npos;
    if (ends && !words.back().empty()) words.emplace_back();
    if (!ends) words.back() += c;
  }
  return words;
}

// What the command needs of the places that the sandbox has of its own: the folder below one of
// them in which it stands or that has a file of it, for a program needs more than the file that is
// named.
std::vector<fs::path> needed(const std::string& command) {
  std::error_code ignored;
  std::vector<std::string> places = plain_words(command);
  places.push_back(fs::current_path(ignored).string());
  std::vector<fs::path> all;
  for (const std::string& place : places) {
    if (place.empty() || !fs::exists(place, ignored)) continue;
    const fs::path path = absolute(place);
    for (const fs::path own : kOwn) {
      if (path == own || !lies_in(path, own)) continue;
      all.push_back(own / *std::next(path.begin(), std::distance(own.begin(), own.end())));
    }
  }
  return all;
}

}  // namespace

std::vector<std::string> sandbox_words(const Sandbox& sandbox, const std::string& command,
                                       std::size_t temporary_bytes) {
  std::vector<std::string> words = {
      sandbox.program, "--unshare-all", "--die-with-parent",
      // Where the gauge is root, the subject could take away what hides the rest.
      "--cap-drop", "ALL", "--ro-bind", "/", "/", "--proc", "/proc", "--dev", "/dev"};
  const auto put = [&](std::string_view option, const std::string& path) {
    words.insert(words.end(), {std::string(option), path, path});
  };
  const std::string size = fmt::format("{}", temporary_bytes);
  const auto empty = [&](const std::string& folder) {
    words.insert(words.end(), {"--size", size, "--tmpfs", folder});
  };
  std::error_code ignored;
  for (const std::string_view own : kOwn) {
    if (fs::is_directory(own, ignored) && !fs::is_symlink(own, ignored)) empty(std::string(own));
  }
  const fs::path here = fs::current_path(ignored);
  const std::vector<fs::path> needs = needed(command);
  for (const fs::path& path : needs) put("--ro-bind", path.string());
  std::vector<fs::path> emptied;
  for (const std::string& hidden : sandbox.hidden) {
    const fs::path folder = absolute(hidden);
    const bool is_gone =
        std::ranges::any_of(emptied, [&](const fs::path& one) { return lies_in(folder, one); });
    // The folder in which the subject stands is still read-only.
    if (is_gone || !fs::is_directory(folder, ignored) || lies_in(here, folder)) continue;
    emptied.push_back(folder);
    empty(folder.string());
  }
  for (const std::string& path : sandbox.bound) put("--ro-bind", absolute(path).string());
  for (const std::string& path : sandbox.changed) put("--bind", absolute(path).string());
  words.insert(words.end(), {"--setenv", "TMPDIR", "/tmp", "--chdir", here.string(), "--",
                             "/bin/sh", "-c", command});
  return words;
}

SandboxSearch find_sandbox() {
  const char* path = std::getenv("PATH");
  SandboxSearch search;
  for (std::string_view rest = path == nullptr ? "" : path; !rest.empty();) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    const std::string program = std::string(folder) + "/bwrap";
    if (folder.starts_with('/') && ::access(program.c_str(), X_OK) == 0) {
      search.program = program;
      break;
    }
  }
  if (search.program.empty()) return {{}, "bubblewrap (bwrap) is not installed"};
  Limits limits;
  limits.sandbox.program = search.program;
  Process trial("exit 0", limits);
  trial.arm(limits.start);
  trial.end_input();
  LineBuffer output(kTrialBytes);
  const Process::Event event = trial.pump_to_end(output, drop);
  const Ending ending = trial.kill();
  if (event == Process::Event::exited && ending.signal == 0 && ending.code == 0) return search;
  const std::string notes = trial.take_notes();
  return {{},
          fmt::format("bubblewrap does not work here: {}",
                      notes.empty() ? "it " + ending.text() : excerpt(notes, 300))};
}

}  // namespace gonogo::oracle
