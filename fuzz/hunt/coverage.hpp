// SPDX-License-Identifier: GPL-3.0-or-later
//
// The coverage of the reference by a program. It guides a hunt, because the subject is a black
// box: which clauses acted, with which signs, in which state and after which other clause.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "fuzz/generate/generator.hpp"
#include "reference/clause.hpp"

namespace gonogo::hunt {

enum class CoverageDetail : std::uint8_t {
  all,
  // A clause with what decided it, the code in force and the clause before.
  clauses,
};
struct Coverage {
  std::vector<std::uint64_t> features;  // hashes, sorted, each once
  // What judging the program costs, as a number of records.
  std::size_t cost = 0;
};
// Nothing where the program costs more than `most_cost`. A feature
// is a clause of a record or alarm with what decided it (kind, signs of the travel, sense, class)
// and one part of the state: plane, units, settings, the code in force, a code written before, the
// clause before, how two words of the block compare (equal, one increment apart, a multiple).
std::optional<Coverage> coverage_of(const generate::GeneratedProgram& program,
                                    std::size_t most_cost,
                                    CoverageDetail detail = CoverageDetail::all);

// Clauses with the ways in which each decided something (kind, signs of the travel, sense, class).
using Reached = std::map<reference::ClauseId, std::set<std::uint64_t>>;
// For one program; nothing where the reference puts out more than `most_cost`.
std::optional<Reached> reached_by(const generate::GeneratedProgram& program, std::size_t most_cost);

}  // namespace gonogo::hunt
