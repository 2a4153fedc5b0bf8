// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is wrong with an NC program, on standard error: file, line, column, the line itself with a
// caret, and the clause.
#pragma once

#include <string>
#include <string_view>

#include "cli/output.hpp"
#include "oracle/records/text.hpp"
#include "reference/outcome_text.hpp"

namespace gonogo::cli {

// An AlarmReport, a Warning or a NotCovered, with the line of the program that it is about.
template <typename Diagnostic, typename Line>
void report_diagnostic(const Diagnostic& diagnostic, std::string_view file, const Line& line) {
  std::string text;
  reference::append_diagnostic(diagnostic, oracle::visible(file), line, text);
  complain_each(text);
}
// Reads on in check-only mode: the next syntax errors, at most reference::kFurtherSyntaxErrors.
inline void report_further_syntax_errors(grammar::Dialect dialect, grammar::LineSource& lines,
                                         std::string_view file) {
  std::string text;
  reference::append_further_syntax_errors(dialect, lines, oracle::visible(file), text);
  complain_each(text);
}

}  // namespace gonogo::cli
