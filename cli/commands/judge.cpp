// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo judge: one program and one recorded outcome.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/exit_code.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/verdict_text.hpp"
#include "oracle/judge/judge_session.hpp"
#include "oracle/trace_reader.hpp"

namespace gonogo::cli {
namespace {

struct JudgeOptions {
  std::string program;
  std::string trace;
  std::string resolution;
  ProfileOptions profile;
  LimitOptions limits;
};

// A trace as far as the judge wants to see it.
struct Trace {
  std::vector<reference::Record> records;
  oracle::RunEnd end;
  bool has_blocks = false;
  bool has_m = false;
};

void take_line(std::string_view line, std::uint64_t number, oracle::TraceReader& reader,
               Trace& trace) {
  if (line.find_first_not_of(" \t") == std::string_view::npos) return;
  oracle::TraceLine read = reader.read(line);
  if (auto* fault = std::get_if<oracle::TraceFault>(&read)) {
    trace.end.kind = oracle::RunEnd::Kind::protocol;
    trace.end.message = fmt::format("Line {} of the trace: {}", number, fault->message);
  } else if (auto* alarm = std::get_if<oracle::SubjectAlarm>(&read)) {
    trace.end.kind = oracle::RunEnd::Kind::alarm;
    trace.end.alarm = *alarm;
  } else {
    trace.records.push_back(std::get<reference::Record>(std::move(read)));
    trace.has_blocks = trace.has_blocks || trace.records.back().block != 0;
    trace.has_m = trace.has_m || trace.records.back().kind == reference::RecordKind::m;
  }
}

// The file is read as long as no line is at fault and no alarm has closed it.
Trace read_trace(const std::string& path) {
  ProgramFile file(path);
  grammar::LineSource lines(file.bytes());
  grammar::Line line;
  oracle::TraceReader reader;
  Trace trace;
  while (lines.next(line)) {
    if (trace.end.kind == oracle::RunEnd::Kind::alarm &&
        line.text.find_first_not_of(" \t") != std::string_view::npos) {
      trace.end.kind = oracle::RunEnd::Kind::protocol;
      trace.end.message =
          fmt::format("Line {} of the trace follows the alarm that closes it.", line.number);
    }
    if (trace.end.kind != oracle::RunEnd::Kind::ok) break;
    take_line(line.text, line.number, reader, trace);
  }
  return trace;
}

int judge(const JudgeOptions& options) {
  const reference::Profile profile = load_profile(options.profile);
  if (options.program == "-" && options.trace == "-") {
    throw UsageError("Only one of program and trace can come from standard input.");
  }
  const std::string program = read_file(options.program);
  const Trace trace = read_trace(options.trace);
  oracle::SubjectInfo subject;
  if (trace.has_blocks) subject.features.insert("blocks");
  if (trace.has_m) subject.features.insert("m");
  subject.resolution = length_option(options.resolution, "--resolution");
  if (subject.resolution) subject.numeric_kind = "fixed";
  const oracle::JudgeTerms terms =
      make_terms(subject, profile, length_option(options.limits.tolerance, "--tolerance"),
                 length_option(options.limits.chord, "--chord"));
  oracle::SessionVerdict session = judge_outcome(profile, program, terms, trace.records, trace.end);
  if (decision(session.verdict.kind) == oracle::Decision::no_go) {
    session.verdict.reading = explaining_reading(profile, program, terms, trace.records, trace.end);
  }
  Output output;
  output.text() = verdict_text(session.verdict);
  output.flush();
  return exit_code_of(session.verdict);
}

}  // namespace

void add_judge(Command& program) {
  auto options = std::make_shared<JudgeOptions>();
  Command command = program.add_command("judge", "Judge one recorded outcome of one program");
  command.argument("program", options->program, "NC program, or - for standard input");
  command.needed_option("--trace", options->trace,
                        "records as JSON lines, or - for standard input");
  command.option("--resolution", options->resolution,
                 "what the trace's lengths were rounded to, mm, a decimal");
  add_profile_options(command, options->profile);
  add_limit_options(command, options->limits);
  command.run([options] { return judge(*options); });
}

}  // namespace gonogo::cli
