// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject that is one process a program: NC text on stdin, records on stdout, and the exit code
// says how it went.
#include <fmt/format.h>

#include <system_error>

#include "oracle/records/json_document.hpp"
#include "oracle/records/record_json.hpp"
#include "oracle/records/text.hpp"
#include "subjects/configuration.hpp"
#include "subjects/private_folder.hpp"
#include "subjects/process.hpp"
#include "subjects/start_reply.hpp"

namespace gonogo::oracle {
namespace {

using Clock = Process::Clock;

// The exit codes of the contract.
constexpr int kExpanded = 0;
constexpr int kAlarm = 1;
constexpr int kUnsupported = 3;

bool is_blank(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

// One process and the program that it runs.
class OneshotRun {
 public:
  OneshotRun(const std::string& command, const std::string& folder, const Limits& limits,
             const RecordSink& sink, JsonDocument& document)
      : folder_(folder),
        limits_(limits),
        sink_(sink),
        document_(document),
        process_(command, limits),
        lines_(limits.line_bytes) {}

  RunEnd run(std::string_view program) {
    const auto begin = Clock::now();
    process_.arm(limits_.run);
    process_.send(std::string(program));
    process_.end_input();
    RunEnd end = read_output();
    if (stopped_ && end.kind != RunEnd::Kind::skip) end = *stopped_;
    end.microseconds =
        std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begin - in_sink_)
            .count();
    process_.kill();
    end.notes = process_.take_notes();
    return end;
  }

 private:
  RunEnd read_output() {
    while (true) {
      const Process::Event event = process_.pump(lines_);
      if (event == Process::Event::deadline) {
        return RunEnd::of(
            RunEnd::Kind::timeout,
            fmt::format("The subject did not end within {} ms.", limits_.run.count()));
      }
      if (event == Process::Event::excess) {
        return RunEnd::of(RunEnd::Kind::out_of_memory,
                          fmt::format("The subject {}.", process_.excess()));
      }
      if (auto end = read_lines()) return *std::move(end);
      if (event == Process::Event::exited) return read_ending();
    }
  }

  // The time that the oracle takes for the records is not the subject's.
  std::optional<RunEnd> read_lines() {
    const auto begin = Clock::now();
    std::optional<RunEnd> end;
    std::size_t records = 0;
    while (!end) {
      const auto line = lines_.next();
      if (!line) break;
      if (is_blank(*line)) continue;
      ++records;
      end = read_line(*line);
    }
    if (!end && lines_.too_long()) {
      end = RunEnd::of(RunEnd::Kind::protocol,
                       fmt::format("A line has more than {} bytes.", limits_.line_bytes));
    }
    if (records > 0) {
      in_sink_ += Clock::now() - begin;
      process_.extend(Clock::now() - begin);
    }
    return end;
  }

  std::optional<RunEnd> read_line(std::string_view text) {
    if (stopped_) return pass_over(text);
    auto parsed = document_.parse(text);
    if (auto* fault = std::get_if<JsonFault>(&parsed)) {
      return RunEnd::of(RunEnd::Kind::protocol, std::move(fault->message));
    }
    if (alarm_) return RunEnd::of(RunEnd::Kind::protocol, "A line came after the alarm.");
    auto line = read_trace_line(std::get<simdjson::dom::object>(parsed));
    if (auto* fault = std::get_if<TraceFault>(&line)) {
      return RunEnd::of(RunEnd::Kind::protocol, std::move(fault->message));
    }
    if (auto* alarm = std::get_if<SubjectAlarm>(&line)) {
      alarm_ = std::move(*alarm);
      return std::nullopt;
    }
    if (!sink_(std::get<reference::Record>(line))) {
      stopped_ = RunEnd::of(RunEnd::Kind::stopped, "The run was stopped.");
    }
    return std::nullopt;
  }

  // J-RUN-05: the sink has seen enough, but the run may end as a skip.
  std::optional<RunEnd> pass_over(std::string_view text) {
    further_ += text.size() + 1;
    return further_ > limits_.further_bytes ? stopped_ : std::nullopt;
  }

  // Only the exits of the contract are answers; everything else is a crash and no rejection.
  RunEnd read_ending() {
    const Ending ending = process_.kill();
    if (ending.signal != 0 ||
        (ending.code != kExpanded && ending.code != kAlarm && ending.code != kUnsupported)) {
      return RunEnd::of(RunEnd::Kind::crash, "The subject " + ending.text() + ".");
    }
    if (ending.code == kUnsupported) {
      RunEnd end = RunEnd::of(RunEnd::Kind::skip, "The subject does not support this.");
      const std::string notes = process_.take_notes();
      if (!notes.empty()) end.message = excerpt(without_folder(notes), 1000);
      return end;
    }
    // The last line may lack its end.
    if (!is_blank(lines_.rest())) {
      const std::string last(lines_.rest());
      if (auto end = read_line(last)) return *std::move(end);
    }
    if (alarm_.has_value() != (ending.code == kAlarm)) {
      return RunEnd::of(RunEnd::Kind::protocol,
                        alarm_ ? "The subject reported an alarm and exited "
                                 "with 0; an alarm exits with 1."
                               : "The subject exited with 1, and its last line "
                                 "is not an alarm.");
    }
    RunEnd end = RunEnd::of(alarm_ ? RunEnd::Kind::alarm : RunEnd::Kind::ok, {});
    if (alarm_) end.alarm = *std::move(alarm_);
    return end;
  }

  // The folder of the profile has another name each time.
  std::string without_folder(std::string text) const {
    const std::string prefix = folder_ + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at)) {
      text.erase(at, prefix.size());
    }
    return text;
  }

  const std::string& folder_;
  const Limits& limits_;
  const RecordSink& sink_;
  JsonDocument& document_;
  Process process_;
  LineBuffer lines_;
  Clock::duration in_sink_{0};
  std::optional<SubjectAlarm> alarm_;
  std::optional<RunEnd> stopped_;  // by the sink
  std::size_t further_ = 0;        // bytes behind that
};

class OneshotSubject : public Subject {
 public:
  OneshotSubject(const std::string& command, const Limits& limits)
      : command_(command), limits_(limits) {
    info_.name = command;
    info_.greeted = false;
    info_.everything = true;
    info_.features = {"blocks", "bytes", "m"};
    limits_.sandbox.bound.push_back(folder_.path());
    describe();
  }
  const SubjectInfo& info() const override { return info_; }

  void configure(const reference::Profile& profile) override {
    Told what = told(info_, profile, limits_.stated);
    silent_ = std::move(what.silent);
    if (!silent_ && !(profile == limits_.stated.of(profile.dialect)) && is_deaf(profile.dialect)) {
      silent_ = RunEnd::of(RunEnd::Kind::refused,
                           "The subject does not read --profile: it goes on where there is no such "
                           "file. The machine of this program is not its own.");
    }
    try {
      const std::string file = folder_.write("profile.json", reference::profile_json(what.profile));
      full_command_ = command_for(profile.dialect, file);
    } catch (const std::system_error& error) {
      throw SubjectUnusable(fmt::format(
          "The profile for the subject cannot be written ({}); set TMPDIR to a folder with room.",
          error.what()));
    }
  }

  RunEnd run(std::string_view, std::string_view program, const RecordSink& sink) override {
    if (full_command_.empty()) {
      return RunEnd::of(RunEnd::Kind::error, "The subject has not been configured.");
    }
    if (silent_) return *silent_;
    try {
      return OneshotRun(full_command_, folder_.path(), limits_, sink, document_).run(program);
    } catch (const std::system_error& error) {
      return RunEnd::of(RunEnd::Kind::error,
                        fmt::format("No process could be started: {}.", error.what()));
    }
  }

  void renew() override {}
  void set_run_limit(std::chrono::milliseconds limit) override { limits_.run = limit; }
  bool keeps_state() const override { return false; }

 private:
  std::string command_for(const std::string& dialect, const std::string& profile) const {
    return fmt::format("{} --dialect {} --profile {}", command_, shell_quoted(dialect),
                       shell_quoted(profile));
  }

  // One that describes itself reads the profile. Another shows by what it does with a file that is
  // not there.
  bool is_deaf(const std::string& dialect) {
    if (info_.greeted) return false;
    if (!deaf_) {
      const std::string command = command_for(dialect, folder_.path() + "/none.json");
      const RecordSink sink = [](const reference::Record&) { return true; };
      deaf_ = OneshotRun(command, folder_.path(), limits_, sink, document_).run("M30\n").kind ==
              RunEnd::Kind::ok;
    }
    return *deaf_;
  }

  // `CMD --describe` may print the reply to `start`. A command that does not know the option may
  // do anything else: then everything is taken as declared.
  void describe() {
    Process process(command_ + " --describe", limits_);
    process.arm(limits_.start);
    process.end_input();
    LineBuffer lines(limits_.line_bytes);
    std::string first;
    const Process::Event event = process.pump_to_end(lines, [&](LineBuffer& come) {
      if (first.empty()) {
        if (auto line = come.next()) first = *line;
      }
      if (!first.empty()) come.clear();
      return !come.too_long();
    });
    if (first.empty()) first = lines.rest();
    const Ending ending = process.kill();
    if (ending.signal == 0 && (ending.code == 126 || ending.code == 127)) {
      throw SubjectUnusable(fmt::format("The command `{}` cannot be run: {}", command_,
                                        excerpt(process.take_notes(), 1000)));
    }
    if (event == Process::Event::exited && ending.signal == 0 && ending.code == 0) {
      read_description(first);
    }
  }

  void read_description(const std::string& line) {
    auto parsed = document_.parse(line);
    auto* object = std::get_if<simdjson::dom::object>(&parsed);
    simdjson::dom::element protocol;
    if (object == nullptr || (*object)["protocol"].get(protocol) != simdjson::SUCCESS) return;
    auto info = read_start_reply(*object);
    if (auto* fault = std::get_if<JsonFault>(&info)) {
      throw SubjectUnusable(
          fmt::format("What `{} --describe` printed cannot be used: {}", command_, fault->message));
    }
    info_ = std::get<SubjectInfo>(std::move(info));
  }

  const std::string command_;
  Limits limits_;
  SubjectInfo info_;
  PrivateFolder folder_;
  std::string full_command_;
  std::optional<RunEnd> silent_;  // of a machine that it does not take
  std::optional<bool> deaf_;      // whether it leaves the profile unread
  JsonDocument document_;
};

}  // namespace

std::unique_ptr<Subject> make_oneshot_subject(const std::string& command, const Limits& limits) {
  try {
    return std::make_unique<OneshotSubject>(command, limits);
  } catch (const std::system_error& error) {
    throw SubjectUnusable(
        fmt::format("The subject `{}` cannot be started: {}.", command, error.what()));
  }
}

}  // namespace gonogo::oracle
