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

#include "reference/catalog/reading.hpp"
#include "reference/exact/number.hpp"

namespace gonogo::reference {

// As many as a key distinguishes.
inline constexpr std::size_t kMostReadings = 256;
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

  std::array<Place, kMostReadings> places_;
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
  mutable std::array<bool, kMostReadings> touched_{};
  mutable std::size_t count_ = 0;
};

}  // namespace gonogo::reference
