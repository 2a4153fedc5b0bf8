// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/configuration.hpp"

#include <nlohmann/json.hpp>

namespace gonogo::expanders::sinumerik {
namespace {

constexpr Choice<Configuration> kChoices[] = {
    {"sie.cr.tolerance", "0", "const", &Configuration::radius_tolerance},
    {"sie.spindle", "off", "alarm", &Configuration::spindle_checked},
    {"sie.initial-motion", "g1", "g0", &Configuration::starts_rapid},
    {"sie.g70.f", "mm", "inch", &Configuration::feed_in_inches},
};

// Those of 802S.
constexpr Choice<Configuration> kCycleChoices[] = {
    {"sie.g158", "absolute", "additive", &Configuration::shifts_add},
    {"sie.g258", "absolute", "rotation-only", &Configuration::rotation_only},
    {"sie.rpl-equals", "required", "lenient", &Configuration::rotation_is_lenient},
    {"sie.infeed", "equal", "max-rest", &Configuration::infeeds_with_rest},
    {"sie.infeed-from", "reference", "clearance", &Configuration::infeeds_from_clearance},
    {"sie.corner", "clamp", "reject", &Configuration::large_corners_refused},
    {"sie.lcyc.unit", "mm", "inch", &Configuration::cycles_in_inches},
    {"sie.lc75.r125-limit", "none", "alarm", &Configuration::depth_allowance_limited},
};

constexpr const char* kDialect = "sinumerik840d";
constexpr const char* kDialectWithCycles = "sinumerik802s";

// Larger lengths would not leave room for their squares.
constexpr Fixed kMost = 1'000'000'000 * kOne;

class Reader : public ProfileReader {
 public:
  Reader(Configuration& configuration, std::string& message)
      : ProfileReader(configuration.control == Control::k802S ? kDialectWithCycles : kDialect,
                      message, {configuration.inch, configuration.block_skip}),
        configuration_(configuration) {}

 private:
  bool setting(const std::string& key, const Json& value) override;
  bool initial(const std::string& key, const Json& value) override;
  bool reading(const std::string& key, const Json& json) override;
  bool in_room(const std::string& key, const Json& value);
  bool spindle(const Json& value);
  bool parameters(const Json& json);
  bool correction(const Json& json);
  bool cycle_reading(const std::string& key, const Json& json);
  bool tools(const Json& json);

  Configuration& configuration_;
};

// The dialect decides which keys there are.
bool names_cycles(std::string_view text) {
  const auto json = nlohmann::json::parse(text.begin(), text.end(), nullptr, false);
  if (!json.is_object()) return false;
  if (json.contains("dialect")) return json["dialect"] == kDialectWithCycles;
  if (!json.contains("profile") || !json["profile"].is_object()) return false;
  return json["profile"].value("dialect", nlohmann::json()) == kDialectWithCycles;
}

bool Reader::setting(const std::string& key, const Json& value) {
  if (key == "parameters") return parameters(value);
  if (key == "tools" && configuration_.control == Control::k802S) return tools(value);
  return foreign(key, value);
}

bool Reader::initial(const std::string& key, const Json& value) {
  if (key == "f") return not_negative(key, value, configuration_.feed, kMost);
  if (key == "plane") return code(key, value, 17, 19, configuration_.plane);
  if (key == "motion") return value == "none" || code(key, value, 0, 3, configuration_.motion);
  if (key == "spindle") return spindle(value);
  return axis(key, value, configuration_.position) && in_room(key, value);
}

bool Reader::in_room(const std::string& key, const Json& value) {
  for (const Fixed place : configuration_.position) {
    if (magnitude(place) > kMost) return refuse(key, value);
  }
  return true;
}

bool Reader::spindle(const Json& value) {
  std::string text = text_of(value);
  if (!text.empty() && (text[0] == 'M' || text[0] == 'm')) text.erase(0, 1);
  int number = 0;
  if (!code("spindle", Json(text), 0, 5, number)) return false;
  configuration_.spindle_turns = number == 3 || number == 4;
  return true;
}

bool Reader::parameters(const Json& json) {
  if (!json.is_object()) return refuse("parameters", json);
  for (const auto& [key, value] : json.items()) {
    bool read = false;
    if (key == "CIRCLE_ERROR_CONST") {
      read = not_negative(key, value, configuration_.circle_error_constant, kMost);
    } else if (key == "CIRCLE_ERROR_FACTOR") {
      read = not_negative(key, value, configuration_.circle_error_factor, kMost);
    } else {
      refuse(key, value);
    }
    if (!read) return false;
  }
  return true;
}

bool Reader::reading(const std::string& key, const Json& json) {
  const std::optional<bool> read = choice(kChoices, key, json, configuration_);
  if (read) return *read;
  if (key == "sie.arc.correct") return is_any(json) || correction(json);
  const bool cycles = configuration_.control == Control::k802S;
  return cycles ? cycle_reading(key, json) : refuse(key, json);
}

bool Reader::cycle_reading(const std::string& key, const Json& json) {
  const bool any = is_any(json);
  // Split levels are right under both; of the ways within a pocket only the own one is offered.
  if (key == "sie.finish.levels") return any || text_of(json) == "split" || refuse(key, json);
  if (key == "sie.pocket.path") return any || refuse(key, json);
  const std::optional<bool> read = choice(kCycleChoices, key, json, configuration_);
  return read ? *read : refuse(key, json);
}

bool Reader::tools(const Json& json) {
  if (!json.is_object()) return refuse("tools", json);
  for (const auto& [name, tool] : json.items()) {
    const bool digits = !name.empty() && name.size() < 10 &&
                        name.find_first_not_of("0123456789") == std::string::npos;
    if (!digits || !tool.is_object()) return refuse("tools." + name, tool);
    Fixed& radius = configuration_.tools[std::stol(name)];
    for (const auto& [key, value] : tool.items()) {
      if (key != "radius") return refuse(key, value);
      if (!not_negative(key, value, radius, kMost)) return false;
    }
  }
  return true;
}

bool Reader::correction(const Json& json) {
  const std::string text = text_of(json);
  if (text == "start-radius") {
    configuration_.correction = Correction::kStartRadius;
  } else if (text == "project") {
    configuration_.correction = Correction::kProject;
  } else if (text == "programmed") {
    configuration_.correction = Correction::kProgrammed;
  } else {
    return refuse("sie.arc.correct", json);
  }
  return true;
}

}  // namespace

ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message) {
  if (names_cycles(json)) configuration.control = Control::k802S;
  return Reader(configuration, message).read(json);
}

}  // namespace gonogo::expanders::sinumerik
