// SPDX-License-Identifier: GPL-3.0-or-later
//
// How an outcome is written: the line of JSON that closes a trace (docs/protocol.md), and the
// message for people: file, line, column, the line itself with a caret, and the clause.
#pragma once

#include <string>
#include <string_view>

#include "grammar/line_source.hpp"
#include "grammar/parser.hpp"
#include "reference/outcome.hpp"

namespace gonogo::reference {

// Append an object without the end of the line.
void append_json(const AlarmReport& report, std::string& out);
void append_json(const NotCovered& outside, std::string& out);

// Append whole lines. `file` names the program, `line` is the text of the line at fault. For an
// alarm report the first alarms, at most kShownAlarms.
inline constexpr std::size_t kShownAlarms = 20;
void append_diagnostic(const AlarmReport& report, std::string_view file, std::string_view line,
                       std::string& out);
void append_diagnostic(const Warning& warning, std::string_view file, const grammar::Line& line,
                       std::string& out);
void append_diagnostic(const NotCovered& outside, std::string_view file, std::string_view line,
                       std::string& out);

// Reads on in check-only mode: the next syntax errors, at most kFurtherSyntaxErrors.
inline constexpr int kFurtherSyntaxErrors = 20;
void append_further_syntax_errors(grammar::Dialect dialect, grammar::LineSource& lines,
                                  std::string_view file, std::string& out);

}  // namespace gonogo::reference
