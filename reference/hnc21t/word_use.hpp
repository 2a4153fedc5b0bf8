// SPDX-License-Identifier: GPL-3.0-or-later
//
// What becomes of each word beside each code (HNC-WRD-01).
#pragma once

#include <span>

#include "reference/passed_words.hpp"

namespace gonogo::reference::hnc21t {

// Whether the code looks at the word, or a rule passes it over; else it is not covered. `code` is
// the one that the block runs: 4 and 92, or the motion code in force.
bool reads_word(int code, char address);
// The rules that pass words over.
std::span<const PassedWords> passed_words();

}  // namespace gonogo::reference::hnc21t
