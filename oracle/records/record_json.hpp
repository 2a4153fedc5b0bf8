// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records and alarms from parsed JSON.
#pragma once

#include "oracle/records/json_document.hpp"
#include "oracle/records/trace_reader.hpp"

namespace gonogo::oracle {

// A record, or the alarm that closes a trace. The object's keys are known to be unique.
TraceLine read_trace_line(const simdjson::dom::object& object);

// The alarm of a reply: the same keys without `k`.
std::variant<SubjectAlarm, TraceFault> read_alarm(const simdjson::dom::object& object);

// A number as docs/protocol.md writes it.
std::variant<Number, TraceFault> read_number(std::string_view key,
                                             const simdjson::dom::element& value);

}  // namespace gonogo::oracle
