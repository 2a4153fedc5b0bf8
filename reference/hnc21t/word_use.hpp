// SPDX-License-Identifier: GPL-3.0-or-later
//
// What becomes of each word beside each code (HNC-WRD-01).
#pragma once

#include "reference/code.hpp"

namespace gonogo::reference::hnc21t {

// Whether the code that the block runs looks at the word; null: it runs none.
bool uses_word(const Code* code, char address);
// The same, or a rule ignores the word; else it is not covered.
bool reads_word(const Code* code, char address);

}  // namespace gonogo::reference::hnc21t
