// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sentences of alarms whose rule compares values: the values stand in them.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "reference/exact/number.hpp"

namespace gonogo::reference {

// The sentence with a value in the place of each {}: a short decimal as it is, all others rounded,
// with "about" before them, to as many decimals as keep apart those that differ.
// REQUIRES: as many values as places.
std::string with_values(std::string_view sentence, std::initializer_list<exact::Number> values);

}  // namespace gonogo::reference
