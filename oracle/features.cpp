// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/features.hpp"

#include <array>

namespace gonogo::oracle {

std::span<const Feature> feature_vocabulary() {
  static constexpr auto kVocabulary = std::to_array<Feature>({
      {"", "blocks", "records and alarms carry `b`, the source line; it is compared"},
      {"", "m", "M functions are passed on as records; they are compared"},
      {"", "bytes", "programs that are not UTF-8 are taken as base64"},
      {"gsk988ta", "basic", "positioning, feeds, dwell, planes, units, G28, G50"},
      {"gsk988ta", "arc", "G02 and G03"},
      {"gsk988ta", "g90", "the axial cutting cycle G90"},
      {"gsk988ta", "g92", "the thread cutting cycle G92"},
      {"gsk988ta", "g94", "the radial cutting cycle G94"},
      {"gsk988ta", "g110", "the circular pocket G110 and G111"},
      {"gsk988ta", "g112", "the helical circular pocket G112 and G113"},
      {"gsk988ta", "g114", "external thread milling G114 and G115"},
      {"gsk988ta", "g116", "internal thread milling G116 and G117"},
  });
  return kVocabulary;
}

}  // namespace gonogo::oracle
