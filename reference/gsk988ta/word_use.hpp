// SPDX-License-Identifier: GPL-3.0-or-later
//
// What becomes of each word beside each code (GSK-WRD-01).
#pragma once

#include <span>

#include "reference/gsk988ta/machine.hpp"
#include "reference/passed_words.hpp"

namespace gonogo::reference::gsk988ta {

// The first word of the block that its code does not use and no rule passes over, and the code as
// it is quoted; null: there is none.
struct StrayWord {
  const grammar::Word* word = nullptr;
  int code = 0;
};
StrayWord stray_word(const BlockContext& block);
// The rules that pass words over.
std::span<const PassedWords> passed_words();

}  // namespace gonogo::reference::gsk988ta
