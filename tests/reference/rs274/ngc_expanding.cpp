// SPDX-License-Identifier: GPL-3.0-or-later
#include "ngc_expanding.hpp"
#include "reference/reading_literal.hpp"

#include <stdexcept>

namespace gonogo::reference::testing::ngc {

Profile ngc(std::initializer_list<std::pair<std::string_view, std::string_view>> readings) {
  Profile profile = std::get<Profile>(default_profile("rs274"));
  profile.readings.set("ngc.program-end=free"_reading);
  for (const auto& [name, value] : readings) {
    if (auto error = set_reading(profile, name, value)) throw std::invalid_argument(error->message);
  }
  return profile;
}

Profile linuxcnc() {
  return ngc({{"ngc.arc-tolerance", "linuxcnc"}});
}

Lines path(std::string_view program, const Profile& profile) {
  Lines all = lines(program, profile);
  std::erase_if(all, [](const std::string& line) { return line.starts_with('m'); });
  return all;
}

std::string ending_of(std::string_view program, const Profile& profile) {
  return ending(program, profile);
}

Lines clauses(std::string_view program, const Profile& profile) {
  return clauses_of(program, profile);
}

Lines touched(std::string_view program, const Profile& profile) {
  return touched_readings(program, profile);
}

}  // namespace gonogo::reference::testing::ngc
