// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "oracle/records/subject_outcome.hpp"

namespace gonogo::oracle {

// The lines that an export put before the program, which led the machine to `start`.
struct TraceHeader {
  std::uint64_t lines = 0;
  reference::Position start;
  Number tolerance = 0;  // of the start
};

// The line of an alarm in the case's own program; or that the alarm comes before that program.
void leave_header(SubjectAlarm& alarm, std::uint64_t lines);

// A recorded trace, line by line to the sink: without what belongs to the header, and with the line
// numbers of the case's own program. Without line numbers a header's motions are the leading
// traverses up to the one that ends at the start. Where a header's record comes after the program
// has begun, or the header ends elsewhere, the run ends as `protocol`.
RunEnd read_captured_trace(const std::string& path, const TraceHeader& header,
                           const RecordSink& sink);

}  // namespace gonogo::oracle
