// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "expanders/common/machine_profile.hpp"

namespace gonogo::expanders::sinumerik {

// The last ones are those of 802S.
inline constexpr auto kReadings = std::to_array<ReadingChoices>({
    {"sie.cr.tolerance", "0|const"},
    {"sie.spindle", "off|alarm"},
    {"sie.initial-motion", "g1|g0"},
    {"sie.g70.f", "mm|inch"},
    {"sie.ar.zero", "none|alarm"},
    {"sie.ap.g91", "absolute|incremental"},
    {"sie.cip.collinear", "straight|alarm"},
    {"sie.arc.correct", "start-radius|project|programmed"},
    {"sie.arc.plane", "ends|helix"},
    {"sie.cr.centre", "alarm|radius|centre"},
    {"sie.feed-change", "kept|deleted"},
    {"sie.pole.same-plane", "reset|kept"},
    {"sie.g158", "absolute|additive|translation-only"},
    {"sie.g258", "absolute|rotation-only"},
    {"sie.frame.increment", "alone|with-translation"},
    {"sie.rpl-equals", "lenient|required"},
    {"sie.infeed", "equal|max-rest"},
    {"sie.infeed-from", "reference|clearance"},
    {"sie.corner", "clamp|reject"},
    {"sie.lcyc.unit", "mm|inch|inch-with-feeds"},
    {"sie.lc75.r125-limit", "none|alarm"},
    {"sie.lc75.finish-limit", "alarm|none"},
    {"sie.lc75.feed-after", "kept|of-cycle"},
    {"sie.lc75.no-sense", "alarm|g2|g3"},
    // Split levels are right under both; of the ways within a pocket only the own one is offered.
    {"sie.finish.levels", "split"},
    {"sie.pocket.path", "any"},
});
inline constexpr std::size_t kReadingsOf840D = 12;

consteval Reading operator""_reading(const char* name, std::size_t size) {
  return find_reading(kReadings, {name, size});
}

/// A machine parameter: how far an end may be off its circle, mm, and of the radius at start.
inline constexpr std::size_t kCircleErrorConstant = 0;
inline constexpr std::size_t kCircleErrorFactor = 1;

/// No coordinate or length is larger: a rotation and a translation leave it within Fixed.
inline constexpr Fixed kReach = 1'000'000'000 * kOne;

}  // namespace gonogo::expanders::sinumerik
