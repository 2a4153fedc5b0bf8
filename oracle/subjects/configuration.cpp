// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/subjects/configuration.hpp"

#include "oracle/records/text.hpp"

namespace gonogo::oracle {

std::string configuration_members(const reference::Profile& profile) {
  std::string out = "\"dialect\":";
  append_json_string(profile.dialect, out);
  out += ",\"profile\":";
  out += reference::profile_json(profile);
  return out;
}

}  // namespace gonogo::oracle
