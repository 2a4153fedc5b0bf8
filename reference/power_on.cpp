// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/power_on.hpp"

#include <fmt/format.h>

#include <variant>

#include "reference/dialect.hpp"

namespace gonogo::reference {
namespace {

bool is_in_force(Setting setting, const Profile& profile) {
  switch (setting) {
    case Setting::plane_xy:
      return profile.initial.plane == Plane::g17;
    case Setting::plane_zx:
      return profile.initial.plane == Plane::g18;
    case Setting::plane_yz:
      return profile.initial.plane == Plane::g19;
    case Setting::inch:
      return profile.units == Units::inch;
    case Setting::metric:
      return profile.units == Units::mm;
    case Setting::diameter:
      return profile.x_diameter;
    case Setting::radius:
      return !profile.x_diameter;
    default:
      return false;
  }
}

}  // namespace

std::vector<const Code*> power_on_codes(const Profile& profile) {
  std::vector<const Code*> codes;
  for (const Code& code : find_dialect(profile.dialect)->descriptor->codes) {
    if (code.is_initial || is_in_force(code.setting, profile)) codes.push_back(&code);
  }
  return codes;
}

std::string power_on_text(std::string_view dialect) {
  const ProfileResult made = default_profile(dialect);
  const auto& profile = std::get<Profile>(made);
  std::string text;
  for (const Code* code : power_on_codes(profile)) text += code->text() + " ";
  const int motion = profile.initial.motion;
  return fmt::format("{}and {}; X is a {}; no feed, every axis at 0", text,
                     motion == kNoMotion ? "no motion" : fmt::format("G{:02}", motion),
                     profile.x_diameter ? "diameter" : "length");
}

}  // namespace gonogo::reference
