// SPDX-License-Identifier: GPL-3.0-or-later
#include "subjects/configuration.hpp"

#include <fmt/format.h>

#include "oracle/records/text.hpp"

namespace gonogo::oracle {

Told told(const SubjectInfo& info, const reference::Profile& profile, const StatedMachine& stated) {
  Told told{profile, {}};
  const reference::Profile machine = stated.of(profile.dialect);
  for (const reference::Reading& reading : reference::readings()) {
    if (!reading.belongs_to(profile.dialect) || info.knows(reading)) continue;
    const std::string_view value = profile.readings.get(reading.key);
    told.profile.readings.set(reading.key, reading.fallback);
    const bool is_asked = value != "any" && value != reading.fallback;
    if (!is_asked || value == machine.readings.get(reading.key)) continue;
    told.silent = RunEnd::of(
        RunEnd::Kind::refused,
        fmt::format("The subject does not say that it knows the reading {}; it cannot be set to "
                    "{}.",
                    reading.name, value));
  }
  return told;
}

std::string configuration_members(const reference::Profile& profile) {
  std::string out = "\"dialect\":";
  append_json_string(profile.dialect, out);
  out += ",\"profile\":";
  out += reference::profile_json(profile);
  return out;
}

}  // namespace gonogo::oracle
