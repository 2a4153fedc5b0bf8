// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/pdf.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>
#include <vector>

#include "cli/output.hpp"
#include "cli/program_file.hpp"


namespace gonogo::cli {
namespace {

namespace fs = std::filesystem;

std::string browser() {
  if (const char* named = std::getenv("GONOGO_CHROMIUM"); named != nullptr && *named != '\0') {
    return named;
  }
  const char* path = std::getenv("PATH");
  const std::string folders = path == nullptr ? "/usr/bin" : path;
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    for (std::size_t from = 0; from <= folders.size();) {
      const std::size_t end = std::min(folders.find(':', from), folders.size());
      const std::string program = folders.substr(from, end - from) + "/" + name;
      if (::access(program.c_str(), X_OK) == 0) return program;
      from = end + 1;
    }
  }
  throw UsageError(
      "--pdf needs an installed Chromium, and there is none in the path. Install the package "
      "chromium, or name the program in GONOGO_CHROMIUM; or print index.html from any browser.");
}

// A page as a URL: what is no plain character of a path in percents.
std::string url_of(const fs::path& file) {
  std::string url = "file://";
  for (const char c : fs::absolute(file).string()) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       std::string_view("/._-~").find(c) != std::string_view::npos;
    url += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url + "#print";
}

// Runs a program with its output thrown away; false: it failed, or took too long.
bool run(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failed = ::posix_spawn(&child, argv[0], &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) return false;
  constexpr auto kLimit = std::chrono::minutes(2);
  const auto start = std::chrono::steady_clock::now();
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() - start > kLimit) {
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

void print_pdf(const std::string& page, const std::string& pdf) {
  const std::string program = browser();
  std::string profile = (fs::temp_directory_path() / "gonogo-pdf-XXXXXX").string();
  if (::mkdtemp(profile.data()) == nullptr) {
    throw OutputError(fmt::format("{} cannot be made.", profile), false);
  }
  const std::string part = profile + "/report.pdf";
  std::vector<std::string> words = {program,
                                    "--headless",
                                    "--disable-gpu",
                                    "--no-first-run",
                                    "--disable-background-networking",
                                    "--user-data-dir=" + profile,
                                    "--no-pdf-header-footer",
                                    "--print-to-pdf=" + part};
  if (::geteuid() == 0) words.emplace_back("--no-sandbox");  // it refuses to start as root with it
  words.push_back(url_of(page));
  const bool done = run(words);
  std::error_code failure;
  if (done) fs::copy_file(part, pdf, fs::copy_options::overwrite_existing, failure);
  std::error_code ignored;
  fs::remove_all(profile, ignored);
  if (!done || failure) {
    throw OutputError(
        fmt::format("{} could not be written with {}.{}", pdf, program,
                    failure ? " " + failure.message() : " Print index.html from a browser."),
        false);
  }
}

}  // namespace gonogo::cli
