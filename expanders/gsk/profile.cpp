// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/interpreter.hpp"

namespace gonogo::expanders::gsk {

std::span<const ProfileTable> Interpreter::profiles() {
  static constexpr ParameterRow kParameters[] = {
      {"3410", kOne / 100},
      {"5920", 0, 0, kFullTurn},
      {"5921"},
      {"3403.6", -1, 0, kOne},
  };
  static const auto kProfiles = [] {
    ProfileTable table;
    table.standard.dialect = "gsk988ta";
    table.standard.x_diameter = true;
    table.standard.motion = 0;
    table.standard.plane = 18;
    table.own_keys = "increment|x_diameter|reference_point";
    table.motions = "0|1|2|3";
    table.parameters = kParameters;
    table.readings = kReadings;
    return std::array{table};
  }();
  return kProfiles;
}

}  // namespace gonogo::expanders::gsk
