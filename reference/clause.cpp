// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/clause.hpp"

#include "reference/clause_literal.hpp"

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

bool is_silent(ClauseId id) {
  return id != kNoClause && clause(id).basis() == Basis::silent;
}

std::string other_answer(const Clause& clause) {
  std::string names;
  for (const std::string_view some : {clause.refusals, clause.other_names}) {
    if (!some.empty()) names += (names.empty() ? "the alarm " : ", ") + std::string(some);
  }
  for (std::size_t blank = 10; (blank = names.find(' ', blank)) != std::string::npos; blank += 4) {
    names.replace(blank, 1, " or ");
  }
  return names.empty() ? names : names + ".";
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
