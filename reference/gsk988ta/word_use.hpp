// SPDX-License-Identifier: GPL-3.0-or-later
//
// What becomes of each word beside each code (GSK-WRD-01).
#pragma once

#include "reference/gsk988ta/machine.hpp"

namespace gonogo::reference::gsk988ta {

// The first word of the block that its code does not use and no rule ignores, and the code;
// null: there is none.
struct StrayWord {
  const grammar::Word* word = nullptr;
  const Code* code = nullptr;
};
StrayWord stray_word(const BlockContext& block);

}  // namespace gonogo::reference::gsk988ta
