// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/drawn_vectors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "fuzz/hunt/coverage.hpp"
#include "fuzz/hunt/program_vector.hpp"
#include "oracle/judge/judge_session.hpp"

namespace gonogo::hunt {
namespace {

// The program as a case; nothing where the reference says nothing of it, cannot decide, or takes
// more ways than a judge follows.
std::optional<oracle::Case> drawn_case(const generate::GeneratedProgram& program) {
  try {
    if (!oracle::different_assignments(program.profile, program.text)) return std::nullopt;
    oracle::Case test = vector_of(program, "drawn");
    if (!std::ranges::any_of(test.expect, &oracle::Expectation::not_covered)) return test;
  } catch (const exact::Undecided&) {
    // Left out.
  }
  return std::nullopt;
}

}  // namespace

DrawnVectors draw_vectors(const ProgramDraw& source, std::uint64_t seed, std::size_t programs,
                          std::string_view gonogo) {
  DrawnVectors drawn;
  std::unordered_set<std::uint64_t> shown;
  for (std::size_t i = 0; i < programs; ++i) {
    const std::optional<generate::GeneratedProgram> drawn_program = source(seed + i);
    if (!drawn_program) continue;
    const generate::GeneratedProgram& program = *drawn_program;
    const std::vector<std::uint64_t> features =
        coverage_of(program, kMostDrawnCost, CoverageDetail::clauses).value_or(Coverage{}).features;
    const bool is_new =
        std::ranges::any_of(features, [&](auto feature) { return !shown.contains(feature); });
    if (!is_new && !features.empty()) continue;
    std::optional<oracle::Case> test = is_new ? drawn_case(program) : std::nullopt;
    if (!test) {
      ++drawn.left_out;
      continue;
    }
    shown.insert(features.begin(), features.end());
    test->id = fmt::format("drawn.{}.s{}.{:06}", test->dialect, seed, i + 1);
    test->group = test->id;
    test->comment = fmt::format("program {} of seed {}", i + 1, seed);
    test->provenance = fmt::format("{} generate, seed {}", gonogo, seed + i);
    if (expects_alarm(*test)) ++drawn.alarms;
    drawn.cases.push_back(*std::move(test));
  }
  drawn.features = shown.size();
  return drawn;
}

}  // namespace gonogo::hunt
