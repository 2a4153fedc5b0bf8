// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject with its own alarms under the names of the gauge.
#pragma once

#include <memory>

#include "campaign/known_failures.hpp"
#include "oracle/differential/subject.hpp"

namespace gonogo::cli {

// Null: its alarms have their names already.
std::unique_ptr<oracle::Subject> with_alarm_map(std::unique_ptr<oracle::Subject> subject,
                                                std::shared_ptr<const oracle::AlarmMap> alarms);

}  // namespace gonogo::cli
