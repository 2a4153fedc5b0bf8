// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vectors from the generators: new ones for every seed, which no subject can be prepared for.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "corpus/io/corpus.hpp"
#include "fuzz/generate/generator.hpp"

namespace gonogo::hunt {

struct DrawnVectors {
  std::vector<oracle::Case> cases;  // "drawn.DIALECT.s7.000012": by the number of its program
  std::size_t features = 0;         // of CoverageDetail::clauses that they show together
  std::size_t alarms = 0;           // of the cases
  // Programs of which the reference says nothing, cannot decide, or says more than kMostDrawnCost.
  std::size_t left_out = 0;
};

inline constexpr std::size_t kMostDrawnCost = 1'000;

// The program of a seed; nothing: there is none.
using ProgramDraw = std::function<std::optional<generate::GeneratedProgram>(std::uint64_t seed)>;

// Those of so many programs that show something of the reference that none before shows. Program i
// of a seed is program 0 of seed + i, as in gonogo_soak. `gonogo`: "gonogo 0.1.0", for their
// provenance.
DrawnVectors draw_vectors(const ProgramDraw& source, std::uint64_t seed, std::size_t programs,
                          std::string_view gonogo);

}  // namespace gonogo::hunt
