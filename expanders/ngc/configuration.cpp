// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/configuration.hpp"

#include <nlohmann/json.hpp>

namespace gonogo::expanders::ngc {
namespace {

constexpr Choice<Configuration> kChoices[] = {
    {"ngc.arc-tolerance", "nist", "linuxcnc", &Configuration::forgiving_arcs},
    {"ngc.full-circle-words", "free", "needed", &Configuration::circle_needs_word},
};

class Reader : public ProfileReader {
 public:
  Reader(Configuration& configuration, std::string& message)
      : ProfileReader("rs274", message), configuration_(configuration) {}

 private:
  bool profile(const Json& json) override;
  bool reading(const std::string& key, const Json& json) override;
  bool setting(const std::string& key, const Json& value);
  bool initial(const Json& json);

  Configuration& configuration_;
};

bool Reader::profile(const Json& json) {
  for (const auto& [key, value] : json.items()) {
    if (!setting(key, value)) return false;
  }
  return true;
}

bool Reader::setting(const std::string& key, const Json& value) {
  Fixed resolution = 0;
  if (key == "dialect") return dialect(value);
  if (key == "units") return word(key, value, "mm", "inch", configuration_.inch);
  // Another maker's; here it can only be the default.
  if (key == "increment") return value == "ISB" || refuse(key, value);
  // The gauge's tolerance follows from it; the output here is finer than any.
  if (key == "resolution") return decimal(key, value, resolution);
  if (key == "x_diameter") return value == false || refuse(key, value);
  if (key == "block_skip") return boolean(key, value, configuration_.block_delete);
  if (key == "alarm_timing") return value == "block" || refuse(key, value);
  if (key == "initial") return initial(value);
  if (key == "readings") return readings(value);
  const bool another = key == "offsets" || key == "parameters" || key == "tools";
  return (another && value.is_object() && value.empty()) || refuse(key, value);
}

bool Reader::initial(const Json& json) {
  if (!json.is_object()) return refuse("initial", json);
  for (const auto& [key, value] : json.items()) {
    bool read = false;
    if (key == "f") {
      read = decimal(key, value, configuration_.feed);
      if (read && configuration_.feed < 0) return refuse(key, value);
    } else if (key == "plane") {
      read = code(key, value, 17, 19, configuration_.plane);
    } else if (key == "motion") {
      read = value == "none" || code(key, value, 0, 1, configuration_.motion);
    } else if (key == "spindle") {
      read = true;  // no motion here looks at it
    } else {
      read = axis(key, value, configuration_.position);
    }
    if (!read) return false;
  }
  return true;
}

bool Reader::reading(const std::string& key, const Json& json) {
  for (const Choice<Configuration>& choice : kChoices) {
    if (key != choice.key) continue;
    // "any" admits the standard outcome, which is then the one taken.
    return text_of(json) == "any" ||
           word(key, json, choice.standard, choice.other, configuration_.*choice.option);
  }
  return refuse(key, json);
}

}  // namespace

ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message) {
  return Reader(configuration, message).read(json);
}

}  // namespace gonogo::expanders::ngc
