// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/unused_words.hpp"

#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/m_functions.hpp"

namespace gonogo::reference::rs274 {
namespace {

// The words that the codes of a block take.
class WordTakers {
 public:
  explicit WordTakers(const BlockContext& block) : block_(block), own_(block.letters) {
    for (const grammar::Word& word : block.words.block().words) {
      if (word.address != 'M') continue;
      const Code* const function = m_function(m_number(word, block.readings).value_or(-1));
      if (function != nullptr) own_ |= function->letters;
    }
    if (block.runs_motion) motion_ = words_of_motion(block.machine.motion);
  }

  // P belongs to the motion where no other code of the block takes it.
  bool beside_motion(char address) const { return (own_ & letter_bit(address)) != 0; }
  bool take(char address) const {
    // Codes, axes, and what is passed on.
    constexpr Letters kAlways = letters_of("A C F G M S T X Y Z @ ^");
    if (((kAlways | own_ | block_.codes.of_motions) & letter_bit(address)) != 0) return true;
    return (motion_ & letter_bit(address)) != 0 && by_reading(address);
  }

 private:
  // NGC-CYC-23: whether a word that a cycle may have is read, where that is a reading.
  bool by_reading(char address) const {
    const int motion = block_.machine.motion;
    const ReadingsInUse& readings = block_.readings;
    // NGC-G83-08
    if (address == 'D') return readings.is("ngc.peck.d=clearance"_reading);
    // NGC-G84-04
    const bool taps = motion == 74 || motion == 84;
    if (address == 'P' && taps) return !readings.is("ngc.tap.p=barred"_reading);
    // NGC-G74-01
    if (address == 'L' && motion == 74) return readings.is("ngc.g74.l=allowed"_reading);
    return true;
  }

  const BlockContext& block_;
  Letters own_;
  Letters motion_ = 0;
};

}  // namespace

bool is_taken_beside_motion(const BlockContext& block, char address) {
  return WordTakers{block}.beside_motion(address);
}

// NGC-COM-02
void check_unused_words(BlockContext& block) {
  const WordTakers takers{block};
  for (const grammar::Word& word : block.words.block().words) {
    if (takers.take(word.address)) continue;
    if (block.readings.is("ngc.unused-words=ignored"_reading)) return;
    block.out.alarms.push_back({AlarmClass::unused_word, "NGC-COM-02"_clause, word.address,
                                word.where,
                                fmt::format("No code of the block uses {}.", text_of(word))});
  }
}

}  // namespace gonogo::reference::rs274
