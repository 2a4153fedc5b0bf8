// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diagnostics.hpp"

#include "cli/output.hpp"
#include "oracle/records/text.hpp"
#include "reference/outcome_text.hpp"

namespace gonogo::cli {

void report_alarms(const reference::AlarmReport& report, std::string_view file,
                   std::string_view line) {
  std::string text;
  reference::append_diagnostic(report, oracle::visible(file), line, text);
  complain_each(text);
}

void report_warning(const reference::Warning& warning, std::string_view file,
                    const grammar::Line& line) {
  std::string text;
  reference::append_diagnostic(warning, oracle::visible(file), line, text);
  complain_each(text);
}

void report_not_covered(const reference::NotCovered& outside, std::string_view file,
                        std::string_view line) {
  std::string text;
  reference::append_diagnostic(outside, oracle::visible(file), line, text);
  complain_each(text);
}

void report_further_syntax_errors(grammar::Dialect dialect, grammar::LineSource& lines,
                                  std::string_view file) {
  std::string text;
  reference::append_further_syntax_errors(dialect, lines, oracle::visible(file), text);
  complain_each(text);
}

}  // namespace gonogo::cli
