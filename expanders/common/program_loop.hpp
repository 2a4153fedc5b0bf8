// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string_view>

#include "expanders/common/flow.hpp"
#include "expanders/common/tokenizer.hpp"
#include "gonogo/subject.h"

namespace gonogo::expanders {

/// Runs the lines of a program until one does not let it go on. `number` is kept at the line in
/// hand; `run_line(line)` says how it went.
template <typename RunLine>
Flow run_lines(std::string_view program, Counting counting, std::uint64_t& number,
               RunLine run_line) {
  LineReader lines(program, counting);
  std::string_view line;
  while (lines.next(line)) {
    number = lines.number();
    const Flow flow = run_line(line);
    if (flow != Flow::kContinue) return flow;
  }
  return Flow::kContinue;
}

/// Notes that the expander lacks something that the control has; `what` is short.
template <typename Trace>
Flow not_implemented(Trace& trace, std::string_view what) {
  std::array<char, 64> message;
  const int size = std::snprintf(message.data(), message.size(), "%.*s is not implemented.",
                                 static_cast<int>(what.size()), what.data());
  trace.note(GONOGO_NOTE_ERROR, {message.data(), static_cast<std::size_t>(size)});
  return Flow::kUnsupported;
}

/// What `run` of the C interface answers. `send_alarm()` closes the trace of an alarm, `send_end()`
/// any other; it is false when the sink has asked to stop.
template <typename SendAlarm, typename SendEnd>
gonogo_answer close_program(Flow flow, SendAlarm send_alarm, SendEnd send_end) {
  switch (flow) {
    case Flow::kAlarm:
      send_alarm();
      return GONOGO_ALARM;
    case Flow::kUnsupported:
      return GONOGO_UNSUPPORTED;
    case Flow::kStopped:
      return GONOGO_STOPPED;
    case Flow::kContinue:
    case Flow::kEnd:
      break;
  }
  return send_end() ? GONOGO_OK : GONOGO_STOPPED;
}

}  // namespace gonogo::expanders
