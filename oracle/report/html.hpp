// SPDX-License-Identifier: GPL-3.0-or-later
//
// The HTML report: one file that opens offline.
#pragma once

#include <optional>
#include <string>

namespace gonogo::oracle::report {

// Why there is no report, a sentence.
struct ReportError {
  std::string message;
};

// Reads a results file line by line and writes `directory`/index.html, in place only when it is
// complete. A results file without footer, or with lines that cannot be read, still makes a page;
// the page says so. Errors: a file that cannot be opened or written, a first line that is not the
// header of format 1.
std::optional<ReportError> write_html_report(const std::string& results,
                                             const std::string& directory);

}  // namespace gonogo::oracle::report
