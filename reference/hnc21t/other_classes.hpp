// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-ALM-04: the classes that two reasonable readers of one rule give its alarm. No text of the
// maker names any.
#pragma once

#include <vector>

#include "reference/hnc21t/words.hpp"

namespace gonogo::reference::hnc21t {

// The alarms of a block with these words. What else an unstated rule may be called stands in the
// catalog.
void admit_other_classes(const BlockWords& words, std::vector<Alarm>& alarms);

}  // namespace gonogo::reference::hnc21t
