// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/g_codes.hpp"

#include <fmt/format.h>

#include <string_view>

#include "grammar/parser.hpp"
#include "reference/descriptor.hpp"

namespace gonogo::reference {

std::optional<int> tenths_of_long(const grammar::Decimal& value) {
  if (value.negative) return std::nullopt;  // not 0: such digits begin with another
  std::string_view digits = value.long_digits;
  std::uint32_t scale = value.scale;
  for (; scale > 1 && digits.back() == '0'; --scale) digits.remove_suffix(1);
  if (scale != 1 || digits.size() > 5) return std::nullopt;
  int tenths = 0;
  for (const char digit : digits) tenths = tenths * 10 + (digit - '0');
  return tenths > 10'000 ? std::nullopt : std::optional<int>(tenths);
}

Alarm undefined_code(const grammar::Word& word, ClauseId clause) {
  std::string written = "G";
  grammar::print(word.value, written);
  return {AlarmClass::undefined_code, clause, 'G', word.where,
          fmt::format("The control has no code {}.", written)};
}

Alarm second_of_group(const Code& code, const grammar::Word& word, ClauseId clause) {
  return {AlarmClass::duplicate_word, clause, 'G', word.where,
          fmt::format("{} is the second code of its group in the block.", code_name(code.tenths))};
}

NotCovered code_outside(const Code& code, const grammar::Word& word) {
  // The one of a family that is written.
  const std::string name = code_name(tenths_of(word.value).value_or(code.tenths));
  return {0, name,
          fmt::format("{} ({}) is a code of the control that the gauge does not read.", name,
                      code.title),
          word.where};
}

bool GCodeTable::repeats_group(const grammar::Block& block) const {
  std::uint32_t seen = 0;
  for (const grammar::Word& word : block.words) {
    const Code* code = word.address == 'G' ? find(word.value) : nullptr;
    if (code == nullptr) continue;
    if ((seen & bit_of(*code)) != 0) return true;
    seen |= bit_of(*code);
  }
  return false;
}

void GCodeTable::read(const grammar::Block& block, bool last_wins, GCodeReading& reading) const {
  reading.clear();
  for (const grammar::Word& word : block.words) {
    if (word.address == 'G') read_word(word, last_wins, reading);
  }
}

void GCodeTable::take(const grammar::Word& word, const Code* code, bool last_wins,
                      GCodeReading& reading) const {
  if (code == nullptr) {
    reading.alarms.push_back(undefined_code(word, undefined_));
    return;
  }
  if (!reading.is_first_of(code->group) && !last_wins) {
    reading.alarms.push_back(second_of_group(*code, word, repeated_));
  }
  if (code->treatment == Treatment::outside && !reading.not_covered) {
    reading.not_covered = code_outside(*code, word);
  }
  if (code->group != Group::motion) reading.letters |= code->letters;
  reading.by_group[static_cast<std::size_t>(code->group)] = code->tenths / 10;
}

}  // namespace gonogo::reference
