// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records of the C interface.
#pragma once

#include "gonogo/subject.h"
#include "oracle/records/trace_reader.hpp"

namespace gonogo::oracle {

// Fields that the kind does not use must be empty: nothing is ignored.
std::variant<reference::Record, TraceFault> convert_record(const gonogo_record_v1& source);
// What is wrong with a record apart from what its texts say: sizes, kinds, fields, doubles.
std::optional<TraceFault> form_fault(const gonogo_record_v1& source);
std::variant<SubjectAlarm, TraceFault> convert_alarm(const gonogo_alarm_v1& source);

// A record as the pipe protocol writes it. Numbers go out as they came: texts unchanged, doubles as
// integers or hexadecimal floats. REQUIRES: !form_fault(source).
void append_json(const gonogo_record_v1& source, std::string& out);
// The alarm of a reply.
void append_json(const SubjectAlarm& alarm, std::string& out);

// The bytes of a text; empty when its pointer is null.
std::string_view view(const gonogo_text& text);

}  // namespace gonogo::oracle
