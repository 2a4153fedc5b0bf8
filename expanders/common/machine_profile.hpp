// SPDX-License-Identifier: GPL-3.0-or-later
// The machine that a profile describes, and what a maker accepts of one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "expanders/common/axes.hpp"

namespace gonogo::expanders {

/// A reading and its alternatives, "standard|other|another": the first is the standard machine's,
/// which is also taken where the profile leaves the reading open.
struct ReadingChoices {
  std::string_view key;
  std::string_view alternatives;
};

/// One alternative, by its places in the maker's table.
struct Reading {
  std::uint8_t reading = 0;
  std::uint8_t alternative = 0;
};

/// The place of `name` in "one|two|three", from 0; -1: it is not there.
constexpr int place_in(std::string_view list, std::string_view name) {
  for (int place = 0;; ++place) {
    const std::size_t bar = list.find('|');
    if (list.substr(0, bar) == name) return place;
    if (bar == std::string_view::npos) return -1;
    list.remove_prefix(bar + 1);
  }
}

inline constexpr std::size_t kMostReadings = 64;  // of one maker

/// "key=alternative"; the build fails where there is none. A maker's `"..."_reading`.
consteval Reading find_reading(std::span<const ReadingChoices> table, std::string_view name) {
  if (table.size() > kMostReadings) throw std::invalid_argument("too many readings");
  const std::size_t equals = name.find('=');
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].key != name.substr(0, equals)) continue;
    const int place = place_in(table[i].alternatives, name.substr(equals + 1));
    if (place < 0) break;
    return {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(place)};
  }
  throw std::invalid_argument("no reading has this alternative");
}

/// The alternatives that a machine follows.
class Readings {
 public:
  bool follows(Reading reading) const { return taken_[reading.reading] == reading.alternative; }
  void take(Reading reading) { taken_[reading.reading] = reading.alternative; }

 private:
  std::array<std::uint8_t, kMostReadings> taken_{};
};

inline constexpr std::size_t kOffsets = 6;  // G54 to G59

/// The machine: what its parameters and options fix. Lengths are true millimetres.
struct MachineProfile {
  std::string_view dialect;
  bool block_skip = false;
  bool fine = false;  ///< the finer of two least increments
  bool x_diameter = false;
  Point reference_point{};
  std::array<Point, kOffsets> offsets{};
  std::map<Fixed, Fixed> tools;       ///< radius by number
  std::array<Fixed, 4> parameters{};  ///< in the order of the maker's table
  Readings readings;

  // State at power-on.
  bool inch = false;
  Point position{};
  Fixed feed = 0;
  int plane = 17;
  int motion = -1;  ///< number of the G code; below 0: none was said
  bool spindle_turns = false;
  int spindle = 5;  ///< M3, M4 or M5
};

/// A machine parameter that is a number.
struct ParameterRow {
  std::string_view key;
  Fixed standard = 0;
  Fixed least = 0;
  Fixed most = kLargest;
};

/// What a maker's control has.
struct ProfileTable {
  MachineProfile standard;
  std::string_view own_keys;  ///< "increment|x_diameter|...", of those that not every maker has
  std::string_view planes = "17|18|19";
  std::string_view motions;  ///< G codes that may be in force at power-on
  std::span<const ParameterRow> parameters;
  std::span<const ReadingChoices> readings;
  Fixed reach = kLargest;  ///< no length is larger
};

enum class ProfileResult { kRead, kUnsupported, kMalformed };

/// Reads {"dialect", "profile"} for the maker whose dialect it is; the first, where none is named.
/// When it cannot, `message` says what is not implemented or wrong.
ProfileResult read_profile(std::string_view json, std::span<const ProfileTable> tables,
                           MachineProfile& profile, std::string& message);

}  // namespace gonogo::expanders
