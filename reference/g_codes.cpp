// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/g_codes.hpp"

#include <fmt/format.h>

#include "grammar/parser.hpp"

namespace gonogo::reference {

std::string code_name(int tenths) {
  return tenths % 10 == 0 ? fmt::format("G{:02}", tenths / 10)
                          : fmt::format("G{}.{}", tenths / 10, tenths % 10);
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
