// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "fuzz/gsk_generator.hpp"
#include "fuzz/hnc_generator.hpp"
#include "fuzz/ngc_generator.hpp"
#include "fuzz/sinumerik_generator.hpp"

namespace gonogo::fuzz {

std::span<const Generator> generators() {
  static const auto kGenerators = std::to_array<Generator>({
      {"gsk988ta", "gsk",
       [](Choices& choices, Distribution* distribution) {
         return generate_gsk(choices, {}, distribution);
       }},
      {"hnc21t", "hnc",
       [](Choices& choices, Distribution* distribution) {
         return generate_hnc(choices, {}, distribution);
       }},
      {"rs274", "ngc",
       [](Choices& choices, Distribution* distribution) {
         return generate_ngc(choices, {}, distribution);
       }},
      {"sinumerik840d", "sinumerik",
       [](Choices& choices, Distribution* distribution) {
         return generate_sinumerik(choices, {}, distribution);
       }},
      {"sinumerik802s", "sinumerik",
       [](Choices& choices, Distribution* distribution) {
         SinumerikSettings settings;
         settings.dialect = "sinumerik802s";
         return generate_sinumerik(choices, settings, distribution);
       }},
  });
  return kGenerators;
}

const Generator* find_generator(std::string_view expander, std::string_view dialect) {
  const auto found = std::ranges::find_if(generators(), [&](const Generator& generator) {
    return generator.expander == expander && (dialect.empty() || generator.dialect == dialect);
  });
  return found == generators().end() ? nullptr : &*found;
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

}  // namespace gonogo::fuzz
