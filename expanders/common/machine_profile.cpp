// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/common/machine_profile.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

namespace gonogo::expanders {
namespace {

using Json = nlohmann::json;

std::string text_of(const Json& json) {
  return json.is_string() ? json.get<std::string>() : json.dump();
}

// "G18", "M3", "18" or 18: what stands behind the letter.
std::string number_of(const Json& json) {
  std::string text = text_of(json);
  if (!text.empty() && std::string_view("GgMm").find(text[0]) != std::string_view::npos) {
    text.erase(0, 1);
  }
  return text;
}

// A decimal with an optional exponent; nothing else can be a machine parameter, and nothing that
// is finer than a count.
std::optional<Fixed> fixed_of(const std::string& text) {
  const char* cursor = text.data();
  const char* end = cursor + text.size();
  Decimal number;
  if (!read_decimal(cursor, end, number) || number.overflow) return std::nullopt;
  Wide value = number.value;
  if (cursor != end && (*cursor == 'e' || *cursor == 'E')) {
    ++cursor;
    if (cursor != end && *cursor == '+') ++cursor;
    int exponent = 0;
    const auto [stop, error] = std::from_chars(cursor, end, exponent);
    if (error != std::errc{} || exponent < -18 || exponent > 18) return std::nullopt;
    cursor = stop;
    for (; exponent > 0; --exponent) value *= 10;
    for (; exponent < 0; ++exponent) {
      if (value % 10 != 0) return std::nullopt;
      value /= 10;
    }
  }
  if (cursor != end || number.finer || !fits(value)) return std::nullopt;
  return static_cast<Fixed>(value);
}

// Every function returns false, and has then put a message, when a value is not implemented.
class Reader {
 public:
  Reader(const ProfileTable& table, MachineProfile& profile, std::string& message)
      : table_(table), profile_(profile), message_(message) {
    profile_ = table.standard;
    for (std::size_t i = 0; i < table.parameters.size(); ++i) {
      profile_.parameters[i] = table.parameters[i].standard;
    }
  }

  bool document(const Json& json) {
    return each("configuration", json, [&](const std::string& key, const Json& value) {
      if (key == "dialect") return dialect(value);
      if (key == "profile") return value.is_null() || members(key, value, &Reader::entry);
      return key == "cmd" || refuse(key, value);
    });
  }

 private:
  template <typename Part>
  bool each(const std::string& name, const Json& json, const Part& part) {
    if (!json.is_object()) return refuse(name, json);
    return std::ranges::all_of(json.items(),
                               [&](const auto& item) { return part(item.key(), item.value()); });
  }

  using Member = bool (Reader::*)(const std::string& key, const Json& value);
  bool members(const std::string& name, const Json& json, Member part) {
    return each(name, json, [&](const std::string& key, const Json& value) {
      return (this->*part)(key, value);
    });
  }

  bool refuse(const std::string& key, const Json& value) {
    message_ = "The profile's " + key + " = " + value.dump() + " is not implemented.";
    return false;
  }
  bool dialect(const Json& value) {
    return value == table_.standard.dialect || refuse("dialect", value);
  }
  bool has(std::string_view key) const { return place_in(table_.own_keys, key) >= 0; }

  bool entry(const std::string& key, const Json& value) {
    Fixed resolution = 0;
    if (key == "dialect") return dialect(value);
    if (key == "units") return word(key, value, "mm|inch", profile_.inch);
    // The gauge's tolerance follows from it; the output here is finer than any.
    if (key == "resolution") return decimal(key, value, resolution);
    if (key == "block_skip") return boolean(key, value, profile_.block_skip);
    if (key == "alarm_timing") return value == "block" || refuse(key, value);
    if (key == "initial") return members(key, value, &Reader::initial);
    if (key == "readings") return members(key, value, &Reader::reading);
    if (key == "parameters") return members(key, value, &Reader::parameter);
    return has(key) ? own_entry(key, value) : foreign(key, value);
  }

  // A setting of another maker: here it can only be the default.
  bool foreign(const std::string& key, const Json& value) {
    const bool standard =
        (key == "increment" && value == "ISB") || (key == "x_diameter" && value == false) ||
        ((key == "offsets" || key == "tools") && value.is_object() && value.empty());
    return standard || refuse(key, value);
  }

  bool own_entry(const std::string& key, const Json& value) {
    if (key == "increment") return word(key, value, "ISB|ISC", profile_.fine);
    if (key == "x_diameter") return boolean(key, value, profile_.x_diameter);
    if (key == "reference_point") return point(key, value, profile_.reference_point);
    if (key == "offsets") {
      return each(key, value, [&](const std::string& name, const Json& place) {
        const int frame = place_in("G54|G55|G56|G57|G58|G59", name);
        if (frame < 0) return refuse(name, place);
        return point(name, place, profile_.offsets[static_cast<std::size_t>(frame)]);
      });
    }
    return each(key, value, [&](const std::string& name, const Json& tool) {
      int number = 0;
      const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), number);
      if (error != std::errc{} || stop != name.data() + name.size() || number < 0) {
        return refuse("tools." + name, tool);
      }
      return each(name, tool, [&](const std::string& part, const Json& radius) {
        if (part != "radius") return refuse(part, radius);
        return not_negative(part, radius, profile_.tools[number]);
      });
    });
  }

  bool initial(const std::string& key, const Json& value) {
    if (key == "f") return not_negative(key, value, profile_.feed);
    if (key == "plane") return code(key, value, table_.planes, profile_.plane);
    if (key == "motion") return code(key, value, table_.motions, profile_.motion);
    if (key == "spindle") {
      const int number = place_in("0|1|2|3|4|5", number_of(value));
      profile_.spindle_turns = number == 3 || number == 4;
      profile_.spindle = profile_.spindle_turns ? number : 5;
      return number >= 0 || refuse(key, value);
    }
    return axis(key, value, profile_.position);
  }

  bool parameter(const std::string& key, const Json& value) {
    if (key == "reference_point" && has(key)) return point(key, value, profile_.reference_point);
    for (std::size_t i = 0; i < table_.parameters.size(); ++i) {
      const ParameterRow& row = table_.parameters[i];
      if (key != row.key) continue;
      Fixed& number = profile_.parameters[i];
      if (!decimal(key, value, number)) return false;
      return (number >= row.least && number <= row.most) || refuse(key, value);
    }
    return refuse(key, value);
  }

  bool reading(const std::string& key, const Json& value) {
    for (std::size_t i = 0; i < table_.readings.size(); ++i) {
      if (key != table_.readings[i].key) continue;
      const std::string name = text_of(value);
      const int place = name == "any" ? 0 : place_in(table_.readings[i].alternatives, name);
      if (place < 0) return refuse(key, value);
      profile_.readings.take({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(place)});
      return true;
    }
    return refuse(key, value);
  }

  bool decimal(const std::string& key, const Json& json, Fixed& value) {
    const std::optional<Fixed> number = fixed_of(text_of(json));
    if (!number) return refuse(key, json);
    value = *number;
    return true;
  }
  bool not_negative(const std::string& key, const Json& json, Fixed& value) {
    if (!decimal(key, json, value)) return false;
    return (value >= 0 && value <= table_.reach) || refuse(key, json);
  }
  bool axis(const std::string& key, const Json& json, Point& place) {
    const int axis = place_in("x|y|z|a|c", key);  // in the order of gonogo_axis
    if (axis < 0) return refuse(key, json);
    Fixed& value = place[static_cast<std::size_t>(axis)];
    return decimal(key, json, value) && (magnitude(value) <= table_.reach || refuse(key, json));
  }
  bool point(const std::string& key, const Json& json, Point& place) {
    return each(key, json, [&](const std::string& name, const Json& value) {
      return axis(name, value, place);
    });
  }
  // One of these codes, with or without zeros before it; "none" where it is among them.
  bool code(const std::string& key, const Json& json, std::string_view codes, int& value) {
    const std::string name = number_of(json);
    value = -1;
    const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), value);
    const bool whole = error == std::errc{} && stop == name.data() + name.size();
    return place_in(codes, whole ? std::to_string(value) : name) >= 0 || refuse(key, json);
  }
  bool boolean(const std::string& key, const Json& json, bool& value) {
    if (!json.is_boolean()) return refuse(key, json);
    value = json.get<bool>();
    return true;
  }
  // One of two words; `value`: it is the second.
  bool word(const std::string& key, const Json& json, std::string_view words, bool& value) {
    const int place = place_in(words, text_of(json));
    value = place == 1;
    return place >= 0 || refuse(key, json);
  }

  const ProfileTable& table_;
  MachineProfile& profile_;
  std::string& message_;
};

// The dialect decides which keys there are.
const ProfileTable& table_for(const Json& json, std::span<const ProfileTable> tables) {
  const auto named = [&](const Json& where) -> const ProfileTable* {
    for (const ProfileTable& table : tables) {
      if (where.is_object() && where.value("dialect", Json()) == table.standard.dialect) {
        return &table;
      }
    }
    return nullptr;
  };
  const ProfileTable* table = named(json);
  if (table == nullptr && !json.contains("dialect") && json.contains("profile")) {
    table = named(json["profile"]);
  }
  return table == nullptr ? tables.front() : *table;
}

}  // namespace

ProfileResult read_profile(std::string_view text, std::span<const ProfileTable> tables,
                           MachineProfile& profile, std::string& message) {
  const Json json = Json::parse(text.begin(), text.end(), nullptr, false);
  if (json.is_discarded() || !json.is_object()) {
    message = "The configuration is no JSON object.";
    return ProfileResult::kMalformed;
  }
  const bool read = Reader(table_for(json, tables), profile, message).document(json);
  return read ? ProfileResult::kRead : ProfileResult::kUnsupported;
}

}  // namespace gonogo::expanders
