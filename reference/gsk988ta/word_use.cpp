// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gsk988ta/word_use.hpp"

#include <array>

#include "reference/arc_centre.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// GSK-WRD-01. Beside every code stand the codes themselves, the feed, the tool and the spindle.
constexpr std::string_view kEverywhere = "GMFST";
constexpr std::string_view kAxes = "XUYVZWCH";
// GSK-COM-06, GSK-COM-10: the words that the tables of the cycles give a range. One that a cycle
// does not use is held to its range and passed over.
constexpr std::string_view kOfCycles = "RILQDEJKP";

bool holds(std::string_view set, char address) {
  return set.find(address) != std::string_view::npos;
}

// GSK-COM-05: P goes before X and U, which exclude each other.
bool times_dwell(const BlockWords& words, char address) {
  return address == 'P' || ((address == 'X' || address == 'U') && !words.has('P'));
}

// GSK-COM-05: R goes before the centre; a centre along the axis outside the plane is none.
bool shapes_arc(const BlockContext& block, char address) {
  if (address == 'R') return true;
  if (!holds("IJK", address)) return false;
  return block.words.has('R') || address != offset_address(axes_of(block.state.plane).d);
}

// Whether a code of group 00 uses the word.
bool used_once(const BlockContext& block, char address) {
  return block.codes.once == 4 ? times_dwell(block.words, address) : holds(kAxes, address);
}

bool reads_word(const BlockContext& block, char address) {
  if (holds(kEverywhere, address)) return true;
  const Machine& machine = block.machine;
  const bool enters = block.codes.cycle > 80;
  if (block.codes.once >= 0) {
    // GSK-MOD-02: beside the code of a cycle its words are taken in, too.
    return used_once(block, address) || (enters && holds(kOfCycles, address));
  }
  if (holds(kAxes, address)) return true;
  if (machine.milling.family() != CycleFamily::none || is_cutting_cycle(machine.motion)) {
    return holds(kOfCycles, address);
  }
  return (machine.motion == 2 || machine.motion == 3) && shapes_arc(block, address);
}

int code_of(const BlockContext& block) {
  if (block.codes.once >= 0) return block.codes.once;
  return block.machine.milling.code != 0 ? block.machine.milling.code : block.machine.motion;
}

constexpr ClauseId kRanges = "GSK-COM-10"_clause;
constexpr std::string_view kInRange =
    "a word of the tables of the cycles that this one does not use is held to its range only";

constexpr auto kPassedWords = std::to_array<PassedWords>({
    {"every block", "S T", "GSK-COM-05"_clause, "the spindle and the tool do not shape the path"},
    {"G02, G03 with R", "I J K", "GSK-COM-05"_clause, "the radius goes before the centre"},
    {"G90", "I L Q D E J K P", kRanges, kInRange},
    {"G92", "D E", kRanges, kInRange},
    {"G92", "L of 1, P and Q of 0", "GSK-G92-13"_clause, "they say what goes without saying"},
    {"G94", "I L Q D E J K P", kRanges, kInRange},
    {"G110, G111", "E J K", kRanges, kInRange},
    {"G112, G113", "Q P E J K", kRanges, kInRange},
    {"G114 to G117", "L", kRanges, kInRange},
    {"G28, G50 or G04 in the entry block of G110 to G117", "R I L Q D E J K P", "GSK-MOD-02"_clause,
     "I L Q D are taken in; the others hold for a block that mills"},
});

}  // namespace

StrayWord stray_word(const BlockContext& block) {
  for (const grammar::Word& word : block.words.block().words) {
    if (!reads_word(block, word.address)) return {&word, code_of(block)};
  }
  return {};
}

std::span<const PassedWords> passed_words() {
  return kPassedWords;
}

}  // namespace gonogo::reference::gsk988ta
