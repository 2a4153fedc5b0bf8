// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/alarms.hpp"

#include <array>
#include <cstddef>

namespace gonogo::expanders::ngc {

AlarmText text_of(AlarmKind kind) {
  // In the order of AlarmKind.
  static constexpr std::array<AlarmText, 14> kTexts{{
      {"E101", "syntax"},              // block that cannot be read
      {"E102", "undefined-code"},      // G or M number that the control lacks
      {"E103", "duplicate-word"},      // address or modal group twice in a block
      {"E104", "conflicting-words"},   // R with I, J or K
      {"E105", "missing-word"},        // word that the code needs, or code that the word needs
      {"E106", "unused-word"},         // word that no code of the block uses
      {"E107", "program-end"},         // text that ends before its program
      {"E201", "value-out-of-range"},  // number that is too large
      {"E202", "value-sign"},          // number with the wrong sign
      {"E203", "not-an-integer"},      // count with decimals
      {"E301", "axis-not-in-plane"},   // offset along the third axis
      {"E302", "arc-end-point"},       // end not on the circle, or no chord for R
      {"E303", "arc-radius"},          // R shorter than half the chord, circle of no size
      {"E304", "feed-missing"},        // cut without F
  }};
  return kTexts[static_cast<std::size_t>(kind)];
}

}  // namespace gonogo::expanders::ngc
