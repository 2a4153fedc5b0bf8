// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records from JSON, by the rules of docs/protocol.md: numbers are strings, roots or
// enclosures; bare numbers, unknown kinds and duplicate keys are refused.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "oracle/records/subject_outcome.hpp"

namespace gonogo::oracle {

// What is wrong with a record, a sentence.
struct TraceFault {
  std::string message;
};

// One line of a trace: a record, or the alarm that closes it.
using TraceLine = std::variant<reference::Record, SubjectAlarm, TraceFault>;

// Reads JSON objects one at a time and keeps its buffers.
class TraceReader {
 public:
  TraceReader();
  ~TraceReader();
  // One JSON object. `line` needs no padding.
  TraceLine read(std::string_view line);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gonogo::oracle
