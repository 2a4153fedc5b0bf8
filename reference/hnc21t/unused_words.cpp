// SPDX-License-Identifier: GPL-3.0-or-later
//
// HNC-COM-07, HNC-COM-04: words of a block that the code in force does not use, and speeds and
// tools below zero. No text says that they are wrong, nor that they are not.
#include <string_view>

#include "reference/hnc21t/machine.hpp"

namespace gonogo::reference::hnc21t {
namespace {

bool is_among(std::string_view set, char address) {
  return set.find(address) != std::string_view::npos;
}

// The addresses that the code of the block uses, without F and those that go with every code.
std::string_view used_words(const BlockContext& block) {
  if (block.codes.once == 4) return "P";
  if (block.codes.once == 92) return "XZUW";
  switch (block.machine.motion) {
    case 2:
    case 3:
      return "XZUWRIK";
    case 32:
      return "XZUWJREPCQKI";
    case 74:
      return "ZWRQ";  // HNC-G74-04
    case 75:
      return "XZUWRQIP";
    case 80:
      return "XZUWI";
    case 81:
      return "XZUWK";
    case 82:
      return "XZUWIRECPJQ";
    default:
      return "XZUW";
  }
}

}  // namespace

void note_unused_words(const BlockContext& block) {
  const std::string_view used = used_words(block);
  for (const grammar::Word& word : block.words.block().words) {
    if (is_among("ST", word.address) && to_number(word.value).sign() < 0) {
      block.out.accept("HNC-COM-04"_clause);
    } else if (!is_among("GMSTF", word.address) && !is_among(used, word.address)) {
      block.out.accept("HNC-COM-07"_clause);
    }
  }
}

}  // namespace gonogo::reference::hnc21t
