// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo expand: the motions of a program, as records, a table, plain codes or a drawing.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "cli/exit_code.hpp"
#include "cli/formats.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "oracle/judge/shown_readings.hpp"
#include "reference/dialect.hpp"

namespace gonogo::cli {
namespace {

struct ExpandOptions {
  std::string program;
  std::string format = "jsonl";
  ProfileOptions profile;
};

void warn_about_empty_program(const ProgramFile& file) {
  if (file.size() == 0) {
    throw UsageError(fmt::format("{} is empty. Name a file with an NC program.", file.name()));
  }
}

int expand(const ExpandOptions& options) {
  reference::Profile profile = load_profile(options.profile);
  const grammar::Dialect dialect = reference::find_dialect(profile.dialect)->grammar;
  ProgramFile file(options.program);
  warn_about_empty_program(file);
  file.keep();
  profile = oracle::profile_to_show(profile, oracle::ProgramText::of_file(file.descriptor()));
  grammar::LineSource lines(file.bytes());
  reference::Expander expander(profile, lines, reference::OpenPaths::shown);
  expander.on_warning([&file](const reference::Warning& warning, const grammar::Line& line) {
    report_warning(warning, file.name(), line);
  });
  Output output;
  std::unique_ptr<RecordFormat> format = make_record_format(options.format, profile, file.name());
  if (options.format == "svg") {
    expander.on_places([&](std::uint64_t block, const reference::CyclePlaces& places) {
      format->places(block, places);
    });
  }
  int exit_code = kGo;
  while (const reference::Item* item = expander.next()) {
    if (auto* record = std::get_if<reference::Record>(item)) {
      format->record(*record, output.text());
      output.flush_if_large();
    } else if (auto* alarms = std::get_if<reference::AlarmReport>(item)) {
      format->alarm(*alarms, output.text());
      output.flush();
      report_alarms(*alarms, file.name(), expander.failed_line());
      if (alarms->syntax) report_further_syntax_errors(dialect, lines, file.name());
      exit_code = kNoGo;
    } else if (auto* outside = std::get_if<reference::NotCovered>(item)) {
      format->not_covered(*outside, output.text());
      output.flush();
      report_not_covered(*outside, file.name(), expander.failed_line());
      report_further_syntax_errors(dialect, lines, file.name());
      exit_code = kUndecided;
    }
  }
  format->finish(output.text());
  output.flush();
  return exit_code;
}

}  // namespace

void add_expand(Command& program) {
  auto options = std::make_shared<ExpandOptions>();
  Command command = program.add_command("expand", "Write the motions of a program");
  command.argument("program", options->program, "NC program, or - for standard input");
  add_profile_options(command, options->profile);
  command.choice("--format", options->format, {"jsonl", "table", "ngc", "svg"},
                 "jsonl, table, ngc or svg");
  command.run([options] { return expand(*options); });
}

}  // namespace gonogo::cli
