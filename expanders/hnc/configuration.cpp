// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/hnc/configuration.hpp"

#include <nlohmann/json.hpp>

#include "expanders/hnc/codes.hpp"

namespace gonogo::expanders::hnc {
namespace {

constexpr Choice<Configuration> kChoices[] = {
    {"hnc.g75.i", "I", "P", &Configuration::count_in_p},
    {"hnc.g75.steps", "i-plus-1", "i", &Configuration::one_place_less},
    {"hnc.g75.end", "start", "last", &Configuration::groove_ends_at_last},
    {"hnc.g75.mode3", "off", "on", &Configuration::approach_mode},
    {"hnc.g75.depth-scale", "radius", "diameter", &Configuration::groove_depth_diameter},
    {"hnc.peck.from", "last-bottom", "withdrawn", &Configuration::peck_from_withdrawn},
    {"hnc.peck.withdraw", "rapid", "feed", &Configuration::withdraw_at_feed},
    {"hnc.peck.clamp", "none", "start", &Configuration::withdrawal_clamped},
    {"hnc.g82.exit", "rapid", "feed", &Configuration::thread_out_to_start},
    {"hnc.g82.e-scale", "radius", "diameter", &Configuration::run_out_diameter},
    {"hnc.g82.starts", "all", "one", &Configuration::one_start_a_block},
    {"hnc.modal.f", "feed", "forgotten", &Configuration::cycle_feed_forgotten},
    {"hnc.offset.initial", "G54", "none", &Configuration::no_initial_frame},
    {"hnc.arc.zero-radius", "alarm", "none", &Configuration::zero_radius_allowed},
};

class Reader : public ProfileReader {
 public:
  Reader(Configuration& configuration, std::string& message)
      : ProfileReader("hnc21t", message, {configuration.inch, configuration.block_skip}),
        configuration_(configuration) {}

 private:
  bool setting(const std::string& key, const Json& value) override;
  bool initial(const std::string& key, const Json& value) override;
  bool reading(const std::string& key, const Json& json) override;
  bool missing_axis(const std::string& key, const Json& json);
  bool lead_unit(const std::string& key, const Json& json);
  bool motion(const Json& value);
  bool offsets(const Json& json);
  bool parameters(const Json& json);

  Configuration& configuration_;
};

bool Reader::setting(const std::string& key, const Json& value) {
  if (key == "x_diameter") return boolean(key, value, configuration_.x_diameter);
  if (key == "offsets") return offsets(value);
  if (key == "parameters") return parameters(value);
  return foreign(key, value);
}

bool Reader::initial(const std::string& key, const Json& value) {
  int plane = 0;
  if (key == "f") return not_negative(key, value, configuration_.feed);
  if (key == "plane") return code(key, value, 18, 18, plane);
  if (key == "motion") return motion(value);
  if (key == "spindle") return true;  // no cycle here looks at it
  return axis(key, value, configuration_.position);
}

bool Reader::motion(const Json& value) {
  if (!code("motion", value, 0, 99, configuration_.motion)) return false;
  Decimal number;
  number.value = configuration_.motion * kOne;
  const Code* found = find_code(number);
  const bool moves = found != nullptr && found->group == Group::kMotion;
  return (moves && found->support == Support::kFull) || refuse("motion", value);
}

bool Reader::offsets(const Json& json) {
  if (!json.is_object()) return refuse("offsets", json);
  for (const auto& [key, value] : json.items()) {
    int frame = 0;
    if (!code(key, key, 54, 59, frame)) return false;
    if (!point(key, value, configuration_.offsets[static_cast<std::size_t>(frame - 54)])) {
      return false;
    }
  }
  return true;
}

bool Reader::parameters(const Json& json) {
  if (!json.is_object()) return refuse("parameters", json);
  for (const auto& [key, value] : json.items()) {
    if (key != "3410") return refuse(key, value);
    if (!decimal(key, value, configuration_.radius_tolerance)) return false;
  }
  return true;
}

bool Reader::reading(const std::string& key, const Json& json) {
  const std::optional<bool> read = choice(kChoices, key, json, configuration_);
  if (read) return *read;
  if (key == "hnc.missing-axis") return missing_axis(key, json);
  if (key == "hnc.lead.unit") return lead_unit(key, json);
  return refuse(key, json);
}

bool Reader::missing_axis(const std::string& key, const Json& json) {
  const std::string value = text_of(json);
  if (is_any(json) || value == "reject") {
    configuration_.missing_axis = MissingAxis::kReject;
  } else if (value == "keep") {
    configuration_.missing_axis = MissingAxis::kKeep;
  } else if (value == "none") {
    configuration_.missing_axis = MissingAxis::kNone;
  } else if (value == "nothing") {
    configuration_.missing_axis = MissingAxis::kNothing;
  } else {
    return refuse(key, json);
  }
  return true;
}

bool Reader::lead_unit(const std::string& key, const Json& json) {
  const std::string value = is_any(json) ? std::string("mm") : text_of(json);
  configuration_.lead_in_units = value == "units" || value == "units-tpi";
  configuration_.threads_per_inch = value == "tpi" || value == "units-tpi";
  const bool known =
      configuration_.lead_in_units || configuration_.threads_per_inch || value == "mm";
  return known || refuse(key, json);
}

}  // namespace

ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message) {
  return Reader(configuration, message).read(json);
}

}  // namespace gonogo::expanders::hnc
