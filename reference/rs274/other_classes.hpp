// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-ALM-04: the classes that two reasonable readers of one rule give its alarm.
#pragma once

#include "reference/words.hpp"

namespace gonogo::reference::rs274 {

// The words of the block have their numbers, or decimals near to them.
void admit_other_classes(const grammar::Block& block, std::vector<Alarm>& alarms);

}  // namespace gonogo::reference::rs274
