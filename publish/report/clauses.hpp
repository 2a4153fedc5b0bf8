// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "reference/clause.hpp"

namespace gonogo::oracle::report {

// The clause of the catalog with this id; null: none.
inline const reference::Clause* find_clause(std::string_view id) {
  for (const reference::Clause& clause : reference::clauses()) {
    if (clause.id == id) return &clause;
  }
  return nullptr;
}

}  // namespace gonogo::oracle::report
