// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clause catalog: every single thing that a manual says and that the reference does.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "reference/catalog/bases.hpp"
#include "reference/catalog/gsk988ta.hpp"
#include "reference/catalog/hnc21t.hpp"
#include "reference/catalog/rs274.hpp"
#include "reference/catalog/rs274_calculation.hpp"
#include "reference/catalog/rs274_cycles.hpp"
#include "reference/catalog/rs274_offsets.hpp"
#include "reference/catalog/rs274_threads.hpp"
#include "reference/catalog/silent_rules.hpp"
#include "reference/catalog/sinumerik.hpp"
#include "reference/catalog/sinumerik802s.hpp"

namespace gonogo::reference {
namespace catalog {

// The tables of the dialects, one after the other.
template <typename First, typename... More>
consteval auto joined(const First& first, const More&... more) {
  std::array<typename First::value_type, (std::tuple_size_v<First> + ... + std::tuple_size_v<More>)>
      all{};
  auto place = std::copy(first.begin(), first.end(), all.begin());
  ((place = std::copy(more.begin(), more.end(), place)), ...);
  return all;
}

// With what they rest on where the level alone does not say it.
template <typename Catalog>
consteval Catalog resting(Catalog all) {
  for (const ClauseBasis& basis : kBases) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Clause& clause) { return clause.id == basis.id; });
    if (found == all.end()) throw "no such clause in the catalog";
    found->stated_basis = Basis::derived;
    found->derivation = basis.derivation;
  }
  return all;
}

inline constexpr auto kAll =
    resting(joined(kGsk988ta, silent::kGsk988ta, hnc21t::kClauses, silent::kHnc21t, rs274::kClauses,
                   rs274::kCycleClauses, rs274::kThreadClauses, rs274::kOffsetClauses,
                   rs274::kCalculationClauses, sinumerik::kPathClauses, silent::kSinumerikPath,
                   sinumerik::kCycleClauses, silent::kSinumerikCycles));

}  // namespace catalog

using ClauseId = std::uint16_t;
inline constexpr ClauseId kNoClause = 0xFFFF;

// All clauses of all dialects; a ClauseId is a place in it.
std::span<const Clause> clauses();
const Clause& clause(ClauseId id);
std::string_view clause_name(ClauseId id);  // "" for kNoClause
// Whether no text states what the clause says; false for kNoClause.
bool is_silent(ClauseId id);
// What a subject may do there that answers its question the other way, beside running on where it
// is an alarm (docs/judging.md, R7); empty: the catalog names nothing.
std::string other_answer(const Clause& clause);
std::string_view name(ClauseLevel level);
std::string_view name(Basis basis);
std::optional<Basis> basis(std::string_view name);

// "GSK-G94-02"_clause: the place of a clause in the catalog, checked when compiling.
consteval ClauseId operator""_clause(const char* id, std::size_t size) {
  for (std::size_t i = 0; i < catalog::kAll.size(); ++i) {
    if (catalog::kAll[i].id == std::string_view(id, size)) return static_cast<ClauseId>(i);
  }
  throw "no such clause in the catalog";
}

}  // namespace gonogo::reference
