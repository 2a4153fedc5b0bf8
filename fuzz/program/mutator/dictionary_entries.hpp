// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a dictionary knows by a dialect's table.
#pragma once

#include <string>
#include <vector>

#include "reference/descriptor.hpp"

namespace gonogo::program {

// Each code; each word with a value; of each code that is read a block of it with its words. Some
// may stand twice.
std::vector<std::string> entries_of(const reference::Descriptor& table);

}  // namespace gonogo::program
