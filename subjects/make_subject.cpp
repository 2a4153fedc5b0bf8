// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/make_subject.hpp"

namespace gonogo::oracle {

reference::Profile StatedMachine::of(const std::string& dialect) const {
  reference::Profile machine =
      profile && profile->dialect == dialect
          ? *profile
          : std::get<reference::Profile>(reference::default_profile(dialect));
  for (const std::string& choice : readings) {
    const std::size_t equals = choice.find('=');
    const reference::Reading* reading = reference::find_reading(choice.substr(0, equals));
    if (reading == nullptr || !reading->belongs_to(dialect)) continue;
    machine.readings.set(reading->key, choice.substr(equals + 1));
  }
  return machine;
}

std::optional<SubjectSpec> parse_subject_spec(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || colon == 0 || colon + 1 == text.size()) {
    return std::nullopt;
  }
  const std::string_view kind = text.substr(0, colon);
  if (kind.find_first_not_of("abcdefghijklmnopqrstuvwxyz") != std::string_view::npos) {
    return std::nullopt;
  }
  return SubjectSpec{std::string(kind), std::string(text.substr(colon + 1))};
}

}  // namespace gonogo::oracle
