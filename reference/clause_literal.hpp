// SPDX-License-Identifier: GPL-3.0-or-later
//
// The clauses of the catalog by name, for those who cite one: to read them costs a compiler a
// second.
#pragma once

#include <algorithm>
#include <array>

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
#include "reference/clause.hpp"

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

// The same with their basis where the level alone does not give it.
template <typename Catalog>
consteval Catalog resting(Catalog all) {
  // Both tables have the same order for the most part: each search begins where the last one ended,
  // because a compiler allows only so many steps.
  std::size_t place = 0;
  for (const ClauseBasis& basis : kBases) {
    for (std::size_t tried = 0; all[place].id != basis.id; ++tried) {
      if (tried == all.size()) throw "no such clause in the catalog";
      place = (place + 1) % all.size();
    }
    all[place].stated_basis = Basis::derived;
    all[place].derivation = basis.derivation;
  }
  return all;
}

inline constexpr auto kAll =
    resting(joined(kGsk988ta, silent::kGsk988ta, hnc21t::kClauses, silent::kHnc21t, rs274::kClauses,
                   rs274::kCycleClauses, rs274::kThreadClauses, rs274::kOffsetClauses,
                   rs274::kCalculationClauses, sinumerik::kPathClauses, silent::kSinumerikPath,
                   sinumerik::kCycleClauses, silent::kSinumerikCycles));

}  // namespace catalog

// "GSK-G94-02"_clause: the place of a clause in the catalog, checked when compiling.
consteval ClauseId operator""_clause(const char* id, std::size_t size) {
  for (std::size_t i = 0; i < catalog::kAll.size(); ++i) {
    if (catalog::kAll[i].id == std::string_view(id, size)) return static_cast<ClauseId>(i);
  }
  throw "no such clause in the catalog";
}

}  // namespace gonogo::reference
