// SPDX-License-Identifier: GPL-3.0-or-later
#include "hnc_expanding.hpp"

#include <stdexcept>

namespace gonogo::reference::testing::hnc {

Profile hnc(std::initializer_list<std::pair<std::string_view, std::string_view>> readings) {
  Profile profile = std::get<Profile>(default_profile("hnc21t"));
  for (const auto& [name, value] : readings) {
    if (auto error = set_reading(profile, name, value)) throw std::invalid_argument(error->message);
  }
  return profile;
}

Lines path(std::string_view program, const Profile& profile) {
  Lines all = lines(program, profile);
  std::erase_if(all, [](const std::string& line) { return line.starts_with('m'); });
  return all;
}

Lines cycle(const std::string& start, const std::string& blocks, const Profile& profile) {
  Lines all = path(start + "\n" + blocks, profile);
  all.erase(all.begin());
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

}  // namespace gonogo::reference::testing::hnc
