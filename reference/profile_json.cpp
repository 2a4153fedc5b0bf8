// SPDX-License-Identifier: GPL-3.0-or-later
//
// A profile as JSON: what differs from the dialect's defaults.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reference/profile.hpp"

namespace gonogo::reference {
namespace {

using Json = nlohmann::json;

std::string number_text(const Number& value) {
  return value.text();
}

Json position_json(const Position& at) {
  Json object = Json::object();
  for (Axis axis : kAllAxes) object[std::string(1, letter(axis))] = number_text(at[axis]);
  return object;
}

Json whole_json(const Profile& profile) {
  Json document;
  document["units"] = profile.units == Units::mm ? "mm" : "inch";
  document["increment"] = profile.increment == Increment::isb ? "ISB" : "ISC";
  if (profile.given_resolution) document["resolution"] = number_text(*profile.given_resolution);
  document["x_diameter"] = profile.x_diameter;
  document["initial"] = position_json(profile.initial.at);
  document["initial"]["f"] = number_text(profile.initial.feed);
  document["initial"]["plane"] = fmt::format("G{}", plane_code(profile.initial.plane));
  document["initial"]["motion"] = profile.initial.motion == kNoMotion
                                      ? std::string("none")
                                      : fmt::format("G{:02}", profile.initial.motion);
  document["initial"]["spindle"] = fmt::format("M{}", profile.initial.spindle);
  document["offsets"] = Json::object();
  for (const auto& [name, at] : profile.offsets) document["offsets"][name] = position_json(at);
  document["tools"] = Json::object();
  for (const auto& [name, radius] : profile.tools) {
    document["tools"][name]["radius"] = number_text(radius);
  }
  document["parameters"] = Json::object();
  for (const auto& [name, value] : profile.parameters) {
    document["parameters"][name] = number_text(value);
  }
  document["reference_point"] = position_json(profile.reference_point);
  for (const Reading& reading : readings()) {
    if (!reading.belongs_to(profile.dialect)) continue;
    document["readings"][std::string(reading.name)] = profile.readings.get(reading.key);
  }
  document["alarm_timing"] = profile.alarm_timing == AlarmTiming::block ? "block" : "program";
  document["block_skip"] = profile.block_skip;
  return document;
}

// Drops what `base` says too, key by key, one level deep.
Json without_defaults(const Json& document, const Json& base) {
  Json kept = Json::object();
  for (const auto& [name, value] : document.items()) {
    if (!base.contains(name)) {
      kept[name] = value;
    } else if (value.is_object()) {
      Json inner = without_defaults(value, base[name]);
      if (!inner.empty()) kept[name] = inner;
    } else if (value != base[name]) {
      kept[name] = value;
    }
  }
  return kept;
}

}  // namespace

std::string profile_json(const Profile& profile) {
  const Profile base = std::get<Profile>(default_profile(profile.dialect));
  if (profile == base) return "{}";
  return without_defaults(whole_json(profile), whole_json(base)).dump();
}

}  // namespace gonogo::reference
