// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo judge: one program and one outcome, recorded or run now.
#include <fmt/format.h>

#include <limits>

#include "cli/called_files.hpp"
#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "cli/recorded_trace.hpp"
#include "cli/subjects.hpp"
#include "cli/times_text.hpp"
#include "cli/trial_options.hpp"
#include "cli/verdict_text.hpp"
#include "fuzz/hunt/judged_sheet.hpp"
#include "fuzz/hunt/trial.hpp"
#include "fuzz/program/in_force.hpp"
#include "oracle/judge/judge_session.hpp"
#include "oracle/records/output_file.hpp"
#include "oracle/records/text.hpp"
#include "oracle/relation/definition.hpp"
#include "publish/report/command.hpp"

namespace gonogo::cli {
namespace {

struct JudgeOptions {
  std::string program;
  std::string trace;
  std::string subject;
  std::string alarm_map;
  std::string numeric;
  std::string resolution;
  std::string sheet;
  bool time = false;
  bool rounding = false;
  bool by_definition = false;
  ProfileOptions profile;
  LimitOptions limits;
};

oracle::Tolerances tolerances_for(const TraceFeatures& features, const JudgeOptions& options,
                                  const reference::Profile& profile) {
  oracle::SubjectInfo subject;
  if (features.blocks) subject.features.insert("blocks");
  if (features.m) subject.features.insert("m");
  subject.resolution = length_option(options.resolution, "--resolution");
  if (subject.resolution) subject.numeric_kind = "fixed";
  if (!options.numeric.empty()) subject.numeric_kind = options.numeric;
  subject.says_numeric = subject.resolution || !options.numeric.empty();
  return make_tolerances(subject, profile, options.limits.grants());
}

// The end of a trace, its alarm under the names of the gauge.
oracle::RunEnd end_of(const TraceSummary& seen, const JudgeOptions& options) {
  oracle::RunEnd end = seen.end;
  if (const auto alarms = load_alarm_map(options.alarm_map)) alarms->name_class(end);
  return end;
}

void check_numeric(const std::string& kind) {
  if (kind.empty() || kind == "fixed" || kind == "binary64" || kind == "exact") return;
  throw UsageError(fmt::format("--numeric takes fixed, binary64 or exact, not \"{}\".", kind));
}

// The whole trace, its records into the session as far as that is undecided.
TraceSummary read_into(oracle::JudgeSession& session, RecordedTrace& trace) {
  bool undecided = true;
  return trace.read(
      [&](const reference::Record& record) {
        if (undecided) undecided = session.record(record);
      },
      [&](std::string_view line) { return session.line(line); });
}

// A trace that cannot be read on, as one of `expand` at what is not covered: where the program is
// not covered behind its records, that is the verdict.
std::optional<oracle::SessionVerdict> judged_as_outside(const reference::Profile& profile,
                                                        const oracle::ProgramText& program,
                                                        const oracle::Tolerances& tolerances,
                                                        RecordedTrace& trace) {
  oracle::JudgeSession session(profile, program, tolerances);
  read_into(session, trace);
  oracle::SessionVerdict said = session.finish(oracle::RunEnd{});
  const bool is_outside = said.verdict.gap == oracle::GapReason::not_covered ||
                          said.verdict.gap == oracle::GapReason::profile_lacks;
  if (said.verdict.kind != oracle::VerdictKind::oracle_gap || !is_outside) return std::nullopt;
  return said;
}

// What a trace has decides what is compared, and is known for certain only at its end: where the
// guess was wrong, the trace is judged once more.
oracle::SessionVerdict judge_trace(const JudgeOptions& options, const reference::Profile& profile,
                                   const oracle::ProgramText& program, RecordedTrace& trace,
                                   TraceFeatures& features) {
  features = trace.likely_features();
  for (;;) {
    const oracle::Tolerances tolerances = tolerances_for(features, options, profile);
    oracle::JudgeSession session(profile, program, tolerances);
    const TraceSummary seen = read_into(session, trace);
    if (seen.features != features) {
      features = seen.features;
      continue;
    }
    const oracle::RunEnd end = end_of(seen, options);
    if (end.kind == oracle::RunEnd::Kind::protocol) {
      if (auto outside = judged_as_outside(profile, program, tolerances, trace)) return *outside;
    }
    oracle::SessionVerdict said = session.finish(end);
    const bool departs = decision(said.verdict.kind) == oracle::Decision::no_go ||
                         said.verdict.kind == oracle::VerdictKind::advice;
    if (departs) {
      said.verdict.reading = explaining_reading(profile, program, tolerances, trace, end);
    }
    return said;
  }
}

// What a trace lacks was not looked at.
std::string not_compared_text(const TraceFeatures& features) {
  std::string text;
  if (!features.blocks) text += "  Lines were not compared: no record of the trace has \"b\".\n";
  if (!features.m) text += "  M functions were not compared: the trace has none.\n";
  return text;
}

// The same tolerances, for the definition of the relation (docs/relation.md).
relation::Tolerances tolerances_of_definition(const oracle::Tolerances& tolerances,
                                              const JudgeOptions& options,
                                              const reference::Profile& profile) {
  relation::Tolerances same;
  same.tolerance = tolerances.tolerance;
  same.increment = profile.resolution();
  same.chord = tolerances.chord;
  same.resolution = tolerances.resolution;
  same.feed_resolution = tolerances.feed_resolution;
  same.binary64 = tolerances.binary64;
  same.exact = options.numeric == "exact";
  same.compare_blocks = tolerances.compare_blocks;
  same.compare_m = tolerances.compare_m;
  same.strict = tolerances.strict;
  return same;
}

// Whether the answer to the records that can be read does not depend on what follows them.
bool stands_before(const relation::Answer& answer, std::size_t records) {
  if (answer.gap == relation::GapReason::not_covered ||
      answer.gap == relation::GapReason::profile_lacks) {
    return true;
  }
  return decision(answer.kind) == oracle::Decision::no_go &&
         answer.record.value_or(records) < records;
}

int judge_by_definition(const JudgeOptions& options, const reference::Profile& profile,
                        const oracle::ProgramText& program, RecordedTrace& trace) {
  std::vector<reference::Record> records;
  const TraceSummary seen =
      trace.read([&](const reference::Record& record) { records.push_back(record); });
  const relation::Tolerances tolerances =
      tolerances_of_definition(tolerances_for(seen.features, options, profile), options, profile);
  const oracle::RunEnd end = end_of(seen, options);
  const bool alarms = end.kind == oracle::RunEnd::Kind::alarm;
  relation::Answer answer = relation::decide(profile, read_all(*program.open(), options.program),
                                             tolerances, {records, alarms ? &end.alarm : nullptr});
  if (end.kind == oracle::RunEnd::Kind::protocol && !stands_before(answer, records.size())) {
    answer = {};
    answer.kind = oracle::VerdictKind::protocol;
    answer.message = end.message;
  }
  Output output;
  output.text() = answer_text(answer) + not_compared_text(seen.features);
  output.tell();
  oracle::Verdict verdict;
  verdict.kind = answer.kind;
  return exit_code_of(verdict);
}

// The command that shows where the motions of the block come from.
std::string explaining(const JudgeOptions& options, const std::string& dialect,
                       std::uint64_t block) {
  using oracle::shell_quoted;
  if (options.program == "-") return {};
  std::string command = fmt::format("{} explain {} --dialect {}", oracle::report::program_word(),
                                    shell_quoted(options.program), dialect);
  if (!options.profile.file.empty()) command += " --profile " + shell_quoted(options.profile.file);
  for (const std::string& reading : options.profile.readings) {
    command += " --reading " + shell_quoted(reading);
  }
  return block == 0 ? command : fmt::format("{} --block {}", command, block);
}

// Its beginning: a byte more than what a person reads.
std::string begin_of(const oracle::ProgramText& program) {
  constexpr std::size_t kMost = program::kLongestShown + 1;
  std::string text(kMost, '\0');
  const auto bytes = program.open();
  std::size_t size = 0;
  while (const std::size_t more = bytes->read(text.data() + size, kMost - size)) size += more;
  text.resize(size);
  return text;
}

std::string told(const JudgeOptions& options, const reference::Profile& profile,
                 const oracle::ProgramText& program, const oracle::Verdict& verdict) {
  oracle::FindingFacts facts = oracle::finding_facts(verdict);
  facts.profile = reference::profile_json(profile);
  const std::uint64_t line = facts.block.value_or(0);
  facts.blocks = oracle::marked_blocks(*program.open(), line);
  if (decision(verdict.kind) != oracle::Decision::go) {
    facts.in_force = program::in_force_text(profile, begin_of(program), line);
  }
  facts.next = explaining(options, profile.dialect, line);
  return verdict_text(verdict, std::move(facts));
}

void draw(const JudgeOptions& options, const reference::Profile& profile, std::string program,
          const oracle::Verdict& verdict, const std::vector<reference::Record>& records) {
  const hunt::JudgedSheet sheet =
      hunt::judged_sheet({profile, options.program, std::move(program), verdict, records});
  if (sheet.svg.empty()) throw UsageError("--sheet: " + sheet.note);
  oracle::write_file(options.sheet, sheet.svg);
}

// The first records of a trace, as many as a drawing shows.
std::vector<reference::Record> drawn_records(const RecordedTrace& trace) {
  constexpr std::size_t kMostDrawn = 20'000;
  std::vector<reference::Record> records;
  trace.each([&](const reference::Record& record) {
    records.push_back(record);
    return records.size() < kMostDrawn;
  });
  return records;
}

// The subject runs the program now, and its own description says what is compared.
int judge_subject(const JudgeOptions& options, const reference::Profile& profile) {
  TrialWords words{options.subject, options.alarm_map, {}, options.limits};
  words.limits.stated.profile = profile;
  hunt::TrialOptions of_trial = trial_options(words);
  of_trial.most_records = std::numeric_limits<std::size_t>::max();
  hunt::Trial trial(trial_subject(words), std::move(of_trial));
  check_dialect(trial.info(), profile.dialect);
  std::string program = read_file(options.program);
  add_called_files(profile.dialect, options.program, program);
  const hunt::JudgedRun run = trial.examine({{}, {profile, program}});
  using Kind = oracle::RunEnd::Kind;
  if (run.end.kind == Kind::skip || run.end.kind == Kind::refused) {
    throw UsageError(fmt::format("The subject does not run it: {}", run.end.message));
  }
  if (!options.sheet.empty()) draw(options, profile, program, run.verdict, run.records);
  Output output;
  output.text() = told(options, profile, program, run.verdict);
  output.tell();
  return exit_code_of(run.verdict);
}

int judge(const JudgeOptions& options) {
  check_numeric(options.numeric);
  const reference::Profile profile = load_profile(options.profile);
  if (options.subject.empty() == options.trace.empty()) {
    throw UsageError(
        "Name what is judged: --trace FILE, a recorded outcome, or --subject S, which runs the "
        "program now.");
  }
  if (!options.subject.empty()) return judge_subject(options, profile);
  if (options.program == "-" && options.trace == "-") {
    throw UsageError("Only one of program and trace can come from standard input.");
  }
  if (options.by_definition && !options.sheet.empty()) {
    throw UsageError("--sheet draws what the judge says: leave --by-definition out.");
  }
  ProgramFile program(options.program);
  program.keep();
  program.add_called_files(profile.dialect);
  const auto text = oracle::ProgramText::of_file(program.descriptor());
  RecordedTrace trace(options.trace);
  if (options.by_definition) {
    return judge_by_definition(options, profile, text, trace);
  }
  TraceFeatures features;
  const oracle::SessionVerdict session = judge_trace(options, profile, text, trace, features);
  if (!options.sheet.empty()) {
    draw(options, profile, read_all(*text.open(), options.program), session.verdict,
         drawn_records(trace));
  }
  Output output;
  output.text() = told(options, profile, text, session.verdict);
  if (session.verdict.kind != oracle::VerdictKind::protocol)
    output.text() += not_compared_text(features);
  if (options.time) output.text() += times_text(profile, program, trace);
  if (options.rounding) {
    const auto& compared = session.verdict.coordinates;
    output.text() += compared
                         ? fmt::format("coordinates: {}\n", compared->text())
                         : rounding_text(profile, program, trace,
                                         tolerances_for(trace.likely_features(), options, profile));
  }
  output.tell();
  return exit_code_of(session.verdict);
}

}  // namespace

void add_judge(Command& program) {
  auto options = std::make_shared<JudgeOptions>();
  Command command = program.add_command("judge", "Judge one outcome of one program");
  command.needed("program", options->program, "NC program, or - for standard input");
  command.option("--trace", options->trace, "records as JSON lines, or - for standard input");
  command.option("--subject", options->subject, "or who runs the program now: as for certify");
  command.option("--alarm-map", options->alarm_map, "TOML file of what its own alarms mean");
  command.option("--numeric", options->numeric,
                 "how the trace's numbers were computed: fixed, binary64 or exact");
  command.option("--resolution", options->resolution,
                 "what the trace's lengths were rounded to, mm, a decimal");
  command.option("--sheet", options->sheet, "file for a drawing of both paths, SVG");
  command.flag("--time", options->time,
               "also tell times of cuts and dwells, and how far traverses go");
  command.flag("--rounding", options->rounding, "also tell how coordinates are rounded");
  command.flag("--by-definition", options->by_definition,
               "judge by the definition itself, slowly, and tell which of its rules is broken");
  add_profile_options(command, options->profile);
  add_run_options(command, options->limits);
  add_sandbox_options(command, options->limits.sandbox, "off");
  add_strict_option(command, options->limits);
  command.needs({"--timeout", "--memory", "--env", "--sandbox", "--bind"}, "--subject");
  command.needs({"--numeric", "--resolution", "--time", "--rounding", "--by-definition"},
                "--trace");
  command.run([options] { return judge(*options); });
}

}  // namespace gonogo::cli
