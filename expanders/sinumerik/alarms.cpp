// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/alarms.hpp"

#include <array>
#include <cstddef>

namespace gonogo::expanders::sinumerik {

AlarmText text_of(AlarmKind kind) {
  // In the order of AlarmKind.
  static constexpr std::array<AlarmText, 23> kTexts{{
      {"B01", "syntax"},                  // block that cannot be read
      {"B02", "undefined-code"},          // code, address or name that the control lacks
      {"B03", "duplicate-word"},          // address or group twice in a block
      {"B04", "conflicting-words"},       // words that exclude each other
      {"B05", "missing-word"},            // word that the motion needs
      {"V01", "value-out-of-range"},      // number that the word does not take
      {"V02", "value-sign"},              // number with the wrong sign
      {"V03", "not-an-integer"},          // count with decimals
      {"P01", "axis-not-in-plane"},       // centre along the third axis
      {"P02", "arc-end-point"},           // end not on the circle
      {"P03", "arc-intermediate-point"},  // three points that fix no circle
      {"P04", "arc-tangent"},             // no direction to go on in
      {"P05", "arc-radius"},              // circle of no size, radius below half the chord
      {"F01", "feed-missing"},            // cut without F
      {"F02", "spindle-stopped"},         // cut with a spindle that does not turn
      {"P06", "plane-not-allowed"},       // other plane than that of the rotation in force
      {"C01", "no-tool"},                 // cycle without a tool that is described
      {"C02", "reference-plane"},         // planes of a cycle in the wrong order
      {"C03", "machining-type"},          // R127
      {"C04", "direction-parameter"},     // R126
      {"C05", "tool-too-large"},          // pocket that the tool does not go into
      {"C06", "allowance-too-large"},     // allowance that roughing or finishing cannot leave
      {"C07", "pocket-size"},             // pocket without length or width
  }};
  return kTexts[static_cast<std::size_t>(kind)];
}

}  // namespace gonogo::expanders::sinumerik
