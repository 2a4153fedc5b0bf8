// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gsk988ta/codes.hpp"

#include <algorithm>

#include "reference/clause_literal.hpp"
#include "reference/gsk988ta/descriptor.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

// GSK-COM-02, GSK-COM-08 (a code with decimals); GSK-COM-07.
constexpr GCodeTable kTable{table::kCodes, "GSK-COM-02"_clause, "GSK-COM-07"_clause};

// J-ALM-04: G80 and a milling cycle are two codes of one group, or of two that exclude each other
// (GSK-MOD-06, GSK-MOD-09).
void admit_conflict_with_g80(const grammar::Block& block, CodeReading& reading) {
  const auto code_at = [&](const grammar::Word& word) {
    return word.address == 'G' ? kTable.find(word.value) : nullptr;
  };
  const bool has_g80 = std::ranges::any_of(block.words, [&](const grammar::Word& word) {
    const Code* const code = code_at(word);
    return code != nullptr && code->kind == Kind::off;
  });
  if (!has_g80) return;
  for (const grammar::Word& word : block.words) {
    const Code* const code = code_at(word);
    if (code == nullptr || code->group != Group::cycle) continue;
    for (Alarm& alarm : reading.alarms) {
      const bool is_second =
          alarm.alarm == AlarmClass::duplicate_word && alarm.where.begin == word.where.begin;
      if (is_second) alarm.also.add(AlarmClass::conflicting_words);
    }
  }
}

}  // namespace

bool repeats_group(const grammar::Block& block) {
  return kTable.repeats_group(block);
}

void read_codes(const grammar::Block& block, bool last_wins, CodeReading& reading) {
  kTable.read(block, last_wins, reading);
  if (!reading.alarms.empty()) admit_conflict_with_g80(block, reading);
  reading.codes = {.once = reading.of(Group::once),
                   .motion = reading.of(Group::motion),
                   .cycle = reading.of(Group::cycle),
                   .feed_mode = reading.of(Group::feed_mode),
                   .units = reading.of(Group::units),
                   .plane = reading.of(Group::plane)};
}

const Code* code_of(int number) {
  return kTable.find_tenths(number * 10);
}

}  // namespace gonogo::reference::gsk988ta
