// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dwells, poles, frames and cycles stand alone in their block: what stands beside them is refused.
#include <fmt/format.h>

#include <algorithm>

#include "reference/clause_literal.hpp"
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {
namespace {

// SIE-MOD-03, SIE-POL-03, SIE-FRM-04: a dwell, a pole and a frame stand alone in their block.
// SIE-MOD-10, SIE-FRM-07: that a word which moves nothing is an alarm there is ours.
ClauseId alone_by(int once, bool moves) {
  switch (once) {
    case 4:
      return moves ? "SIE-MOD-03"_clause : "SIE-MOD-10"_clause;
    case 158:
    case 258:
    case 259:
      return moves ? "SIE-FRM-04"_clause : "SIE-FRM-07"_clause;
    default:
      return "SIE-POL-03"_clause;
  }
}

bool is_frame(int once) {
  return once == 158 || once == 258 || once == 259;
}

// Whether the word says how a motion goes, or where to.
bool is_of_motion(const grammar::Block& text, const grammar::NamedWord& word) {
  const std::optional<Address> address = address_of(word);
  if (!address) return word.name == "CIP" || word.name == "CT";
  if (address == Address::g) return to_number(text.terms[word.first_term].number) <= Number(3);
  return *address <= Address::rpl;
}

void refuse_beside(BlockContext& block, const grammar::NamedWord& word, ClauseId clause,
                   std::string_view code) {
  const std::string name = word.index ? fmt::format("{}{}", word.name, *word.index) : word.name;
  block.out.alarms.push_back({AlarmClass::conflicting_words, clause, WordName(name), word.where,
                              fmt::format("{} does not stand beside {}.", name, code)});
}

}  // namespace

void refuse_all_but(BlockContext& block, std::initializer_list<Address> its_own) {
  const grammar::Block& text = block.words.block();
  for (const grammar::NamedWord& word : text.named) {
    const std::optional<Address> address = address_of(word);
    if (address && std::ranges::find(its_own, *address) != its_own.end()) continue;
    if (address == Address::g &&
        Number(block.codes.once) == to_number(text.terms[word.first_term].number)) {
      continue;
    }
    refuse_beside(block, word, alone_by(block.codes.once, is_of_motion(text, word)),
                  fmt::format("G{}", block.codes.once));
  }
}

// SIE-FRM-04: a frame stands alone among the codes that hold once, too. Where none of them is one,
// or all are, the second is one too many of its group and no more (SIE-MOD-05).
void refuse_beside_frame(BlockContext& block) {
  constexpr ClauseId kFrame = "SIE-FRM-04"_clause;
  const grammar::Block& text = block.words.block();
  const auto code_of = [&](const grammar::NamedWord& word) { return once_code_of(text, word); };
  std::optional<int> frame;
  for (const grammar::NamedWord& word : text.named) {
    const std::optional<int> code = code_of(word);
    if (code && is_frame(*code)) frame = code;
  }
  if (!frame) return;
  for (const grammar::NamedWord& word : text.named) {
    const std::optional<int> code = code_of(word);
    if (!code || is_frame(*code)) continue;
    refuse_beside(block, word, kFrame, fmt::format("G{}", *frame));
  }
}

// SIE-LC82-05
bool cycle_stands_alone(BlockContext& block) {
  bool alone = true;
  bool called = false;
  for (const grammar::NamedWord& word : block.words.block().named) {
    if (cycle_of(word) != Cycle::none && !called) {
      called = true;
      continue;
    }
    alone = false;
    refuse_beside(block, word, "SIE-LC82-05"_clause, "the call of a cycle");
  }
  return alone;
}

}  // namespace gonogo::reference::sinumerik
