// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "expanders/common/machine_profile.hpp"

namespace gonogo::expanders::hnc {

inline constexpr auto kReadings = std::to_array<ReadingChoices>({
    {"hnc.g75.i", "I|P"},
    {"hnc.g75.steps", "i-plus-1|i"},
    {"hnc.g75.end", "start|last"},
    {"hnc.g75.mode3", "off|on"},
    {"hnc.g75.depth-scale", "radius|diameter"},
    {"hnc.peck.from", "last-bottom|withdrawn"},
    {"hnc.peck.withdraw", "rapid|feed"},
    {"hnc.peck.clamp", "none|start"},
    {"hnc.g82.q", "read|alarm"},
    {"hnc.g82.exit", "rapid|feed"},
    {"hnc.g82.e-scale", "radius|diameter"},
    {"hnc.g82.starts", "all|one"},
    {"hnc.modal.f", "feed|forgotten"},
    {"hnc.offset.initial", "G54|none"},
    {"hnc.arc.zero-radius", "alarm|none"},
    {"hnc.arc.closed", "alarm|none"},
    {"hnc.arc.small-radius", "alarm|semicircle"},
    {"hnc.missing-axis", "reject|keep|none|nothing"},
    {"hnc.modal.words", "forgotten|kept"},
    {"hnc.retained", "length|number"},
    {"hnc.g32.lead", "alarm|kept|feed"},
    {"hnc.rewrite", "keep|clear"},
    {"hnc.empty-block", "none|repeat"},
    {"hnc.g74.x", "none|first"},
    {"hnc.g74.mode3", "off|on"},
    {"hnc.g75.zero-width", "each|once"},
    {"hnc.g82.order", "rising|falling"},
    {"hnc.feed-change", "kept|deleted"},
    {"hnc.feed-units", "length|number"},
    {"hnc.dwell.unit", "ms|s"},
    {"hnc.lead.unit", "mm|units|tpi|units-tpi"},
});

consteval Reading operator""_reading(const char* name, std::size_t size) {
  return find_reading(kReadings, {name, size});
}

/// A machine parameter: how far radii may differ, mm; below 0 it is not looked at.
inline constexpr std::size_t kRadiusTolerance = 0;

}  // namespace gonogo::expanders::hnc
