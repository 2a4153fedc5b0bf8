// SPDX-License-Identifier: GPL-3.0-or-later
//
// Readings: named choices where a manual is open or contradicts itself.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/catalog/gsk988ta_readings.hpp"
#include "reference/catalog/hnc21t_readings.hpp"
#include "reference/catalog/rs274_cycle_readings.hpp"
#include "reference/catalog/rs274_readings.hpp"
#include "reference/catalog/sinumerik_readings.hpp"
#include "reference/exact/number.hpp"

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
constexpr std::size_t index(ReadingKey key) {
  return static_cast<std::size_t>(key);
}

// One alternative of a reading, or its "any".
struct ReadingAlternative {
  ReadingKey key;
  std::uint8_t place;  // 0: "any"; else the place among the alternatives, from 1
};

std::span<const Reading> readings();
const Reading& reading(ReadingKey key);
const Reading* find_reading(std::string_view name);
// Whether `value` is one of the reading's alternatives or "any".
bool admits(const Reading& reading, std::string_view value);

// The value of each reading, "any" among them; what a profile says. Small: a campaign copies one
// with every case.
class ReadingChoice {
 public:
  ReadingChoice();  // the defaults
  std::string_view get(ReadingKey key) const;
  void set(ReadingKey key, std::string_view value);
  void set(ReadingAlternative value) { put(value.key, value.place); }
  bool is(ReadingKey key, std::string_view value) const { return get(key) == value; }
  bool is(ReadingAlternative value) const { return places_[index(value.key)] == value.place; }
  // The same choice, where each open "any" that is not judged by properties has the alternative
  // that `expand` shows.
  ReadingChoice shown() const;
  friend bool operator==(const ReadingChoice&, const ReadingChoice&) = default;

 private:
  // A place in the reading's list of values: "any", the alternatives, the default where it is
  // neither; or kOwnText.
  using Place = std::uint8_t;
  static constexpr Place kAny = 0;
  static constexpr Place kFirst = 1;
  static constexpr Place kFallback = 254;
  static constexpr Place kOwnText = 255;
  using OwnText = std::pair<ReadingKey, std::string>;
  static Place place_of(const Reading& reading, std::string_view value);
  void put(ReadingKey key, Place place);

  std::array<Place, kReadings> places_;
  std::vector<OwnText> texts_;  // lengths, by key
};

// The readings as one run of the reference sees them; remembers which of them mattered.
class ReadingsInUse {
 public:
  explicit ReadingsInUse(const ReadingChoice& choice) : shown_(choice.shown()) {}
  // Whether the alternative holds. An open "any" that is not judged by properties counts as the
  // alternative that `expand` shows.
  bool is(ReadingAlternative value) const {
    touch(value.key);
    return shown_.is(value);
  }
  exact::Number length(ReadingKey key) const;
  // The reading mattered, with any value.
  void touch(ReadingKey key) const {
    if (!std::exchange(touched_[index(key)], true)) ++count_;
  }
  bool touched(ReadingKey key) const { return touched_[index(key)]; }
  std::vector<ReadingKey> touched() const;
  std::size_t touched_count() const { return count_; }
  void forget_touched() {
    touched_.fill(false);
    count_ = 0;
  }

 private:
  ReadingChoice shown_;
  mutable std::array<bool, kReadings> touched_{};
  mutable std::size_t count_ = 0;
};

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
