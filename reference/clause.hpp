// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clause catalog: every single thing that a manual says and that the reference does.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference {

using ClauseId = std::uint16_t;
inline constexpr ClauseId kNoClause = 0xFFFF;

// All clauses of all dialects; a ClauseId is a place in it.
std::span<const Clause> clauses();
const Clause& clause(ClauseId id);
std::string_view clause_name(ClauseId id);  // "" for kNoClause
// Whether no text states what the clause says; false for kNoClause.
bool is_silent(ClauseId id);
// What a subject may do there as the other answer to the clause's question, besides running on
// where that is an alarm (docs/relation.md, R7); empty: the catalog names nothing.
std::string other_answer(const Clause& clause);
std::string_view name(ClauseLevel level);
std::string_view name(Basis basis);
std::optional<Basis> basis(std::string_view name);

}  // namespace gonogo::reference
