// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/engine/fuzz_run.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <memory>
#include <system_error>
#include <thread>

#include "corpus/io/files.hpp"
#include "fuzz/engine/engine_process.hpp"
#include "subjects/make_subject.hpp"

namespace gonogo::fuzz {
namespace {

// What engine and subject say goes into the log; with the parent the process ends.
[[noreturn]] void become_engine(const FuzzOptions& options, int log, pid_t parent,
                                SharedPage& page) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(EXIT_FAILURE);
  ::dup2(log, STDOUT_FILENO);
  ::dup2(log, STDERR_FILENO);
  run_engine_here(options, page);
}

int wait_for(pid_t child, const SharedPage& page,
             const std::function<void(const FuzzCount&)>& progress) {
  constexpr std::chrono::milliseconds kPause{100};
  int status = 0;
  for (;;) {
    const pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child) return status;
    if (ended < 0 && errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "waitpid");
    }
    progress(page.count);
    std::this_thread::sleep_for(kPause);
  }
}

std::string last_words(const std::string& log) {
  constexpr std::size_t kMost = 600;
  std::string text = oracle::file_text(log);
  if (text.size() > kMost) text.erase(0, text.size() - kMost);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("The engine's process was ended by signal {} ({}).", WTERMSIG(status),
                       ::strsignal(WTERMSIG(status)));
  }
  return fmt::format("The engine's process ended with exit code {}.", WEXITSTATUS(status));
}

// libFuzzer's own: what a timeout and too much memory end the process with.
constexpr int kTimeoutExit = 70;
constexpr int kMemoryExit = 71;

FuzzEnd::Kind kind_of(int status, FuzzStage stage) {
  if (stage == FuzzStage::departed) return FuzzEnd::Kind::departed;
  if (WIFSIGNALED(status)) {
    const bool is_late = WTERMSIG(status) == SIGALRM;
    return is_late ? FuzzEnd::Kind::too_much : FuzzEnd::Kind::broke_down;
  }
  const int code = WEXITSTATUS(status);
  if (code == 0) return FuzzEnd::Kind::nothing;
  const bool is_too_much = code == kTimeoutExit || code == kMemoryExit;
  return is_too_much ? FuzzEnd::Kind::too_much : FuzzEnd::Kind::broke_down;
}

FuzzEnd end_of(const FuzzOptions& options, int status, const SharedPage& page) {
  FuzzEnd end;
  end.kind = kind_of(status, page.stage);
  end.count = page.count;
  end.how = how_it_ended(status);
  if (end.kind != FuzzEnd::Kind::nothing) end.program = page.noted(options.programs.dialect);
  if (end.kind != FuzzEnd::Kind::nothing && page.stage == FuzzStage::loading) {
    throw oracle::SubjectUnusable(
        fmt::format("{} cannot be loaded into the process of the engine. {}\n{}", options.subject,
                    end.how, last_words(options.log)));
  }
  return end;
}

}  // namespace

FuzzEnd run_fuzz_engine(const FuzzOptions& options,
                        const std::function<void(const FuzzCount&)>& progress) {
  const std::unique_ptr<SharedPage, void (*)(SharedPage*)> page(
      &SharedPage::make(), [](SharedPage* made) { SharedPage::unmap(*made); });
  const int log = ::open(options.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (log < 0) throw std::system_error(errno, std::generic_category(), options.log);
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) become_engine(options, log, parent, *page);
  ::close(log);
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  return end_of(options, wait_for(child, *page, progress), *page);
}

}  // namespace gonogo::fuzz
