// SPDX-License-Identifier: GPL-3.0-or-later
//
// Profiles from TOML and JSON. Both are read into one document first.
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "reference/dialect.hpp"
#include "reference/toml_text.hpp"

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

// `byte`: the place of what cannot be read, from 1.
[[noreturn]] void fail_at(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte == 0 ? 0 : byte - 1);
  const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;
  fail("", fmt::format("The profile is no JSON: line {}, column {} cannot be read.",
                       std::ranges::count(before, '\n') + 1, column));
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
  try {
    return Json::parse(text, watch);
  } catch (const Json::parse_error& error) {
    fail_at(text, error.byte);
  }
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
      initial.motion = choice_of<int>(value, key, {{"G00", 0}, {"G01", 1}, {"none", kNoMotion}});
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
    if (name.empty() || name.find_first_not_of("0123456789") != std::string::npos) {
      fail(key, fmt::format("\"{}\" is no tool number. Write the digits after T or D.", name));
    }
    Tool& tool = profile.tools[name];
    for (const auto& [field, number] : value.items()) {
      const std::string whole_key = key + "." + field;
      if (field == "radius") {
        tool.radius = number_of(number, whole_key);
        if (tool.radius.sign() < 0) fail(whole_key, "A radius cannot be negative.");
      } else if (field == "length") {
        tool.length = number_of(number, whole_key);
      } else {
        unknown_key(whole_key, "radius, length");
      }
    }
  }
}

void read_offsets(const Json& table, Profile& profile) {
  need_table(table, "offsets");
  const auto known = find_dialect(profile.dialect)->offsets;
  for (const auto& [name, at] : table.items()) {
    const std::string key = "offsets." + name;
    if (std::ranges::find(known, name) == known.end()) {
      if (known.empty()) fail(key, profile.dialect + " has no work offsets in a profile.");
      unknown_key(key, fmt::format("{}", fmt::join(known, ", ")));
    }
    profile.offsets[name] = position_of(at, key);
  }
}

void read_parameters(const Json& table, Profile& profile) {
  need_table(table, "parameters");
  const auto known = find_dialect(profile.dialect)->parameters;
  for (const auto& [name, number] : table.items()) {
    const std::string key = "parameters." + name;
    if (std::ranges::find(known, name) == known.end()) {
      unknown_key(key, fmt::format("{}", fmt::join(known, ", ")));
    }
    profile.parameters[name] = number_of(number, key);
  }
}

bool has_code_of_diameters(const std::string& dialect) {
  return std::ranges::any_of(find_dialect(dialect)->descriptor->codes,
                             [](const Code& code) { return code.setting == Setting::diameter; });
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
    // Where X is a length at power-on, and a code makes it a diameter as G7 does, a program says
    // so.
    const bool may_be = profile.x_diameter || !has_code_of_diameters(profile.dialect);
    profile.x_diameter = flag_of(value, name);
    if (profile.x_diameter && !may_be) {
      fail(name, fmt::format("X of {} is a length at power-on. Leave it out, or write false.",
                             profile.dialect));
    }
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
    read_offsets(value, profile);
  } else if (name == "tools") {
    read_tools(value, profile);
  } else if (name == "parameters") {
    read_parameters(value, profile);
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

Profile profile_of(Json document, std::string dialect) {
  need_table(document, "profile");
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

template <typename Read>
ProfileResult guarded(Read read, std::string_view text, std::string_view unnamed) {
  try {
    return profile_of(read(), std::string(unnamed));
  } catch (const Fault& fault) {
    return fault.error;
  } catch (const toml::parse_error& error) {
    return ProfileError{"", toml_fault(text, error)};
  } catch (const Json::exception& error) {
    return ProfileError{"", fmt::format("The profile is no JSON: {}.", error.what())};
  }
}

void add_keys(const Json& table, const ProfileKey& above, std::vector<ProfileKey>& keys) {
  for (const auto& [name, value] : table.items()) {
    ProfileKey key = above;
    key.push_back(name);
    if (value.is_object()) {
      add_keys(value, key, keys);
    } else {
      keys.push_back(std::move(key));
    }
  }
}

std::vector<ProfileKey> keys_of(Json document) {
  if (document.contains("readings")) {
    document["readings"] = flatten_readings(document["readings"], "");
  }
  std::vector<ProfileKey> keys;
  add_keys(document, {}, keys);
  return keys;
}

}  // namespace

std::vector<ProfileKey> keys_of_toml(std::string_view text) {
  return keys_of(from_toml_node(parse_toml(text), ""));
}

std::vector<ProfileKey> keys_of_json(std::string_view text) {
  return keys_of(parse_json_once(text));
}

ProfileResult profile_from_toml(std::string_view text, std::string_view unnamed) {
  return guarded([&] { return from_toml_node(parse_toml(text), ""); }, text, unnamed);
}

ProfileResult profile_from_json(std::string_view text, std::string_view unnamed) {
  return guarded([&] { return parse_json_once(text); }, text, unnamed);
}

}  // namespace gonogo::reference
