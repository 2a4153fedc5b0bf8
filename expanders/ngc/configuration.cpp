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
      : ProfileReader("rs274", message, {configuration.inch, configuration.block_delete}),
        configuration_(configuration) {}

 private:
  bool setting(const std::string& key, const Json& value) override;
  bool initial(const std::string& key, const Json& value) override;
  bool reading(const std::string& key, const Json& json) override;

  Configuration& configuration_;
};

bool Reader::setting(const std::string& key, const Json& value) {
  return foreign(key, value);
}

bool Reader::initial(const std::string& key, const Json& value) {
  if (key == "f") return not_negative(key, value, configuration_.feed);
  if (key == "plane") return code(key, value, 17, 19, configuration_.plane);
  if (key == "motion") return value == "none" || code(key, value, 0, 1, configuration_.motion);
  if (key == "spindle") return true;  // no motion here looks at it
  return axis(key, value, configuration_.position);
}

bool Reader::reading(const std::string& key, const Json& json) {
  const std::optional<bool> read = choice(kChoices, key, json, configuration_);
  return read ? *read : refuse(key, json);
}

}  // namespace

ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message) {
  return Reader(configuration, message).read(json);
}

}  // namespace gonogo::expanders::ngc
