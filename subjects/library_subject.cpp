// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/library_subject.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "oracle/records/text.hpp"
#include "subjects/library_file.hpp"
#include "subjects/library_host.hpp"
#include "subjects/process.hpp"

namespace gonogo::oracle {
namespace {

// `exec`: no shell stands between the runner and the library.
std::string host_command(const std::string& program, const std::string& options,
                         const std::string& path) {
  return fmt::format("exec {} host {}-- {}", shell_quoted(program), options, shell_quoted(path));
}

// The subject behind the pipe, with the library's name in what is said of it.
class LibrarySubject : public Subject {
 public:
  LibrarySubject(const std::string& path, const Limits& limits, const std::string& program)
      : name_(std::filesystem::path(path).filename().string()),
        pipe_(make_pipe_subject(host_command(program, "", path), limits)) {}

  const SubjectInfo& info() const override { return pipe_->info(); }
  void configure(const reference::Profile& profile) override { pipe_->configure(profile); }
  void announce(std::string_view id, std::string_view program) override {
    pipe_->announce(id, program);
  }
  void renew() override { pipe_->renew(); }
  // It may be `destroy` that aborts.
  std::optional<RunEnd> finish() override {
    std::optional<RunEnd> end = pipe_->finish();
    if (end) end->message = named(end->message);
    return end;
  }
  void set_run_limit(std::chrono::milliseconds limit) override { pipe_->set_run_limit(limit); }
  bool keeps_state() const override { return pipe_->keeps_state(); }

  RunEnd run(std::string_view id, std::string_view program, const RecordSink& sink) override {
    RunEnd end = pipe_->run(id, program, sink);
    if (end.kind == RunEnd::Kind::error && end.feature == kBrokenInterface) {
      end.kind = RunEnd::Kind::protocol;
      end.message.insert(0, "The C interface is broken: ");
      end.feature.clear();
    }
    switch (end.kind) {
      case RunEnd::Kind::crash:
      case RunEnd::Kind::timeout:
      case RunEnd::Kind::out_of_memory:
      case RunEnd::Kind::protocol:
      case RunEnd::Kind::error:
        end.message = named(end.message);
        break;
      default:
        break;
    }
    return end;
  }

 private:
  std::string named(std::string_view message) const {
    return fmt::format("{}: {}", name_, message);
  }

  std::string name_;
  std::unique_ptr<Subject> pipe_;
};

}  // namespace

void check_library(const std::string& path, const Limits& limits, const std::string& program) {
  const std::string absolute = library_path(path);
  Process process(host_command(program, "--check ", absolute), limits);
  process.arm(limits.start);
  LineBuffer output(std::size_t{1} << 20);
  const Process::Event event = process.pump_to_end(output, [](LineBuffer&) { return true; });
  if (event != Process::Event::exited) {
    throw SubjectUnusable(fmt::format(
        "The library {} was not loaded within {} ms and {} MiB. What it does while it is loaded, "
        "and `describe`, must be short.",
        absolute, limits.start.count(), limits.memory_bytes >> 20));
  }
  const Ending ending = process.kill();
  if (ending.signal == 0 && ending.code == 0) return;
  if (ending.signal == 0 && ending.code == 2 && !output.empty()) {
    throw SubjectUnusable(std::string(output.rest().substr(0, output.rest().find('\n'))));
  }
  const std::string notes = process.take_notes();
  throw SubjectUnusable(fmt::format(
      "The library {} {} while it was loaded and asked to describe itself.{}{} Run `gonogo host "
      "--check {}` to see it.",
      absolute, ending.text(), notes.empty() ? "" : " It wrote on stderr: ", excerpt(notes, 2000),
      shell_quoted(absolute)));
}

std::unique_ptr<Subject> make_library_subject(const std::string& path, const Limits& limits,
                                              const std::string& program) {
  return std::make_unique<LibrarySubject>(library_path(path), limits, program);
}

}  // namespace gonogo::oracle
