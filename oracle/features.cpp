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
      {"hnc21t", "basic", "G00, G01, G04, units, diameters, work offsets, G90 to G95"},
      {"hnc21t", "arc", "G02 and G03"},
      {"hnc21t", "g32", "thread cutting G32"},
      {"hnc21t", "g74", "deep drilling of the face G74"},
      {"hnc21t", "g75", "grooving of the diameter G75"},
      {"hnc21t", "g80", "the diameter cutting cycle G80"},
      {"hnc21t", "g81", "the face cutting cycle G81"},
      {"hnc21t", "g82", "the thread cutting cycle G82"},
      {"rs274", "basic", "G0, G1, G4, G80, units, G90 and G91"},
      {"rs274", "arc", "G2 and G3 by their centre in G17"},
      {"rs274", "arc-r", "G2 and G3 by their radius"},
      {"rs274", "planes", "G2 and G3 in G18 and G19"},
      {"rs274", "helix", "G2 and G3 with the third axis"},
      {"rs274", "arc-distance", "G90.1 and G91.1"},
      {"rs274", "turns", "G2 and G3 with P turns"},
      {"rs274", "lines",
       "the form of lines, words that nothing uses, and the end of a program, as documented"},
      {"rs274", "g81", "the drilling cycles G81 and G82"},
      {"sinumerik840d", "basic", "G0, G1, G4, units, G90 and G91, AC and IC, G94 and G95"},
      {"sinumerik840d", "arc", "G2 and G3 by their centre in the plane in force"},
      {"sinumerik840d", "cr", "G2 and G3 by CR="},
      {"sinumerik840d", "ar", "G2 and G3 by AR="},
      {"sinumerik840d", "polar", "AP=, RP= and the poles G110, G111, G112"},
      {"sinumerik840d", "planes", "G2 and G3 in G18, G19 and the plane that end points choose"},
      {"sinumerik840d", "helix", "G2 and G3 with the third axis and TURN="},
      {"sinumerik840d", "cip", "CIP, the circle through an intermediate point"},
      {"sinumerik840d", "ct", "CT, the tangent circle"},
      {"sinumerik840d", "expressions", "R parameters, calculations and functions"},
      {"sinumerik840d", "rotary", "the rotary axes A and C"},
      {"sinumerik802s", "basic", "G0, G1, G4, units, G90 and G91, AC and IC, G94 and G95"},
      {"sinumerik802s", "arc", "G2 and G3 by their centre in the plane in force"},
      {"sinumerik802s", "cr", "G2 and G3 by CR="},
      {"sinumerik802s", "ar", "G2 and G3 by AR="},
      {"sinumerik802s", "polar", "AP=, RP= and the poles G110, G111, G112"},
      {"sinumerik802s", "planes", "G2 and G3 in G18, G19 and the plane that end points choose"},
      {"sinumerik802s", "helix", "G2 and G3 with the third axis and TURN="},
      {"sinumerik802s", "cip", "CIP, the circle through an intermediate point"},
      {"sinumerik802s", "ct", "CT, the tangent circle"},
      {"sinumerik802s", "expressions", "R parameters, calculations and functions"},
      {"sinumerik802s", "rotary", "the rotary axes A and C"},
      {"sinumerik802s", "frames", "G158, G258 and G259"},
      {"sinumerik802s", "lcyc82", "the drilling cycle LCYC82"},
      {"sinumerik802s", "lcyc75", "the pocket milling cycle LCYC75"},
  });
  return kVocabulary;
}

}  // namespace gonogo::oracle
