// SPDX-License-Identifier: GPL-3.0-or-later
//
// Profiles from TOML and JSON, and back to JSON. Both are read into one document first.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <nlohmann/json.hpp>
#include <set>

#include "reference/profile.hpp"

namespace gonogo::reference {
namespace {

using Json = nlohmann::json;

// Thrown inside this file only; the public functions return it as a value.
struct Fault {
  ProfileError error;
};

[[noreturn]] void fail(std::string key, std::string message) {
  throw Fault{{std::move(key), std::move(message)}};
}

Json from_toml_node(const toml::node& node, const std::string& key) {
  if (const toml::table* table = node.as_table()) {
    Json object = Json::object();
    for (const auto& [name, value] : *table) {
      std::string text(name.str());
      object[text] = from_toml_node(value, key.empty() ? text : key + "." + text);
    }
    return object;
  }
  if (auto text = node.value_exact<std::string>()) return *text;
  if (auto whole = node.value_exact<std::int64_t>()) return *whole;
  if (auto flag = node.value_exact<bool>()) return *flag;
  if (node.is_floating_point()) {
    fail(key, fmt::format("The value of {} is a floating-point number. Write it as a decimal in "
                          "quotes, for example {} = \"0.001\".",
                          key, key));
  }
  fail(key, fmt::format("The value of {} has a type that no key takes. Write a table, a text, a "
                        "whole number or true/false.",
                        key));
}

// nlohmann-json keeps the last of two equal keys; a profile that has two is refused.
Json parse_json_once(std::string_view text) {
  std::vector<std::set<std::string>> open;
  auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key &&
        !open.back().insert(parsed.get<std::string>()).second) {
      fail(parsed.get<std::string>(), "The key stands twice in one object. Keep one of them.");
    }
    return true;
  };
  return Json::parse(text, watch);
}

Number number_of(const Json& value, const std::string& key) {
  if (value.is_number_integer()) return Number(value.get<std::int64_t>());
  if (value.is_string()) {
    if (auto number = Number::parse(value.get<std::string>())) return *number;
  }
  fail(key, fmt::format("The value of {} is no exact number. Write a decimal in quotes, for "
                        "example \"0.001\".",
                        key));
}

std::string text_of(const Json& value, const std::string& key) {
  if (!value.is_string()) fail(key, fmt::format("The value of {} must be a text in quotes.", key));
  return value.get<std::string>();
}

bool flag_of(const Json& value, const std::string& key) {
  if (!value.is_boolean()) fail(key, fmt::format("The value of {} must be true or false.", key));
  return value.get<bool>();
}

void need_table(const Json& value, const std::string& key) {
  if (!value.is_object()) fail(key, fmt::format("The value of {} must be a table of keys.", key));
}

template <typename T>
T choice_of(const Json& value, const std::string& key,
            std::initializer_list<std::pair<std::string_view, T>> choices) {
  std::string text = value.is_number_integer() ? value.dump() : text_of(value, key);
  std::string known;
  for (const auto& [name, result] : choices) {
    if (name == text) return result;
    known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", name);
  }
  fail(key, fmt::format("The value of {} cannot be \"{}\". Write one of: {}.", key, text, known));
}

bool read_axis(const std::string& name, const Json& value, const std::string& key, Position& at) {
  for (Axis axis : kAllAxes) {
    if (name.size() == 1 && name[0] == letter(axis)) {
      at[axis] = number_of(value, key);
      return true;
    }
  }
  return false;
}

[[noreturn]] void unknown_key(const std::string& key, std::string_view known) {
  fail(key, fmt::format("There is no key {}. Write one of: {}.", key, known));
}

Position position_of(const Json& table, const std::string& key) {
  need_table(table, key);
  Position at;
  for (const auto& [name, value] : table.items()) {
    if (!read_axis(name, value, key + "." + name, at))
      unknown_key(key + "." + name, "x, y, z, a, c");
  }
  return at;
}

InitialState initial_of(const Json& table, InitialState initial) {
  need_table(table, "initial");
  for (const auto& [name, value] : table.items()) {
    std::string key = "initial." + name;
    if (read_axis(name, value, key, initial.at)) continue;
    if (name == "f") {
      initial.feed = number_of(value, key);
    } else if (name == "plane") {
      initial.plane = choice_of<Plane>(
          value, key, {{"G17", Plane::g17}, {"G18", Plane::g18}, {"G19", Plane::g19}});
    } else if (name == "motion") {
      initial.motion = choice_of<int>(value, key, {{"G00", 0}, {"G01", 1}});
    } else if (name == "spindle") {
      initial.spindle = choice_of<int>(value, key, {{"M3", 3}, {"M4", 4}, {"M5", 5}});
    } else {
      unknown_key(key, "x, y, z, a, c, f, plane, motion, spindle");
    }
  }
  return initial;
}

void read_tools(const Json& table, Profile& profile) {
  need_table(table, "tools");
  for (const auto& [name, value] : table.items()) {
    std::string key = "tools." + name;
    need_table(value, key);
    for (const auto& [field, radius] : value.items()) {
      if (field != "radius") unknown_key(key + "." + field, "radius");
      profile.tools[name] = number_of(radius, key + ".radius");
    }
  }
}

void read_key(const std::string& name, const Json& value, Profile& profile) {
  if (name == "dialect") return;  // taken first
  if (name == "units") {
    profile.units = choice_of<Units>(value, name, {{"mm", Units::mm}, {"inch", Units::inch}});
  } else if (name == "increment") {
    profile.increment =
        choice_of<Increment>(value, name, {{"ISB", Increment::isb}, {"ISC", Increment::isc}});
  } else if (name == "resolution") {
    profile.given_resolution = number_of(value, name);
    if (profile.given_resolution->sign() <= 0) fail(name, "The resolution must be above zero.");
  } else if (name == "x_diameter") {
    profile.x_diameter = flag_of(value, name);
  } else if (name == "block_skip") {
    profile.block_skip = flag_of(value, name);
  } else if (name == "initial") {
    profile.initial = initial_of(value, profile.initial);
  } else if (name == "reference_point") {
    profile.reference_point = position_of(value, name);
  } else if (name == "alarm_timing") {
    profile.alarm_timing = choice_of<AlarmTiming>(
        value, name, {{"block", AlarmTiming::block}, {"program", AlarmTiming::program}});
  } else if (name == "offsets") {
    need_table(value, name);
    for (const auto& [offset, at] : value.items()) {
      profile.offsets[offset] = position_of(at, "offsets." + offset);
    }
  } else if (name == "tools") {
    read_tools(value, profile);
  } else if (name == "parameters") {
    need_table(value, name);
    for (const auto& [parameter, number] : value.items()) {
      profile.parameters[parameter] = number_of(number, "parameters." + parameter);
    }
  } else if (name == "readings") {
    need_table(value, name);
    for (const auto& [reading, choice] : value.items()) {
      std::string text = text_of(choice, "readings." + reading);
      if (auto error = set_reading(profile, reading, text)) throw Fault{*error};
    }
  } else {
    unknown_key(name,
                "dialect, units, increment, resolution, x_diameter, initial, offsets, tools, "
                "parameters, reference_point, readings, alarm_timing, block_skip");
  }
}

// TOML reads "gsk.pocket.end" = ... in quotes as one key; people forget the quotes.
Json flatten_readings(const Json& table, const std::string& prefix) {
  Json flat = Json::object();
  for (const auto& [name, value] : table.items()) {
    std::string key = prefix.empty() ? name : prefix + "." + name;
    if (value.is_object()) {
      flat.update(flatten_readings(value, key));
    } else {
      flat[key] = value;
    }
  }
  return flat;
}

Profile profile_of(Json document) {
  need_table(document, "profile");
  std::string dialect = "gsk988ta";
  if (document.contains("dialect")) dialect = text_of(document["dialect"], "dialect");
  ProfileResult start = default_profile(dialect);
  if (auto* error = std::get_if<ProfileError>(&start)) throw Fault{*error};
  Profile profile = std::get<Profile>(std::move(start));
  if (document.contains("readings") && document["readings"].is_object()) {
    document["readings"] = flatten_readings(document["readings"], "");
  }
  for (const auto& [name, value] : document.items()) read_key(name, value, profile);
  return profile;
}

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
  document["initial"]["motion"] = fmt::format("G{:02}", profile.initial.motion);
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

template <typename Read>
ProfileResult guarded(Read read) {
  try {
    return profile_of(read());
  } catch (const Fault& fault) {
    return fault.error;
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    return ProfileError{"", fmt::format("The profile is no TOML: line {}, column {}: {}.", at.line,
                                        at.column, error.description())};
  } catch (const Json::exception& error) {
    return ProfileError{"", fmt::format("The profile is no JSON: {}.", error.what())};
  }
}

}  // namespace

ProfileResult profile_from_toml(std::string_view text) {
  return guarded([&] { return from_toml_node(toml::parse(text), ""); });
}

ProfileResult profile_from_json(std::string_view text) {
  return guarded([&] { return parse_json_once(text); });
}

std::string profile_json(const Profile& profile) {
  Profile base = std::get<Profile>(default_profile(profile.dialect));
  return without_defaults(whole_json(profile), whole_json(base)).dump();
}

}  // namespace gonogo::reference
