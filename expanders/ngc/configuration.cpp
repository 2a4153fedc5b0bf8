// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/configuration.hpp"

#include <array>
#include <nlohmann/json.hpp>

namespace gonogo::expanders::ngc {
namespace {

/// A reading; its first outcome is the standard machine.
struct Reading {
  std::string_view key;
  Option Configuration::*option;
  std::array<std::string_view, 4> outcomes;
};

constexpr Reading kReadings[] = {
    {"ngc.whole", &Configuration::whole, {"exact", "nist", "linuxcnc", "grbl"}},
    {"ngc.arc-tolerance", &Configuration::arc_tolerance, {"nist", "linuxcnc", "page", "grbl"}},
    {"ngc.full-circle-words", &Configuration::circle_needs_word, {"free", "needed"}},
    {"ngc.g80-beside", &Configuration::forgets_g80, {"alarm", "ignored"}},
    {"ngc.unused-words", &Configuration::ignores_words, {"alarm", "ignored"}},
    {"ngc.line-number", &Configuration::whole_line_numbers, {"decimal", "whole"}},
    {"ngc.o-name", &Configuration::refuses_names, {"passed-over", "syntax"}},
    {"ngc.program-end", &Configuration::needs_no_end, {"needed", "free"}},
    {"ngc.bare-motion", &Configuration::motion_needs_axis, {"nothing", "missing-word"}},
    {"ngc.arc-words-alone", &Configuration::arc_needs_axis, {"arc", "alarm"}},
    {"ngc.missing-tool", &Configuration::looks_for_tools, {"taken", "alarm"}},
    {"ngc.g94-feed", &Configuration::g94_ends_feed, {"kept", "none"}},
    {"ngc.feed-units", &Configuration::feed_in_new_units, {"before", "after"}},
    {"ngc.block-delete", &Configuration::reads_skipped, {"unread", "read"}},
    {"ngc.lone-cr", &Configuration::cr_is_blank, {"line-end", "blank"}},
    {"ngc.long-line", &Configuration::refuses_long_lines, {"read", "syntax"}},
    {"ngc.alarm-dwell", &Configuration::dwells_first, {"none", "dwells"}},
    {"ngc.cycle.initial", &Configuration::initial_of_block, {"series", "block"}},
    {"ngc.cycle.g91-r", &Configuration::r_base, {"current", "initial", "absolute"}},
    {"ngc.cycle.sticky", &Configuration::keeps_levels, {"number", "level"}},
    {"ngc.cycle.approach", &Configuration::crosses_at_clear, {"current-level", "initial-level"}},
    {"ngc.cycle.initial-kept", &Configuration::initial_is_number, {"place", "number"}},
    {"ngc.cycle.retract-start", &Configuration::starts_with_g98, {"r-plane", "initial"}},
    {"ngc.cycle.feed", &Configuration::needs_no_feed, {"needed", "free"}},
    {"ngc.cycle.alarm-at", &Configuration::alarms_late, {"block", "late"}},
    {"ngc.cycle.alarm-at-q", &Configuration::q_at_once, {"hole", "block"}},
    {"ngc.g83.retract", &Configuration::pecks_to_clear, {"r-plane", "clear"}},
    {"ngc.g83.return", &Configuration::returns_by_feed, {"rapid", "feed"}},
    {"ngc.peck.clearance",
     &Configuration::clearance,
     {"ten-thou", "one-mm", "tenth-mm", "twentieth"}},
    {"ngc.peck.d", &Configuration::clearance_word, {"barred", "clearance"}},
    {"ngc.peck.dwell", &Configuration::pecks_dwell, {"none", "quarter"}},
    {"ngc.g73.end", &Configuration::g73_end, {"r-plane", "clear", "both"}},
    {"ngc.g85.out", &Configuration::g85_to_clear, {"r-plane", "clear"}},
    {"ngc.tap.p", &Configuration::tap_dwell, {"optional", "last", "needed", "barred"}},
    {"ngc.g74.l", &Configuration::g74_without_l, {"allowed", "barred"}},
    {"ngc.g33.k", &Configuration::any_lead, {"positive", "free"}},
    {"ngc.g76.checks", &Configuration::lenient_g76, {"text", "linuxcnc"}},
    {"ngc.g76.slide", &Configuration::slide_at_start, {"start", "end"}},
    {"ngc.g76.entry", &Configuration::g76_entry, {"thread", "feed", "rapid"}},
};

class Reader : public ProfileReader {
 public:
  Reader(Configuration& configuration, std::string& message)
      : ProfileReader("rs274", message, {configuration.inch, configuration.block_delete}),
        configuration_(configuration) {}

 private:
  bool setting(const std::string& key, const Json& value) override { return foreign(key, value); }
  bool initial(const std::string& key, const Json& value) override;
  bool reading(const std::string& key, const Json& json) override;

  Configuration& configuration_;
};

bool Reader::initial(const std::string& key, const Json& value) {
  if (key == "f") return not_negative(key, value, configuration_.feed);
  if (key == "plane") return code(key, value, 17, 19, configuration_.plane);
  if (key == "motion") return value == "none" || code(key, value, 0, 1, configuration_.motion);
  if (key == "spindle") {
    configuration_.spindle = value == "M3" ? 3 : value == "M4" ? 4 : 5;
    return configuration_.spindle != 5 || value == "M5" || value == "0" || refuse(key, value);
  }
  return axis(key, value, configuration_.position);
}

bool Reader::reading(const std::string& key, const Json& json) {
  for (const Reading& reading : kReadings) {
    if (key != reading.key) continue;
    if (is_any(json)) return true;
    const std::string outcome = text_of(json);
    for (std::size_t i = 0; i < reading.outcomes.size(); ++i) {
      if (outcome.empty() || outcome != reading.outcomes[i]) continue;
      configuration_.*reading.option = static_cast<Option>(i);
      return true;
    }
  }
  return refuse(key, json);
}

}  // namespace

ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message) {
  return Reader(configuration, message).read(json);
}

}  // namespace gonogo::expanders::ngc
