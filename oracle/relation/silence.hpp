// SPDX-License-Identifier: GPL-3.0-or-later
//
// R7: what no text states, and what the other answer to it would be.
#pragma once

#include <string_view>

#include "reference/clause.hpp"

namespace gonogo::relation {

bool is_silent(reference::ClauseId clause);

// Whether an alarm of that class would be the other answer where a block runs on by that rule.
bool is_other_answer(reference::ClauseId clause, std::string_view alarm_class);

}  // namespace gonogo::relation
