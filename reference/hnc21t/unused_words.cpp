// SPDX-License-Identifier: GPL-3.0-or-later
//
// HNC-COM-07, HNC-COM-04: words of a block that the code in force does not use, and speeds and
// tools below zero. No text says that they are wrong, nor that they are not.
#include "reference/clause_literal.hpp"
#include "reference/hnc21t/machine.hpp"
#include "reference/hnc21t/word_use.hpp"

namespace gonogo::reference::hnc21t {
namespace {

constexpr Letters kSpeedAndTool = letters_of("S T");

}  // namespace

void note_unused_words(const BlockContext& block) {
  const Code* const code = code_that_runs(block.codes, block.machine.motion);
  for (const grammar::Word& word : block.words.block().words) {
    if ((kSpeedAndTool & letter_bit(word.address)) != 0 && to_number(word.value).sign() < 0) {
      block.out.accept("HNC-COM-04"_clause);
    } else if (!uses_word(code, word.address)) {
      block.out.accept("HNC-COM-07"_clause);
    }
  }
}

}  // namespace gonogo::reference::hnc21t
