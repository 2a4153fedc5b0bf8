// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts as the files of a campaign have them.
#pragma once

#include <nlohmann/json.hpp>

#include "fuzz/hunt/hunt.hpp"

namespace gonogo::hunt {

inline nlohmann::ordered_json count_json(const HuntCount& count) {
  nlohmann::ordered_json json;
  for (const auto& [name, member] : kHuntCounts) json[name] = count.*member;
  return json;
}

inline nlohmann::ordered_json features_json(const FeatureCounts& features) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [feature, count] : features) {
    json[feature] = {
        {"judged", count.judged}, {"skipped", count.skipped}, {"no_go", count.no_go}};
  }
  return json;
}

}  // namespace gonogo::hunt
