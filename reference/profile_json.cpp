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

Json tool_json(const Tool& tool) {
  Json object = Json::object();
  const bool has_length = tool.length.sign() != 0;
  if (tool.radius.sign() != 0 || !has_length) object["radius"] = number_text(tool.radius);
  if (has_length) object["length"] = number_text(tool.length);
  return object;
}

// Key by key, what is not in `base`.
template <typename Value, typename ToJson>
void add_changed(Json& document, const char* member, const std::map<std::string, Value>& values,
                 const std::map<std::string, Value>& base, ToJson to_json) {
  for (const auto& [name, value] : values) {
    const auto known = base.find(name);
    if (known == base.end() || known->second != value) document[member][name] = to_json(value);
  }
}

void add_position(Json& document, const char* member, const Position& at, const Position& base) {
  for (Axis axis : kAllAxes) {
    if (at[axis] == base[axis]) continue;
    document[member][std::string(1, letter(axis))] = number_text(at[axis]);
  }
}

void add_initial(Json& document, const InitialState& initial, const InitialState& base) {
  add_position(document, "initial", initial.at, base.at);
  const auto add = [&](const char* name, std::string value) {
    document["initial"][name] = std::move(value);
  };
  if (initial.feed != base.feed) add("f", number_text(initial.feed));
  if (initial.plane != base.plane) add("plane", fmt::format("G{}", plane_code(initial.plane)));
  if (initial.motion != base.motion) {
    add("motion",
        initial.motion == kNoMotion ? std::string("none") : fmt::format("G{:02}", initial.motion));
  }
  if (initial.spindle != base.spindle) add("spindle", fmt::format("M{}", initial.spindle));
}

void add_readings(Json& document, const Profile& profile, const Profile& base) {
  if (profile.readings == base.readings) return;
  for (const Reading& reading : readings()) {
    if (!reading.belongs_to(profile.dialect)) continue;
    const std::string_view value = profile.readings.get(reading.key);
    if (value == base.readings.get(reading.key)) continue;
    document["readings"][std::string(reading.name)] = value;
  }
}

}  // namespace

std::string profile_json(const Profile& profile) {
  const Profile base = std::get<Profile>(default_profile(profile.dialect));
  Json document = Json::object();
  if (profile.units != base.units) document["units"] = profile.units == Units::mm ? "mm" : "inch";
  if (profile.increment != base.increment) {
    document["increment"] = profile.increment == Increment::isb ? "ISB" : "ISC";
  }
  if (profile.given_resolution) document["resolution"] = number_text(*profile.given_resolution);
  if (profile.x_diameter != base.x_diameter) document["x_diameter"] = profile.x_diameter;
  add_initial(document, profile.initial, base.initial);
  add_changed(document, "offsets", profile.offsets, base.offsets, position_json);
  add_changed(document, "tools", profile.tools, base.tools, tool_json);
  add_changed(document, "parameters", profile.parameters, base.parameters, number_text);
  add_position(document, "reference_point", profile.reference_point, base.reference_point);
  add_readings(document, profile, base);
  if (profile.alarm_timing != base.alarm_timing) {
    document["alarm_timing"] = profile.alarm_timing == AlarmTiming::block ? "block" : "program";
  }
  if (profile.block_skip != base.block_skip) document["block_skip"] = profile.block_skip;
  return document.dump();
}

}  // namespace gonogo::reference
