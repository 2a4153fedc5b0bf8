// SPDX-License-Identifier: GPL-3.0-or-later
//
// Why the gauge cannot say (R9): a gap is made for one of these reasons, and for no other.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace gonogo::oracle {

enum class GapReason : std::uint8_t {
  none,           // it is no gap
  not_covered,    // a code or construct that the gauge does not read
  profile_lacks,  // something of the machine that the profile does not say
  comparison,     // two numbers, or a place and a limit, cannot be distinguished (R9)
  rounding,       // points whose rounding decides what they make
  two_readings,   // one trace may be read in two ways, and they lead to different verdicts
  reading_unfit,  // under the reading the text's own path is none that it allows
  unjudged_form,  // a form of motion that the gauge does not judge there
  // Stated caps (J-CONST).
  cap_assignments,  // of open readings
  cap_ways,         // to read a trace, or where a helix may begin
  cap_small,        // motions in a row that are too small to see
  cap_level,        // motions of a level or of an entry
  cap_area,         // cells, shapes and bands of a level
  cap_records,      // of a program that is to be reduced
  // For sampled positions.
  samples_hole,     // longer than the rhythm of the samples
  samples_rate,     // a motion that no sample shows
  samples_scatter,  // more than the tolerance
  samples_open,     // a path that samples do not decide
  samples_end,      // they end in a dwell
  samples_stand,    // the machine stands for longer than its dwells
};

// As results, reports and the program write them.
inline constexpr std::array<std::string_view, 20> kGapReasons = {"",
                                                                 "not-covered",
                                                                 "profile-lacks",
                                                                 "comparison",
                                                                 "rounding",
                                                                 "two-readings",
                                                                 "reading-unfit",
                                                                 "unjudged-form",
                                                                 "cap-assignments",
                                                                 "cap-ways",
                                                                 "cap-small",
                                                                 "cap-level",
                                                                 "cap-area",
                                                                 "cap-records",
                                                                 "samples-hole",
                                                                 "samples-rate",
                                                                 "samples-scatter",
                                                                 "samples-open",
                                                                 "samples-end",
                                                                 "samples-stand"};

constexpr std::string_view name(GapReason reason) {
  return kGapReasons[static_cast<std::size_t>(reason)];
}
static_assert(name(GapReason::samples_stand) == "samples-stand");

}  // namespace gonogo::oracle
