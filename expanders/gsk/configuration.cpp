// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/configuration.hpp"

#include <nlohmann/json.hpp>

namespace gonogo::expanders::gsk {
namespace {

constexpr Choice<Configuration> kChoices[] = {
    {"gsk.pocket.end", "initial", "r-plane", &Configuration::pocket_ends_at_r_plane},
    {"gsk.g94.rewrite", "keep", "clear", &Configuration::g94_rewrite_clears},
    {"gsk.g94.after-00", "stays", "cancelled", &Configuration::g94_cancelled_by_00},
    {"gsk.g94.empty-block", "none", "repeat", &Configuration::g94_repeats_empty},
    {"gsk.missing-axis", "skip", "position", &Configuration::incomplete_positions},
    {"gsk.zero-depth", "no-cut", "alarm", &Configuration::zero_depth_alarms},
    {"gsk.pocket.pair", "shared", "each", &Configuration::pockets_apart},
    {"gsk.pocket.R", "per-block", "modal", &Configuration::pocket_r_modal},
    {"gsk.x-depth", "diameter", "radius", &Configuration::x_depth_radius},
    {"gsk.duplicate", "alarm", "last", &Configuration::later_wins},
    {"gsk.g94.in-mode", "keep", "clear", &Configuration::g94_cleared_by_cycles},
    {"gsk.zero-depth-end", "initial", "r-plane", &Configuration::zero_depth_ends_at_r_plane},
    {"gsk.g92.lead", "own", "feed", &Configuration::lead_is_feed},
    {"gsk.dwell-without-word", "alarm", "none", &Configuration::dwell_may_be_empty},
    {"gsk.arc.tolerance-zero", "off", "exact", &Configuration::zero_tolerance_checks},
    {"gsk.g50.initial-plane", "shifted", "kept", &Configuration::initial_plane_kept},
    {"gsk.helix.entry-side", "any", "+p", &Configuration::helix_enters_at_p},
    {"gsk.helix.flat", "off", "on", &Configuration::helix_ends_flat},
    {"gsk.helix.L", "per-block", "modal", &Configuration::helix_turns_modal},
    {"gsk.thread.path", "any", "arc", &Configuration::thread_path_plain},
    {"gsk.thread.v-from", "r-plane", "initial", &Configuration::thread_depth_from_initial},
    {"gsk.thread.mode", "pairs", "one", &Configuration::threads_one_mode},
    {"gsk.thread.modal", "code", "none", &Configuration::thread_not_modal},
    {"gsk.thread.direction", "alarm", "free", &Configuration::thread_direction_free},
    {"gsk.thread.r", "optional", "required", &Configuration::thread_r_required},
    {"gsk.thread.k-range", "360", "table", &Configuration::thread_angle_unlimited},
};

// A choice of which this machine has one outcome.
struct Settled {
  const char* key;
  const char* value;
};

constexpr Settled kSettled[] = {
    {"gsk.pocket.path", "concentric"},
    {"gsk.pocket.p-omitted", "0"},
    {"gsk.arc.zero-radius", "alarm"},
    {"gsk.rotary-feed-inch", "scaled"},
};

std::string_view name_of(Decimals decimals) {
  constexpr std::string_view kNames[] = {"keep", "nearest", "alarm"};
  return kNames[static_cast<std::size_t>(decimals)];
}

std::string_view name_of(RunOut run_out) {
  constexpr std::string_view kNames[] = {"any", "polar", "radial", "tangent"};
  return kNames[static_cast<std::size_t>(run_out)];
}

class Reader : public ProfileReader {
 public:
  Reader(Configuration& configuration, std::string& message)
      : ProfileReader("gsk988ta", message, {configuration.inch, configuration.block_skip}),
        configuration_(configuration) {}

 private:
  bool profile(const Json& json) override;
  bool setting(const std::string& key, const Json& value) override;
  bool initial(const std::string& key, const Json& value) override;
  bool reading(const std::string& key, const Json& json) override;
  bool parameters(const Json& json);

  Configuration& configuration_;
};

bool Reader::profile(const Json& json) {
  for (const auto& [key, value] : json.items()) {
    if (key != "parameters" && !entry(key, value)) return false;
  }
  // Last: parameter 3403#6 decides, whatever gsk.duplicate says (GSK-COM-07).
  return !json.contains("parameters") || parameters(json["parameters"]);
}

bool Reader::setting(const std::string& key, const Json& value) {
  if (key == "increment") return word(key, value, "ISB", "ISC", configuration_.fine);
  if (key == "x_diameter") return boolean(key, value, configuration_.x_diameter);
  if (key == "reference_point") return point(key, value, configuration_.reference_point);
  return foreign(key, value);
}

bool Reader::initial(const std::string& key, const Json& value) {
  if (key == "f") return not_negative(key, value, configuration_.feed);
  if (key == "plane") return code(key, value, 17, 19, configuration_.plane);
  if (key == "motion") return code(key, value, 0, 3, configuration_.motion);
  if (key == "spindle") return true;  // no cycle here looks at it
  return axis(key, value, configuration_.position);
}

bool Reader::parameters(const Json& json) {
  if (!json.is_object()) return refuse("parameters", json);
  for (const auto& [key, value] : json.items()) {
    bool read = false;
    if (key == "3410") {
      read = decimal(key, value, configuration_.radius_tolerance);
      if (configuration_.radius_tolerance < 0) return refuse(key, value);
    } else if (key == "5920") {
      read = decimal(key, value, configuration_.run_out_angle);
      const Fixed angle = configuration_.run_out_angle;
      if (angle < 0 || angle > 360 * kOne) return refuse(key, value);
    } else if (key == "5921") {
      read = decimal(key, value, configuration_.run_out_distance);
      if (configuration_.run_out_distance < 0) return refuse(key, value);
    } else if (key == "3403.6") {
      bool alarms = false;
      read = word(key, value, "0", "1", alarms);
      configuration_.later_wins = !alarms;
    } else if (key == "reference_point") {
      read = point(key, value, configuration_.reference_point);
    } else {
      return refuse(key, value);
    }
    if (!read) return false;
  }
  return true;
}

bool Reader::reading(const std::string& key, const Json& json) {
  const std::optional<bool> read = choice(kChoices, key, json, configuration_);
  if (read) return *read;
  const std::string value = text_of(json);
  const bool any = is_any(json);
  for (const Settled& settled : kSettled) {
    if (key == settled.key) return any || value == settled.value || refuse(key, json);
  }
  for (const Decimals decimals : {Decimals::kKeep, Decimals::kNearest, Decimals::kAlarm}) {
    if (key != "gsk.decimals" || (!any && value != name_of(decimals))) continue;
    configuration_.decimals = decimals;
    return true;
  }
  for (const RunOut run_out : {RunOut::kOwn, RunOut::kPolar, RunOut::kRadial, RunOut::kTangent}) {
    if (key != "gsk.thread.runout" || value != name_of(run_out)) continue;
    configuration_.run_out = run_out;
    return true;
  }
  return refuse(key, json);
}

}  // namespace

ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message) {
  return Reader(configuration, message).read(json);
}

}  // namespace gonogo::expanders::gsk
