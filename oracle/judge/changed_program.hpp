// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the reference says of the program, or of it with other lines. It is run again for each.
#pragma once

#include <optional>
#include <string_view>

#include "oracle/records/subject_outcome.hpp"
#include "oracle/steps/program_input.hpp"
#include "reference/outcome.hpp"
#include "reference/profile.hpp"

namespace gonogo::oracle {

// The alarm with which it ends; nothing: none.
std::optional<reference::AlarmReport> alarm_of(const reference::Profile& profile,
                                               const ProgramText& program);

// R7: whether the program alarms so in a later block, once the block that alarms or its words at
// fault are taken out: a control that runs on over that block comes to this alarm. An alarm of
// block 0 may be in any.
bool alarms_without(const reference::Profile& profile, const ProgramText& program,
                    const reference::AlarmReport& report, const SubjectAlarm& alarm);

// R6. A block that cannot be read to its end may have another fault before that place: whether the
// words of the block that stand before its syntax fault have an alarm of that class, which no word
// behind them could take away. False for a report without a syntax fault.
bool has_alarm_before_fault(const reference::Profile& profile, const ProgramText& program,
                            const reference::AlarmReport& report, std::string_view alarm_class);

}  // namespace gonogo::oracle
