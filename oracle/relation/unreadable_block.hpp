// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "oracle/records/subject_outcome.hpp"

#include "reference/outcome.hpp"
#include "reference/profile.hpp"

namespace gonogo::relation {

// R6: whether the readable words of a block that cannot be read have an alarm of that class, and
// nothing behind them could take it away.
bool alarms_before_fault(const reference::Profile& profile, std::string_view program,
                         const reference::AlarmReport& report, std::string_view alarm_class);

// R7: whether the program has the alarm in a later block, without the block that alarms or its
// words at fault.
bool alarms_without(const reference::Profile& profile, std::string_view program,
                    const reference::AlarmReport& report, const oracle::SubjectAlarm& alarm);

}  // namespace gonogo::relation
