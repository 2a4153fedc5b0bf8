// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readings by name, for those who ask for one: to read them costs a compiler a second.
#pragma once

#include "reference/catalog/gsk988ta_readings.hpp"
#include "reference/catalog/hnc21t_readings.hpp"
#include "reference/catalog/rs274_cycle_readings.hpp"
#include "reference/catalog/rs274_readings.hpp"
#include "reference/catalog/sinumerik_readings.hpp"
#include "reference/reading.hpp"

namespace gonogo::reference {

namespace catalog {

// The readings of all dialects, one table after the other, each with its place.
inline constexpr auto kReadings = [] {
  auto all = joined(kGskReadings, kHncReadings, kNgcReadings, kNgcCycleReadings,
                    kSinumerikPathReadings, kSinumerikCycleReadings);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].key = static_cast<ReadingKey>(i);
  return all;
}();

}  // namespace catalog

inline constexpr std::size_t kReadings = catalog::kReadings.size();
static_assert(kReadings <= kMostReadings);

}  // namespace gonogo::reference

namespace gonogo {

// "gsk.pocket.end"_key: the place of a reading in the table, checked when compiling.
consteval reference::ReadingKey operator""_key(const char* name, std::size_t size) {
  for (const reference::Reading& reading : reference::catalog::kReadings) {
    if (reading.name == std::string_view(name, size)) return reading.key;
  }
  throw "no such reading";
}

// "gsk.pocket.end=initial"_reading: an alternative of a reading, or "any", checked when compiling.
consteval reference::ReadingAlternative operator""_reading(const char* text, std::size_t size) {
  const std::string_view words(text, size);
  const std::size_t equals = words.find('=');
  for (const reference::Reading& reading : reference::catalog::kReadings) {
    if (reading.name != words.substr(0, equals)) continue;
    const std::string_view value = words.substr(equals + 1);
    if (value == "any") return {reading.key, 0};
    for (std::size_t i = 0; i < reading.alternatives.size(); ++i) {
      if (reading.alternatives[i] == value) return {reading.key, static_cast<std::uint8_t>(i + 1)};
    }
  }
  throw "no such reading or alternative";
}

}  // namespace gonogo
