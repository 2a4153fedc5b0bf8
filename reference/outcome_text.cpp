// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/outcome_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

namespace gonogo::reference {
namespace {

constexpr std::string_view kToolHint =
    "A tool is chosen by T in the program, and the profile says what it is; write there, for "
    "example: tools = {\"1\" = {radius = \"5\"}}\n";

}  // namespace

void append_json(const AlarmReport& report, std::string& out) {
  const Alarm& first = report.alarms.front();
  out +=
      fmt::format("{{\"k\":\"alarm\",\"class\":\"{}\",\"b\":{}", name(first.alarm), report.block);
  if (!first.word.empty()) out += fmt::format(",\"word\":\"{}\"", first.word.text());
  out += fmt::format(",\"clause\":\"{}\"}}", clause_name(first.clause));
}

void append_json(const NotCovered& outside, std::string& out) {
  out += fmt::format("{{\"k\":\"not-covered\",\"b\":{},\"code\":\"{}\"", outside.block,
                     outside.code);
  if (!outside.lacks.empty()) {
    out += fmt::format(",\"lacks\":{}", nlohmann::json(outside.lacks).dump());
  }
  out += '}';
}

void append_diagnostic(const AlarmReport& report, std::string_view file, std::string_view line,
                       std::string& out) {
  std::size_t shown = 0;
  for (const Alarm& alarm : report.alarms) {
    if (++shown > kShownAlarms) {
      out += fmt::format("... and {} more alarms of the block.\n",
                         report.alarms.size() - kShownAlarms);
      break;
    }
    const std::string message = fmt::format("alarm: {} [{}, {}]", alarm.message, name(alarm.alarm),
                                            clause_name(alarm.clause));
    out += grammar::render(message, alarm.where, file, report.block, line);
    if (alarm.alarm == AlarmClass::no_tool) out += kToolHint;
  }
}

void append_diagnostic(const Warning& warning, std::string_view file, const grammar::Line& line,
                       std::string& out) {
  const std::string message = fmt::format("warning: {}", warning.message);
  out += grammar::render(message, warning.where, file, line.number, line.text);
}

void append_diagnostic(const NotCovered& outside, std::string_view file, std::string_view line,
                       std::string& out) {
  const std::string_view kind = outside.lacks.empty() ? "not covered" : "the profile lacks";
  const std::string message = fmt::format("{}: {}", kind, outside.message);
  out += grammar::render(message, outside.where, file, outside.block, line);
  if (!outside.lacks.empty()) out += fmt::format("Write in the profile: {}\n", outside.lacks);
}

void append_further_syntax_errors(grammar::Dialect dialect, grammar::LineSource& lines,
                                  std::string_view file, std::string& out) {
  grammar::Line line;
  grammar::Block block;
  int count = 0;
  while (count < kFurtherSyntaxErrors && lines.next(line)) {
    auto error = line.too_long ? std::optional(grammar::line_too_long())
                               : grammar::parse_block(dialect, line.text, block);
    if (!error) continue;
    out += grammar::render(*error, file, line.number, line.text);
    ++count;
  }
  if (count == kFurtherSyntaxErrors) {
    out += fmt::format("{}: further errors are not shown.\n", file);
  }
}

}  // namespace gonogo::reference
