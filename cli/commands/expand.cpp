// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo expand: the motions of a program, as records, a table, plain codes or a drawing.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/commands.hpp"
#include "cli/diagnostics.hpp"
#include "cli/formats.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/program_file.hpp"
#include "oracle/steps/different_assignments.hpp"
#include "reference/dialect.hpp"

namespace gonogo::cli {
namespace {

constexpr long kMostBlock = 1'000'000'000;

struct ExpandOptions {
  std::string program;
  std::string format = "jsonl";
  long block = 0;  // 0: the first cycle
  ProfileOptions profile;
};

// One run of the reference, shown as it goes on. Where it first asks an open reading, the readings
// to show are looked for; another run goes on with them behind what is shown, which they do not
// change.
class Expansion {
 public:
  Expansion(const ExpandOptions& options, reference::Profile profile, ProgramFile& file)
      : file_(file),
        program_(oracle::ProgramText::of_file(file.descriptor())),
        profile_(std::move(profile)),
        open_(profile_),
        is_settled_(!open_.leaves_open()),
        has_places_(options.format == "svg"),
        format_(make_record_format(options.format, profile_, file.name(),
                                   static_cast<std::uint64_t>(options.block))) {}

  int run() {
    while (!run_through()) {
    }
    format_->finish(output_.text());
    output_.flush();
    return exit_code_;
  }

 private:
  // False: other readings are to be shown.
  bool run_through() {
    oracle::ProgramInput input(program_);
    reference::Expander expander(profile_, input.lines, reference::OpenPaths::shown);
    std::size_t items = 0;
    std::size_t notes = 0;
    const auto is_new_note = [&] {
      const bool is_new = ++notes > noted_;
      noted_ = std::max(noted_, notes);
      return is_new;
    };
    expander.on_warning([&](const reference::Warning& warning, const grammar::Line& line) {
      if (is_new_note()) report_diagnostic(warning, file_.name(), line);
    });
    if (has_places_) {
      expander.on_places([&](std::uint64_t block, const reference::CyclePlaces& places) {
        if (is_new_note()) format_->places(block, places);
      });
    }
    while (const reference::Item* item = expander.next()) {
      if (++items <= shown_) continue;
      if (!is_settled_ && asks_open_now(expander.readings())) {
        is_settled_ = true;
        reference::Profile shown = oracle::profile_to_show(profile_, program_);
        if (shown.readings != profile_.readings) {
          profile_ = std::move(shown);
          return false;
        }
      }
      shown_ = items;
      show(*item, expander, input.lines);
    }
    return true;
  }

  // Looks only when the run has asked for another reading.
  bool asks_open_now(const reference::ReadingsInUse& readings) {
    if (std::exchange(asked_, readings.touched_count()) == readings.touched_count()) return false;
    return oracle::asks_open(open_, readings);
  }

  void show(const reference::Item& item, const reference::Expander& expander,
            grammar::LineSource& lines) {
    if (auto* record = std::get_if<reference::Record>(&item)) {
      format_->record(*record, output_.text());
      return output_.flush_if_large();
    }
    const grammar::Dialect dialect = reference::find_dialect(profile_.dialect)->grammar;
    if (auto* alarms = std::get_if<reference::AlarmReport>(&item)) {
      format_->alarm(*alarms, output_.text());
      output_.flush();
      report_diagnostic(*alarms, file_.name(), expander.failed_line());
      if (alarms->syntax) report_further_syntax_errors(dialect, lines, file_.name());
      exit_code_ = kNoGo;
    } else if (auto* outside = std::get_if<reference::NotCovered>(&item)) {
      format_->not_covered(*outside, output_.text());
      output_.flush();
      report_diagnostic(*outside, file_.name(), expander.failed_line());
      report_further_syntax_errors(dialect, lines, file_.name());
      exit_code_ = kUndecided;
    }
  }

  ProgramFile& file_;
  oracle::ProgramText program_;
  reference::Profile profile_;
  const oracle::AssignmentSet open_;  // before one is chosen
  bool is_settled_;
  bool has_places_;
  std::unique_ptr<RecordFormat> format_;
  Output output_;
  std::size_t asked_ = 0;  // readings by the run
  std::size_t shown_ = 0;  // items
  std::size_t noted_ = 0;  // warnings and places that are shown
  int exit_code_ = kGo;
};

int expand(const ExpandOptions& options) {
  if (options.block != 0 && options.format != "svg") {
    throw UsageError("--block names the points of a cycle in a drawing: add --format svg.");
  }
  ProgramFile file(options.program);
  if (file.size() == 0) {
    throw UsageError(fmt::format("{} is empty. Name a file with an NC program.", file.name()));
  }
  file.keep();
  reference::Profile profile = load_profile(options.profile);
  file.add_called_files(profile.dialect);
  return Expansion(options, std::move(profile), file).run();
}

}  // namespace

void add_expand(Command& program) {
  auto options = std::make_shared<ExpandOptions>();
  Command command = program.add_command("expand", "Write the motions of a program");
  command.needed("program", options->program, "NC program, or - for standard input");
  add_profile_options(command, options->profile);
  command.choice("--format", options->format, {"jsonl", "table", "ngc", "svg"},
                 "jsonl, table, ngc or svg");
  command.number("--block", options->block, 1, kMostBlock,
                 "the line whose cycle has its points named in an svg (the first cycle)");
  command.run([options] { return expand(*options); });
}

}  // namespace gonogo::cli
