// SPDX-License-Identifier: GPL-3.0-or-later
//
// A record in words.
#pragma once

#include <string>

#include "reference/record.hpp"

namespace gonogo::oracle::manual {

// "feed to X25 Z-30, 300 mm/min". Exact where a number is a short decimal, else six decimals.
std::string motion_text(const reference::Record& record);

}  // namespace gonogo::oracle::manual
