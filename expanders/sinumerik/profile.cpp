// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/interpreter.hpp"

namespace gonogo::expanders::sinumerik {

std::span<const ProfileTable> Interpreter::profiles() {
  static constexpr ParameterRow kParameters[] = {
      {"CIRCLE_ERROR_CONST", kOne / 100, 0, kReach},
      {"CIRCLE_ERROR_FACTOR", kOne / 1000, 0, kReach},
  };
  static const auto kProfiles = [] {
    ProfileTable plain;
    plain.standard.dialect = "sinumerik840d";
    plain.motions = "none|0|1|2|3";
    plain.own_keys = "x_diameter";
    plain.parameters = kParameters;
    plain.readings = std::span(kReadings).first(kReadingsOf840D);
    plain.reach = kReach;
    ProfileTable with_cycles = plain;
    with_cycles.standard.dialect = "sinumerik802s";
    with_cycles.own_keys = "x_diameter|tools";
    with_cycles.readings = kReadings;
    return std::array{plain, with_cycles};
  }();
  return kProfiles;
}

}  // namespace gonogo::expanders::sinumerik
