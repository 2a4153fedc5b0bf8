// SPDX-License-Identifier: GPL-3.0-or-later
//
// A trace in a file, one JSON object a line.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "cli/program_file.hpp"
#include "oracle/judge/judge_session.hpp"

namespace gonogo::cli {

// What the records of a trace have, which decides what is compared.
struct TraceFeatures {
  bool blocks = false;  // line numbers
  bool m = false;       // M functions
  friend bool operator==(const TraceFeatures&, const TraceFeatures&) = default;
};

// What a trace turned out to be.
struct TraceSummary {
  TraceFeatures features;
  oracle::RunEnd end;
};

class RecordedTrace : public oracle::RecordSeries {
 public:
  // "-" is standard input. Throws UsageError.
  explicit RecordedTrace(const std::string& path)
      : file_(path, "a trace, a record a line, or - for standard input") {
    file_.keep();
  }

  // What a look at its bytes says; a guess.
  TraceFeatures likely_features() const;
  // Hands out every record up to the end, to an alarm or to the first line that is at fault; but
  // for lines that `knows`, if given, says true of, which are records with line numbers, and no M
  // functions.
  TraceSummary read(const std::function<void(const reference::Record&)>& take,
                    const std::function<bool(std::string_view)>& knows = {});

  // The records of the last `read`.
  std::size_t size() const override { return records_; }
  void each(const std::function<bool(const reference::Record&)>& take) const override;

 private:
  ProgramFile file_;
  std::size_t records_ = 0;
};

}  // namespace gonogo::cli
