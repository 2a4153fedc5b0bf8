// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records of the C interface.
#pragma once

#include "gonogo/subject.h"
#include "oracle/trace_reader.hpp"

namespace gonogo::oracle {

// Fields that the kind does not use must be empty: nothing is ignored.
std::variant<reference::Record, TraceFault> convert_record(const gonogo_record_v1& source);
std::variant<SubjectAlarm, TraceFault> convert_alarm(const gonogo_alarm_v1& source);

// The bytes of a text; empty when its pointer is null.
std::string_view view(const gonogo_text& text);

}  // namespace gonogo::oracle
