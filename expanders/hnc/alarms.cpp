// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/hnc/alarms.hpp"

#include <array>
#include <cstddef>

namespace gonogo::expanders::hnc {

AlarmText text_of(AlarmKind kind) {
  // In the order of AlarmKind.
  static constexpr std::array<AlarmText, 16> kTexts{{
      {"SYN01", "syntax"},              // block that cannot be read
      {"SYN02", "undefined-code"},      // code or address that the control lacks
      {"SYN03", "duplicate-word"},      // address or code group twice in a block
      {"SYN04", "conflicting-words"},   // X with U, F with J
      {"SYN05", "missing-word"},        // word that the code needs
      {"VAL01", "value-out-of-range"},  // number that is too large
      {"VAL02", "value-sign"},          // number with the wrong sign
      {"VAL03", "not-an-integer"},      // count with decimals
      {"PTH01", "direction-conflict"},  // approach point on the start point
      {"PTH02", "plane-not-allowed"},   // G17, G19
      {"PTH03", "retract-pair"},        // R without E
      {"PTH04", "retract-ratio"},       // run-out too steep
      {"PTH05", "arc-end-point"},       // end not on the circle, or no circle
      {"PTH06", "arc-radius"},          // R shorter than half the chord
      {"MOD01", "feed-missing"},        // cut without F
      {"MOD02", "lead-missing"},        // thread without F and J
  }};
  return kTexts[static_cast<std::size_t>(kind)];
}

}  // namespace gonogo::expanders::hnc
