// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/subject_outcome.hpp"

namespace gonogo::oracle {

bool SubjectInfo::declares(std::string_view dialect, std::string_view feature) const {
  if (everything || features.contains(std::string(feature))) return true;
  const auto found = dialects.find(std::string(dialect));
  if (found == dialects.end()) return false;
  return feature.empty() || found->second.empty() || found->second.contains(std::string(feature));
}

bool SubjectInfo::knows(const reference::Reading& reading) const {
  return readings.contains("*") || readings.contains(std::string(reading.name));
}

}  // namespace gonogo::oracle
