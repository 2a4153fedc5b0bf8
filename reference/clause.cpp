// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/clause.hpp"

namespace gonogo::reference {

std::span<const Clause> clauses() {
  return catalog::kAll;
}

const Clause& clause(ClauseId id) {
  return clauses()[id];
}

std::string_view clause_name(ClauseId id) {
  return id == kNoClause ? std::string_view{} : clauses()[id].id;
}

std::string_view name(ClauseLevel level) {
  switch (level) {
    case ClauseLevel::must:
      return "must";
    case ClauseLevel::derived:
      return "derived";
    case ClauseLevel::open:
      return "open";
  }
  return "";
}

std::string_view name(Basis basis) {
  switch (basis) {
    case Basis::text:
      return "text";
    case Basis::derived:
      return "derived";
    case Basis::silent:
      return "silent";
  }
  return "";
}

std::optional<Basis> basis(std::string_view text) {
  for (const Basis one : {Basis::text, Basis::derived, Basis::silent}) {
    if (name(one) == text) return one;
  }
  return std::nullopt;
}

}  // namespace gonogo::reference
