// SPDX-License-Identifier: GPL-3.0-or-later
//
// The form of a vector file: keys, kinds, numbers, ids, classes of alarms.
#pragma once

#include <string>
#include <vector>

#include "checker/json.hpp"

namespace gonogo::checker {

// What is wrong: sentences that begin with the id of the case, or the name of the group.
std::vector<std::string> form_faults(const Json& file, const std::string& corpus_version);

}  // namespace gonogo::checker
