// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files that belong to a subject: what it is known to fail, and what its alarms mean.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "campaign/known_failures.hpp"

namespace gonogo::cli {

// Both throw UsageError, with the file and what is wrong in it.
std::vector<oracle::KnownFailure> load_known_failures(const std::string& file);
std::vector<oracle::KnownCause> load_known_causes(const std::string& file);
// Null: no file is named.
std::shared_ptr<const oracle::AlarmMap> load_alarm_map(const std::string& file);

}  // namespace gonogo::cli
