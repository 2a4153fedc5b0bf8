// SPDX-License-Identifier: GPL-3.0-or-later
//
// Another machine: a reading, units, diameter, offsets, parameters, what the program before left.
#include <fmt/format.h>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {

namespace {

ChangedRun same(const Observation& seen) {
  return {seen.program, seen.profile, seen.outcome, std::nullopt};
}

// A change of the profile; nothing where it is no change.
void add_profile(std::string name, const std::function<void(Profile&)>& change, Variants& out) {
  out.push_back({std::move(name), [change](const Observation& seen) -> std::optional<ChangedRun> {
                   ChangedRun trial = same(seen);
                   change(trial.profile);
                   if (trial.profile == seen.profile) return std::nullopt;
                   return trial;
                 }});
}

void add_readings(std::string_view dialect, Variants& out) {
  for (const reference::Reading& reading : reference::readings()) {
    if (!reading.belongs_to(dialect) || reading.is_length || reading.by_properties) continue;
    for (const std::string_view value : reading.alternatives) {
      if (value == reading.fallback) continue;
      add_profile(
          fmt::format("the reading {} = {}", reading.name, value),
          [key = reading.key, value](Profile& profile) { profile.readings.set(key, value); }, out);
    }
  }
}

void add_program_leak(Variants& out) {
  out.push_back({"the feed of the program before is still in force",
                 [](const Observation& seen) -> std::optional<ChangedRun> {
                   if (!seen.before.feed) return std::nullopt;
                   ChangedRun trial = same(seen);
                   trial.profile.initial.feed = *seen.before.feed;
                   return trial;
                 }});
  out.push_back({"R parameters of the program before keep their values",
                 [](const Observation& seen) -> std::optional<ChangedRun> {
                   if (seen.before.parameters.empty()) return std::nullopt;
                   ChangedRun trial = same(seen);
                   std::string words;
                   for (const auto& [name, word] : seen.before.parameters) words += word + " ";
                   trial.program.insert(0, words);
                   return trial;
                 }});
}

}  // namespace

void Carried::take(const Profile& profile, std::string_view program, const KeptOutcome& outcome) {
  const bool alarmed = outcome.end.kind == oracle::RunEnd::Kind::alarm;
  std::uint64_t line = 0;
  for (const TextBlock& block : ProgramText(profile, program).blocks) {
    if (alarmed && ++line >= outcome.end.alarm.block) return;
    for (const TextWord& word : block.words) {
      const auto written = exact_value_of(word);
      if (!written) continue;
      const std::string name = name_of(word);
      if (name == "F" && !block.modes.is_of(Kind::dwell)) {
        feed = block.modes.inch ? *written * 127 / 5 : *written;
      }
      if (is_parameter(name)) parameters[name] = fmt::format("{}={}", name, written->text());
    }
  }
}

void add_machine_variants(const Observation& departure, Variants& out) {
  add_readings(departure.profile.dialect, out);
  add_profile(
      "the power-on units are inches where they are millimetres, and the other way round",
      [](Profile& profile) {
        const bool inch = profile.units == reference::Units::inch;
        profile.units = inch ? reference::Units::mm : reference::Units::inch;
      },
      out);
  add_profile(
      "X is a radius where it is a diameter, and the other way round",
      [](Profile& profile) { profile.x_diameter = !profile.x_diameter; }, out);
  add_profile(
      "lines with / are always left out", [](Profile& profile) { profile.block_skip = true; }, out);
  add_profile(
      "lines with / are never left out", [](Profile& profile) { profile.block_skip = false; }, out);
  add_profile(
      "the work offsets are not applied", [](Profile& profile) { profile.offsets.clear(); }, out);
  add_profile(
      "the reference point is the zero point of the machine",
      [](Profile& profile) { profile.reference_point = {}; }, out);
  add_profile(
      "the initial feed is not in force", [](Profile& profile) { profile.initial.feed = {}; }, out);
  for (const auto& [name, value] : departure.profile.parameters) {
    add_profile(
        fmt::format("the parameter {} is not looked at", name),
        [name](Profile& profile) { profile.parameters.erase(name); }, out);
  }
  add_program_leak(out);
}

}  // namespace gonogo::identify
