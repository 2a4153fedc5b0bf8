// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records, levels, alarms and points as the texts of a verdict.
#pragma once

#include <string>

#include "oracle/region/level.hpp"
#include "oracle/subject.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle {

std::string record_text(const reference::Record& record);
std::string level_text(const reference::PocketLevel& level);
std::string alarms_text(const reference::AlarmReport& report);
std::string alarm_text(const SubjectAlarm& alarm);
// {"x":"1","z":"2"}
std::string point_text(const reference::Position& point, reference::AxisSet axes);
// Exact, as in a record but without quotes round it; and rounded to nine decimals.
std::string exact_text(const reference::Number& value);
std::string millimetres_text(const reference::Number& value);

}  // namespace gonogo::oracle
