// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "reference/clause.hpp"
#include "reference/record.hpp"

namespace gonogo::reference {

// R7. An end of the program that no text states: a control may go on there and do what stands
// behind it.
inline bool is_silent_end(const Record& record) {
  return record.kind == RecordKind::end && is_silent(record.clause);
}

// The same of an item, or of any other variant that may hold a record.
template <typename... Kinds>
bool is_silent_end(const std::variant<Kinds...>& one) {
  const auto* const record = std::get_if<Record>(&one);
  return record != nullptr && is_silent_end(*record);
}

}  // namespace gonogo::reference
