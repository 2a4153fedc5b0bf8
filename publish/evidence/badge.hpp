// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "publish/evidence/run_state.hpp"

namespace gonogo::oracle::evidence {

// The JSON that a badge service of the shields kind reads: label, message, colour.
std::string badge_json(const RunState& state);

}  // namespace gonogo::oracle::evidence
