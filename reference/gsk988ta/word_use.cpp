// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gsk988ta/word_use.hpp"

#include "reference/geometry/arc_centre.hpp"
#include "reference/gsk988ta/descriptor.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

constexpr Letters kCentre = letters_of("I J K");
constexpr Letters kOfTables = letters_of(table::kOfTables);

bool holds(Letters set, char address) {
  return (set & letter_bit(address)) != 0;
}

// GSK-COM-05: P goes before X and U, which exclude each other.
bool times_dwell(const BlockWords& words, char address) {
  return address == 'P' || !words.has('P');
}

// GSK-COM-05: R goes before the centre; a centre along the axis outside the plane is none.
bool shapes_arc(const BlockContext& block, char address) {
  if (!holds(kCentre, address) || block.words.has('R')) return true;
  return address != offset_address(axes_of(block.state.plane).d);
}

// GSK-WRD-01
bool reads_word(const BlockContext& block, const Code* code, char address) {
  if (holds(table::kEverywhereLetters, address)) return true;
  if (code == nullptr) return holds(table::kAxisLetters, address);
  if (code->group == Group::once) {
    // GSK-MOD-02: beside the code of a cycle its words are taken in, too.
    const bool enters = block.codes.cycle > 80;
    if (enters && holds(kOfTables, address)) return true;
    return code->takes(address) && (code->kind != Kind::dwell || times_dwell(block.words, address));
  }
  if (code->ignores(address)) return true;
  return code->takes(address) && (code->kind != Kind::arc || shapes_arc(block, address));
}

}  // namespace

StrayWord stray_word(const BlockContext& block) {
  const Code* const code =
      block.codes.once >= 0 ? code_of(block.codes.once) : block.code_in_force();
  for (const grammar::Word& word : block.words.block().words) {
    if (!reads_word(block, code, word.address)) return {&word, code};
  }
  return {};
}

}  // namespace gonogo::reference::gsk988ta
