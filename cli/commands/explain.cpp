// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo explain: each motion with the clause that it comes from, in words.
#include <fmt/format.h>

#include <optional>

#include "cli/called_files.hpp"
#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "oracle/judge/cycle_time.hpp"
#include "oracle/records/run_scope.hpp"
#include "oracle/steps/different_assignments.hpp"
#include "publish/manual/motion_text.hpp"
#include "reference/expander.hpp"

namespace gonogo::cli {
namespace {

constexpr long kMostLines = 1'000'000'000;

struct ExplainOptions {
  std::string program;
  ProfileOptions profile;
  long block = 0;  // 0: all
};

// The lines of a program by their numbers, in one walk where these only rise.
class NumberedLines {
 public:
  explicit NumberedLines(std::string_view program) : program_(program) { rewind(); }

  // Its beginning; nothing: there is none of that number.
  std::optional<std::string_view> line(std::uint64_t number) {
    if (number < line_.number) rewind();
    while (line_.number < number) {
      if (!lines_->next(line_)) return std::nullopt;
    }
    return line_.text.substr(0, 200);
  }
  // The number of the line read last.
  std::uint64_t number() const { return line_.number; }

 private:
  void rewind() {
    bytes_.emplace(program_);
    lines_.emplace(*bytes_);
    line_ = {};
  }

  std::string_view program_;
  std::optional<grammar::MemorySource> bytes_;
  std::optional<grammar::LineSource> lines_;
  grammar::Line line_;
};

void check_block(NumberedLines& lines, long block) {
  if (block == 0 || lines.line(static_cast<std::uint64_t>(block))) return;
  throw UsageError(fmt::format("--block {}: the program has {} lines.", block, lines.number()));
}

class Explanation {
 public:
  Explanation(const reference::Profile& profile, NumberedLines& lines)
      : lines_(lines), choice_(profile.readings.shown()), texts_(profile.initial.at) {}

  bool empty() const { return block_ == 0; }
  void note(const reference::Warning& warning, std::uint64_t line, std::string& out) {
    begin(line, out);
    out += fmt::format("  note: {}\n", warning.message);
  }
  // `decided_by`: the readings that mattered since the last record.
  void record(const reference::Record& record, const std::vector<reference::ReadingKey>& decided_by,
              std::string& out) {
    if (record.block != 0) begin(record.block, out);
    if (record.clause != clause_ && record.clause != reference::kNoClause) {
      clause_ = record.clause;
      const reference::Clause& clause = reference::clause(clause_);
      out += fmt::format("  {} ({}): {}\n", clause.id, reference::name(clause.level), clause.text);
    }
    for (const reference::ReadingKey key : decided_by) {
      const reference::Reading& reading = reference::reading(key);
      out += fmt::format("    reading {}={}: {}\n", reading.name, choice_.get(key), reading.text);
    }
    out += fmt::format("    {}\n", texts_.next(record));
  }
  // One that is not shown.
  void pass(const reference::Record& record) { texts_.pass(record); }
  void rename(const reference::Position& shift) { texts_.rename(shift); }

 private:
  void begin(std::uint64_t line, std::string& out) {
    if (line == block_) return;
    block_ = line;
    clause_ = reference::kNoClause;
    out += fmt::format("\nline {}: {}\n", block_, lines_.line(block_).value_or(""));
  }

  NumberedLines& lines_;
  reference::ReadingChoice choice_;  // as it is shown
  oracle::manual::MotionTexts texts_;
  std::uint64_t block_ = 0;
  reference::ClauseId clause_ = reference::kNoClause;
};

// What of the times there is; empty: nothing moves or waits.
std::string times_of(const oracle::CycleTime& time) {
  std::string text;
  for (const oracle::TimePart& part : oracle::parts_of(time)) {
    if (part.amount != 0) {
      text += fmt::format("  {:<9}  {}\n", part.what, oracle::amount_text(part));
    }
  }
  if (time.left_out() != 0) {
    text += fmt::format("  without {} of rotary axes, or askew in space\n",
                        oracle::counted(time.left_out(), "motion", "motions"));
  }
  return text.empty() ? text : "\ntimes\n" + text;
}

int explain(const ExplainOptions& options) {
  std::string program = read_file(options.program);
  if (program.empty()) throw UsageError(options.program + " is empty.");
  const reference::Profile machine = load_profile(options.profile);
  add_called_files(machine.dialect, options.program, program);
  const reference::Profile profile = oracle::profile_to_show(machine, program);
  NumberedLines numbered(program);
  check_block(numbered, options.block);
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::shown);
  Explanation explanation(profile, numbered);
  oracle::CycleTime time(profile.initial.at);
  Output output;
  const auto is_shown = [&](std::uint64_t line) {
    return options.block == 0 || line == static_cast<std::uint64_t>(options.block);
  };
  expander.on_warning([&](const reference::Warning& warning, const grammar::Line& line) {
    if (is_shown(line.number)) explanation.note(warning, line.number, output.text());
  });
  int exit_code = kGo;
  while (const reference::Item* item = expander.next()) {
    if (auto* record = std::get_if<reference::Record>(item)) {
      const auto decided_by = expander.take_touched_readings();
      if (!is_shown(record->block)) {
        time.leave_out(*record);
        explanation.pass(*record);
        continue;
      }
      time.take(*record);
      explanation.record(*record, decided_by, output.text());
      output.flush_if_large();
    } else if (auto* renaming = std::get_if<reference::Renaming>(item)) {
      time.rename(renaming->shift);
      explanation.rename(renaming->shift);
    } else if (auto* alarms = std::get_if<reference::AlarmReport>(item)) {
      output.tell();
      report_diagnostic(*alarms, options.program, expander.failed_line());
      exit_code = kNoGo;
    } else if (auto* outside = std::get_if<reference::NotCovered>(item)) {
      output.tell();
      report_diagnostic(*outside, options.program, expander.failed_line());
      exit_code = kUndecided;
    }
  }
  if (options.block != 0 && exit_code == kGo && explanation.empty()) {
    output.text() +=
        fmt::format("\nline {}: {}\n  no motion comes from it\n", options.block,
                    numbered.line(static_cast<std::uint64_t>(options.block)).value_or(""));
  }
  output.text() += times_of(time);
  output.tell();
  return exit_code;
}

}  // namespace

void add_explain(Command& program) {
  auto options = std::make_shared<ExplainOptions>();
  Command command =
      program.add_command("explain", "Show each motion of a program with the clause it comes from");
  command.needed("program", options->program, "NC program, or - for standard input");
  add_profile_options(command, options->profile);
  command.number("--block", options->block, 1, kMostLines, "only this line of the program");
  command.run([options] { return explain(*options); });
}

}  // namespace gonogo::cli
