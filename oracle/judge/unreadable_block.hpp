// SPDX-License-Identifier: GPL-3.0-or-later
//
// R6. A block that cannot be read to its end may have another fault before that place.
#pragma once

#include <string_view>

#include "oracle/steps/program_input.hpp"
#include "reference/outcome.hpp"
#include "reference/profile.hpp"

namespace gonogo::oracle {

// Whether the words of the block that stand before its syntax fault have an alarm of that class,
// which no word behind them could take away. Runs the reference again, a few times at most. False
// for a report without a syntax fault.
bool has_alarm_before_fault(const reference::Profile& profile, const ProgramText& program,
                            const reference::AlarmReport& report, std::string_view alarm_class);

}  // namespace gonogo::oracle
