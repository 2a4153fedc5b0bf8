// SPDX-License-Identifier: GPL-3.0-or-later
//
// The machine profile: what a certifier says of the machine. TOML for people, the same keys as
// JSON on the wire. Decimals are strings, so that no number passes through binary floating point.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "reference/axis.hpp"
#include "reference/reading.hpp"
#include "reference/record.hpp"

namespace gonogo::reference {

enum class Units : std::uint8_t { mm, inch };
enum class Increment : std::uint8_t { isb, isc };
enum class AlarmTiming : std::uint8_t { block, program };

inline constexpr int kNoMotion = -1;

// The state at the start of a program.
struct InitialState {
  Position at;  // mm as true lengths, degrees
  Number feed;  // 0: none in force
  Plane plane = Plane::g18;
  int motion = 0;   // code of the motion group; kNoMotion: none
  int spindle = 5;  // M3, M4 or M5
  friend bool operator==(const InitialState&, const InitialState&) = default;
};

// mm.
struct Tool {
  Number radius;
  Number length;  // of G43, along Z
  friend bool operator==(const Tool&, const Tool&) = default;
};

struct Profile {
  std::string dialect = "gsk988ta";
  Units units = Units::mm;
  Increment increment = Increment::isb;
  std::optional<Number> given_resolution;    // `resolution`
  std::optional<Number> dialect_resolution;  // where it does not follow from `increment`
  bool x_diameter = true;
  InitialState initial;
  std::map<std::string, Position> offsets;   // "G54" -> mm
  std::map<std::string, Tool> tools;         // by their numbers
  std::map<std::string, Number> parameters;  // "3410" -> value
  Position reference_point;                  // of G28, mm, in coordinates of the machine
  ReadingChoice readings;
  AlarmTiming alarm_timing = AlarmTiming::block;
  bool block_skip = false;

  // The least increment, mm.
  Number resolution() const;
  std::optional<Number> parameter(std::string_view name) const;
  // NGC-COM-13: a carriage return alone ends no line.
  bool takes_cr_for_blank() const;
  friend bool operator==(const Profile&, const Profile&) = default;
};

// Why a profile cannot be used, and what to write instead.
struct ProfileError {
  std::string key;
  std::string message;
};

using ProfileResult = std::variant<Profile, ProfileError>;
// `unnamed`: the dialect of a text that has no key `dialect`.
inline constexpr std::string_view kUnnamedDialect = "gsk988ta";
ProfileResult profile_from_toml(std::string_view text, std::string_view unnamed = kUnnamedDialect);
ProfileResult profile_from_json(std::string_view text, std::string_view unnamed = kUnnamedDialect);
// Where a key of a profile stands: {"initial", "f"}, {"readings", "ngc.arc-tolerance"}.
using ProfileKey = std::vector<std::string>;
// The keys that the text has, those that repeat a default too. REQUIRES: it is a profile.
std::vector<ProfileKey> keys_of_toml(std::string_view text);
std::vector<ProfileKey> keys_of_json(std::string_view text);
// The power-on state of a dialect; an error for an unknown one.
ProfileResult default_profile(std::string_view dialect);
// The keys that differ from the dialect's defaults, as one JSON object with `dialect` left out.
std::string profile_json(const Profile& profile);

// Sets one reading as `--reading k=v` does.
std::optional<ProfileError> set_reading(Profile& profile, std::string_view name,
                                        std::string_view value);

}  // namespace gonogo::reference
