// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/g_codes.hpp"

#include <fmt/format.h>

#include <string_view>

#include "grammar/parser.hpp"

namespace gonogo::reference {

std::string code_name(int tenths) {
  return tenths % 10 == 0 ? fmt::format("G{:02}", tenths / 10)
                          : fmt::format("G{}.{}", tenths / 10, tenths % 10);
}

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

Alarm second_of_group(int tenths, const grammar::Word& word, ClauseId clause) {
  return {AlarmClass::duplicate_word, clause, 'G', word.where,
          fmt::format("{} is the second code of its group in the block.", code_name(tenths))};
}

NotCovered code_outside(int tenths, std::string_view title, const grammar::Word& word) {
  return {0, code_name(tenths),
          fmt::format("{} ({}) is a code of the control that the gauge does not read.",
                      code_name(tenths), title),
          word.where};
}

}  // namespace gonogo::reference
