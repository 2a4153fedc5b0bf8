// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/valid_programs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "fuzz/program/features.hpp"
#include "fuzz/program/lines.hpp"
#include "oracle/judge/judge_session.hpp"
#include "oracle/steps/program_input.hpp"
#include "reference/expander.hpp"

namespace gonogo::generate {
namespace {

// The length of a program; longer ones are of no use.
constexpr std::size_t kMostItems = 5'000;

// The program without its line of this number, from 1. REQUIRES: it has one.
std::string without_line(std::string_view program, std::uint64_t number) {
  std::string text;
  for (const program::ProgramLine& line : program::program_lines(program)) {
    if (--number != 0) text.append(line.text).append(line.end);
  }
  return text;
}

// Under one assignment, which `profile` holds.
std::optional<Refusal> refusal_under(const reference::Profile& profile, const std::string& text,
                                     std::size_t most_items) {
  oracle::ProgramInput input(text);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::shown);
  std::size_t items = 0;
  while (const reference::Item* item = expander.next()) {
    if (const auto* report = std::get_if<reference::AlarmReport>(item)) {
      const reference::Alarm& alarm = best_supported(*report);
      return Refusal{report->block,
                     fmt::format("{} {}", reference::clause_name(alarm.clause), name(alarm.alarm))};
    }
    if (const auto* lacking = std::get_if<reference::NotCovered>(item))
      return Refusal{lacking->block, "not covered"};
    if (++items > most_items) return Refusal{0, "too long"};
  }
  return std::nullopt;
}

bool has_block(const std::string& text) {
  return text.find_first_not_of(" \r\n%;") != std::string::npos;
}

}  // namespace

std::optional<Refusal> refusal_of(const GeneratedProgram& program, std::size_t most_items) {
  try {
    const oracle::Assignments assignments = oracle::assignments_of(program.profile, program.text);
    if (assignments.too_many) return Refusal{0, "too many assignments"};
    for (const reference::ReadingChoice& choice : assignments.choices) {
      reference::Profile profile = program.profile;
      profile.readings = choice;
      if (auto refusal = refusal_under(profile, program.text, most_items)) return refusal;
    }
  } catch (const exact::Undecided&) {
    return Refusal{0, "undecided"};
  }
  return std::nullopt;
}

ValidPrograms::ValidPrograms(const Generator& generator, ValidOptions options)
    : generator_(generator), options_(std::move(options)) {
  options_.settings.kinds.near_invalid = 0;
  options_.settings.kinds.raw = 0;
  const KindWeights& kinds = options_.settings.kinds;
  if (kinds.valid + kinds.boundary + kinds.tiny == 0) options_.settings.kinds.valid = 1;
  options_.settings.refused = false;
}

// Features add up block by block, so that a block is kept where it adds none that is not declared.
void ValidPrograms::leave_out_features(GeneratedProgram& program) {
  if (options_.features.empty()) return;
  std::string kept;
  for (const program::ProgramLine& line : program::program_lines(program.text)) {
    const std::string longer = fmt::format("{}{}{}", kept, line.text, line.end);
    const std::set<std::string> needed = program::features_of_part({program.profile, longer});
    if (std::ranges::includes(options_.features, needed)) {
      kept = longer;
    } else {
      ++count_.left_out;
    }
  }
  program.text = std::move(kept);
}

// Whether the program as a whole, plain as it may be now, needs declared ones alone.
bool ValidPrograms::has_features(const GeneratedProgram& program) const {
  return options_.features.empty() ||
         std::ranges::includes(options_.features,
                               program::features_needed({program.profile, program.text}));
}

// False: it is refused for something that no block is at fault for.
bool ValidPrograms::leave_out_refused(GeneratedProgram& program) {
  while (const std::optional<Refusal> refusal = refusal_of(program, kMostItems)) {
    const std::size_t lines = program::program_lines(program.text).size();
    if (refusal->block == 0 || refusal->block > lines) return false;
    ++count_.left_out;
    ++count_.refused_by[refusal->why];
    program.text = without_line(program.text, refusal->block);
  }
  return true;
}

std::optional<GeneratedProgram> ValidPrograms::of_seed(std::uint64_t seed) {
  Choices choices(seed);
  GeneratedProgram program = generator_.generate(choices, options_.settings, nullptr);
  if (options_.profile) program.profile = *options_.profile;
  ++count_.programs;
  count_.blocks += static_cast<std::size_t>(std::ranges::count(program.text, '\n'));
  leave_out_features(program);
  if (!leave_out_refused(program) || !has_block(program.text) || !has_features(program)) {
    ++count_.thrown_out;
    return std::nullopt;
  }
  return program;
}

}  // namespace gonogo::generate
