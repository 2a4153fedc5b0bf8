// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/profile.hpp"

#include <fmt/format.h>

#include "reference/dialect.hpp"
#include "reference/nearest_word.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::reference {

Number Profile::resolution() const {
  if (given_resolution) return *given_resolution;
  if (dialect_resolution) return *dialect_resolution;
  return increment == Increment::isc ? Number::millionths(100) : Number::millionths(1000);
}

bool Profile::takes_cr_for_blank() const {
  return readings.is("ngc.lone-cr=blank"_reading);
}

std::optional<Number> Profile::parameter(std::string_view name) const {
  auto found = parameters.find(std::string(name));
  if (found == parameters.end()) return std::nullopt;
  return found->second;
}

ProfileResult default_profile(std::string_view dialect) {
  if (find_dialect(dialect) == nullptr) {
    return ProfileError{"dialect", fmt::format("There is no dialect \"{}\". Write one of: {}.",
                                               dialect, dialect_names())};
  }
  Profile profile;
  profile.dialect = dialect;
  find_dialect(dialect)->power_on(profile);
  return profile;
}

namespace {

// "Did you mean gsk.g94.after-00? "
std::string meant(std::string_view name, std::string_view dialect) {
  std::vector<std::string> known;
  for (const Reading& reading : readings()) {
    if (reading.belongs_to(dialect)) known.emplace_back(reading.name);
  }
  return did_you_mean(nearest_word(std::string(name), known));
}

}  // namespace

std::optional<ProfileError> set_reading(Profile& profile, std::string_view name,
                                        std::string_view value) {
  const Reading* found = find_reading(name);
  std::string key = fmt::format("readings.{}", name);
  if (found == nullptr || !found->belongs_to(profile.dialect)) {
    return ProfileError{
        key,
        fmt::format(
            "There is no reading \"{}\" in dialect {}. {}`gonogo spec --dialect {}` lists them.",
            name, profile.dialect, meant(name, profile.dialect), profile.dialect)};
  }
  if (!admits(*found, value)) {
    std::string choices = found->is_length ? std::string("a length in mm") : std::string("any");
    if (!found->is_length) {
      for (std::string_view alternative : found->alternatives) {
        choices += fmt::format(", {}", alternative);
      }
    }
    return ProfileError{key, fmt::format("The reading {} cannot be \"{}\". Write one of: {}.", name,
                                         value, choices)};
  }
  profile.readings.set(found->key, value);
  return std::nullopt;
}

}  // namespace gonogo::reference
