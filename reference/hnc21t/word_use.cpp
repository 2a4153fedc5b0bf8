// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hnc21t/word_use.hpp"

#include "reference/hnc21t/descriptor.hpp"

namespace gonogo::reference::hnc21t {
// HNC-WRD-01
bool uses_word(const Code* code, char address) {
  if ((table::kEverywhereLetters & letter_bit(address)) != 0) return true;
  return code != nullptr && code->takes(address);
}

bool reads_word(const Code* code, char address) {
  return uses_word(code, address) || (code != nullptr && code->ignores(address));
}

}  // namespace gonogo::reference::hnc21t
