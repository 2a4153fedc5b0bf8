// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/hnc/interpreter.hpp"

namespace gonogo::expanders::hnc {

std::span<const ProfileTable> Interpreter::profiles() {
  static constexpr ParameterRow kParameters[] = {{"3410", kOne / 100, -kLargest}};
  static const auto kProfiles = [] {
    ProfileTable table;
    table.standard.dialect = "hnc21t";
    table.standard.x_diameter = true;
    table.standard.motion = 0;
    table.own_keys = "x_diameter|offsets";
    table.planes = "18";
    table.motions = "0|1|2|3|32|74|75|80|81|82";
    table.parameters = kParameters;
    table.readings = kReadings;
    return std::array{table};
  }();
  return kProfiles;
}

}  // namespace gonogo::expanders::hnc
