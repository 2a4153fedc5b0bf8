// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/generator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "fuzz/generate/writers.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {

namespace {

ProgramKind choose_kind(Choices& choices, const KindWeights& kinds) {
  const std::array<std::uint32_t, kProgramKinds> weights = {kinds.valid, kinds.near_invalid,
                                                            kinds.boundary, kinds.raw, kinds.tiny};
  std::uint32_t place = choices.below(std::accumulate(weights.begin(), weights.end(), 0U));
  std::size_t kind = 0;
  while (place >= weights[kind]) place -= weights[kind++];
  return static_cast<ProgramKind>(kind);
}

template <const std::string_view& kDialect>
GeneratedProgram write_sinumerik(Choices& choices, const GeneratorSettings& settings,
                                 ProgramKind kind, Distribution* distribution) {
  return generate_sinumerik(kDialect, choices, settings, kind, distribution);
}

// For offsets, parameters, expressions and O words.
constexpr auto kUnaskedByNgc =
    std::to_array({"ngc.g92-other-axes"_key, "ngc.g28-axes"_key, "ngc.g10-p0"_key,
                   "ngc.g43-without-h"_key, "ngc.logic-order"_key, "ngc.equal"_key,
                   "ngc.sign-of-value"_key, "ngc.call-parameters"_key, "ngc.m98-before"_key});

// The expanders have one outcome of these.
constexpr auto kOneOfGsk =
    std::to_array({"gsk.arc.zero-radius"_key, "gsk.rotary-feed-inch"_key, "gsk.feed-units"_key});

constexpr std::string_view k840d = "sinumerik840d";
constexpr std::string_view k802s = "sinumerik802s";

}  // namespace

std::string_view name(ProgramKind kind) {
  constexpr std::array<std::string_view, kProgramKinds> kNames = {"valid", "near-invalid",
                                                                  "boundary", "raw", "tiny"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::span<const Generator> generators() {
  static const auto kGenerators = std::to_array<Generator>({
      {"gsk988ta", "gsk", generate_gsk, kOneOfGsk},
      {"hnc21t", "hnc", generate_hnc, {}},
      {"rs274", "ngc", generate_ngc, kUnaskedByNgc},
      {k840d, "sinumerik", write_sinumerik<k840d>, {}},
      {k802s, "sinumerik", write_sinumerik<k802s>, {}},
  });
  return kGenerators;
}

namespace {

// Closes every reading that the profile leaves open and that has more than one alternative, but for
// `unasked`: as `expand` shows it, in one program of two any alternative of one. `leaves_some`: one
// in four stays open.
void close_readings(Choices& choices, reference::Profile& profile,
                    std::span<const reference::ReadingKey> unasked, bool leaves_some) {
  constexpr std::uint32_t kOpenOneIn = 4;
  std::vector<const reference::Reading*> closed;
  for (const reference::Reading& reading : reference::readings()) {
    if (reading.by_properties || reading.alternatives.size() < 2 ||
        !reading.belongs_to(profile.dialect) || !profile.readings.is(reading.key, "any") ||
        std::ranges::find(unasked, reading.key) != unasked.end()) {
      continue;
    }
    if (leaves_some && choices.below(kOpenOneIn) == 0) continue;
    profile.readings.set(reading.key, reading.alternatives.front());
    closed.push_back(&reading);
  }
  if (closed.empty() || choices.below(2) == 0) return;
  const reference::Reading& one = *closed[choices.below(static_cast<std::uint32_t>(closed.size()))];
  const auto count = static_cast<std::uint32_t>(one.alternatives.size());
  profile.readings.set(one.key, one.alternatives[choices.below(count)]);
}

}  // namespace

GeneratedProgram Generator::generate(Choices& choices, const GeneratorSettings& settings,
                                     Distribution* distribution) const {
  const ProgramKind kind = choose_kind(choices, settings.kinds);
  if (distribution != nullptr) ++(*distribution)[fmt::format("kind {}", name(kind))];
  GeneratedProgram program = kind == ProgramKind::raw
                                 ? raw_program(dialect, choices, settings)
                                 : write(choices, settings, kind, distribution);
  // The last of the decisions, so that the text does not depend on it.
  const std::uint32_t open_one_in = settings.open_one_in;
  if (open_one_in > 1) {
    const bool leaves_some = choices.below(open_one_in) + 1 == open_one_in;
    close_readings(choices, program.profile, unasked, leaves_some);
  }
  return program;
}

const Generator* find_generator(std::string_view expander, std::string_view dialect) {
  const auto found = std::ranges::find_if(generators(), [&](const Generator& generator) {
    return generator.expander == expander && (dialect.empty() || generator.dialect == dialect);
  });
  return found == generators().end() ? nullptr : &*found;
}

const Generator& generator_of(std::string_view dialect) {
  return *std::ranges::find(generators(), dialect, &Generator::dialect);
}

std::string choose_reading(Choices& choices, reference::Profile& profile) {
  std::vector<const reference::Reading*> own;
  for (const reference::Reading& reading : reference::readings()) {
    if (reading.belongs_to(profile.dialect)) own.push_back(&reading);
  }
  const reference::Reading& reading = *own[choices.below(static_cast<std::uint32_t>(own.size()))];
  const auto count = static_cast<std::uint32_t>(reading.alternatives.size());
  const std::string value = reading.is_length
                                ? fmt::format("0.{}", choices.below(10))
                                : std::string(reading.alternatives[choices.below(count)]);
  profile.readings.set(reading.key, value);
  return fmt::format("{}={}", reading.name, reading.is_length ? "length" : value);
}

}  // namespace gonogo::generate
