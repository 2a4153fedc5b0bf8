// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "expanders/faults.hpp"
#include "gonogo/subject.h"

namespace gonogo::expanders {

/// The names of the built-in expanders.
std::span<const std::string_view> names();

/// The built-in expander `name` ("gsk", "hnc", "ngc", "sinumerik") with the planted fault `fault`;
/// empty: fault-free. Null when either is unknown. The subject lives as long as the process.
const gonogo_subject_v1* find(std::string_view name, std::string_view fault = {});

/// The planted faults of the expander `name`; empty when there is no such expander.
std::span<const FaultDescription> faults(std::string_view name);

/// How often runs of this process have met the planted fault; nothing when there is none of that
/// name.
std::optional<FaultCount> count(std::string_view name, std::string_view fault);

}  // namespace gonogo::expanders
