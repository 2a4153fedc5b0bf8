// SPDX-License-Identifier: GPL-3.0-or-later
//
// GSK-COM-10, GSK-COM-12: words of a block that the code in force does not use, and speeds and
// tools below zero. No text says that they are wrong, nor that they are not.
#include "reference/clause_literal.hpp"
#include "reference/geometry/arc_centre.hpp"
#include "reference/gsk988ta/descriptor.hpp"
#include "reference/gsk988ta/machine.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

constexpr Letters kSpeedAndTool = letters_of("S T");

// The addresses that the code of the block uses.
Letters used_words(const BlockContext& block) {
  const int once = block.codes.once;
  Letters used =
      table::kEverywhereLetters | (once >= 0 ? code_of(once)->letters : table::kAxisLetters);
  // The words of a cycle that is entered are taken in beside a code of group 00, too.
  if (once >= 0 && !block.entered_cycle) return used;
  const Code* const code = block.code_in_force();
  if (code == nullptr) return used;
  used |= code->letters;
  if (code->kind == Kind::arc) used &= ~letter_bit(offset_address(axes_of(block.machine.plane).d));
  return used;
}

}  // namespace

void note_unused_words(const BlockContext& block) {
  const Letters used = used_words(block);
  for (const grammar::Word& word : block.words.block().words) {
    if ((kSpeedAndTool & letter_bit(word.address)) != 0 && to_number(word.value).sign() < 0) {
      block.out.accept("GSK-COM-12"_clause);
    } else if ((used & letter_bit(word.address)) == 0) {
      block.out.accept("GSK-COM-10"_clause);
    }
  }
}

}  // namespace gonogo::reference::gsk988ta
