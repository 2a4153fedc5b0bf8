// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/interpreter.hpp"

namespace gonogo::expanders::ngc {

std::span<const ProfileTable> Interpreter::profiles() {
  static const auto kProfiles = [] {
    ProfileTable table;
    table.standard.dialect = "rs274";
    table.motions = "none|0|1";
    table.readings = kReadings;
    return std::array{table};
  }();
  return kProfiles;
}

}  // namespace gonogo::expanders::ngc
