// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/alarms.hpp"

#include <array>
#include <cstddef>

namespace gonogo::expanders::gsk {

AlarmText text_of(AlarmKind kind) {
  // In the order of AlarmKind.
  static constexpr std::array<AlarmText, 18> kTexts{{
      {"0002", "undefined-code"},      // G code that the control lacks
      {"0003", "syntax"},              // block that cannot be read
      {"0010", "duplicate-word"},      // address or code group twice in a block
      {"0012", "value-out-of-range"},  // value outside of the address's range
      {"0023", "value-sign"},          // feed or dwell below zero
      {"0014", "conflicting-words"},   // X with U, motion code with cycle code
      {"0206", "missing-word"},        // word that the code needs
      {"0013", "not-an-integer"},      // M number with decimals
      {"0021", "arc-end-point"},       // end not on the circle, or no circle
      {"0018", "arc-radius"},          // R shorter than half the chord
      {"0024", "feed-missing"},        // cut without F
      {"0192", "axis-not-in-plane"},   // cycle word of an axis outside the plane
      {"0193", "taper-limit"},         // taper longer than the travel against it
      {"0207", "tool-too-large"},      // I not above D
      {"0224", "step-too-large"},      // L not below the tool's diameter
      {"0198", "depth-exceeds-tool"},  // P above D
      {"0196", "lead-missing"},        // thread without F
      {"0230", "direction-conflict"},  // R against the depth
  }};
  return kTexts[static_cast<std::size_t>(kind)];
}

}  // namespace gonogo::expanders::gsk
