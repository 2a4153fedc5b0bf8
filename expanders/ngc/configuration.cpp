// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/configuration.hpp"

#include <nlohmann/json.hpp>

namespace gonogo::expanders::ngc {
namespace {

constexpr Choice<Configuration> kChoices[] = {
    {"ngc.arc-tolerance", "nist", "linuxcnc", &Configuration::forgiving_arcs},
    {"ngc.full-circle-words", "free", "needed", &Configuration::circle_needs_word},
    {"ngc.g80-beside", "alarm", "ignored", &Configuration::forgets_g80},
    {"ngc.unused-words", "alarm", "ignored", &Configuration::passes_over_words},
    {"ngc.line-number", "decimal", "whole", &Configuration::whole_line_numbers},
    {"ngc.o-name", "passed-over", "syntax", &Configuration::refuses_names},
    {"ngc.program-end", "needed", "free", &Configuration::needs_no_end},
    {"ngc.bare-motion", "nothing", "missing-word", &Configuration::motion_needs_axis},
    {"ngc.arc-words-alone", "arc", "alarm", &Configuration::arc_needs_axis},
};

// Values of ngc.whole. A G code is whole in tenths: as it is written, its limit is a tenth.
struct WholeChoice {
  const char* name;
  WholeRule rule;
};
constexpr WholeChoice kWholeChoices[] = {
    {"exact", {}},
    {"nist", {kOne / 100'000, kOne / 10'000, kOne / 10'000}},
    {"linuxcnc", {kOne / 10'000, kOne / 10'000, kOne / 1'000}},
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
  bool whole(const std::string& key, const Json& json);

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

bool Reader::whole(const std::string& key, const Json& json) {
  if (is_any(json)) return true;
  const std::string name = text_of(json);
  for (const WholeChoice& one : kWholeChoices) {
    if (name != one.name) continue;
    configuration_.whole = one.rule;
    return true;
  }
  return refuse(key, json);
}

bool Reader::reading(const std::string& key, const Json& json) {
  if (key == "ngc.whole") return whole(key, json);
  const std::optional<bool> read = choice(kChoices, key, json, configuration_);
  return read ? *read : refuse(key, json);
}

}  // namespace

ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message) {
  return Reader(configuration, message).read(json);
}

}  // namespace gonogo::expanders::ngc
