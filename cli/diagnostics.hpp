// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with an NC program, on standard error: file, line, column, the line itself with a
// caret, and the clause.
#pragma once

#include <string_view>

#include "grammar/line_source.hpp"
#include "reference/outcome.hpp"

namespace gonogo::cli {

void report_alarms(const reference::AlarmReport& report, std::string_view file,
                   std::string_view line);
void report_warning(const reference::Warning& warning, std::string_view file,
                    const grammar::Line& line);
void report_not_covered(const reference::NotCovered& outside, std::string_view file,
                        std::string_view line);
// Reads on in check-only mode: the next syntax errors, at most reference::kFurtherSyntaxErrors.
void report_further_syntax_errors(grammar::Dialect dialect, grammar::LineSource& lines,
                                  std::string_view file);

}  // namespace gonogo::cli
