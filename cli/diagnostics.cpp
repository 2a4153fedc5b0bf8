// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diagnostics.hpp"
#include "cli/output.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "grammar/parser.hpp"

namespace gonogo::cli {
namespace {

constexpr std::string_view kToolHint =
    "A tool is chosen by T in the program, and the profile says what it is; write there, for "
    "example: tools = {\"1\" = {radius = \"5\"}}\n";

}  // namespace

void report_alarms(const reference::AlarmReport& report, std::string_view file,
                   std::string_view line) {
  constexpr std::size_t kShown = 20;
  std::size_t shown = 0;
  for (const reference::Alarm& alarm : report.alarms) {
    if (++shown > kShown) {
      complain("... and {} more alarms of the block.\n", report.alarms.size() - kShown);
      break;
    }
    const std::string message =
        fmt::format("alarm: {} [{}, {}]", alarm.message, reference::name(alarm.alarm),
                    reference::clause_name(alarm.clause));
    complain("{}", grammar::render(message, alarm.where, file, report.block, line));
    if (alarm.alarm == reference::AlarmClass::no_tool) complain("{}", kToolHint);
  }
}

void report_warning(const reference::Warning& warning, std::string_view file,
                    const grammar::Line& line) {
  const std::string message = fmt::format("warning: {}", warning.message);
  complain("{}", grammar::render(message, warning.where, file, line.number, line.text));
}

void report_not_covered(const reference::NotCovered& outside, std::string_view file,
                        std::string_view line) {
  const std::string_view kind = outside.lacks.empty() ? "not covered" : "the profile lacks";
  const std::string message = fmt::format("{}: {}", kind, outside.message);
  complain("{}", grammar::render(message, outside.where, file, outside.block, line));
  if (!outside.lacks.empty()) complain("Write in the profile: {}\n", outside.lacks);
}

void report_further_syntax_errors(grammar::Dialect dialect, grammar::LineSource& lines,
                                  std::string_view file) {
  grammar::Line line;
  grammar::Block block;
  int count = 0;
  while (count < kFurtherSyntaxErrors && lines.next(line)) {
    auto error = line.too_long ? std::optional(grammar::line_too_long())
                               : grammar::parse_block(dialect, line.text, block);
    if (!error) continue;
    complain("{}", grammar::render(*error, file, line.number, line.text));
    ++count;
  }
  if (count == kFurtherSyntaxErrors) {
    complain("{}: further errors are not shown.\n", file);
  }
}

}  // namespace gonogo::cli
