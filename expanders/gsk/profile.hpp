// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "expanders/common/machine_profile.hpp"

namespace gonogo::expanders::gsk {

inline constexpr auto kReadings = std::to_array<ReadingChoices>({
    {"gsk.pocket.end", "initial|r-plane"},
    {"gsk.g94.rewrite", "keep|clear|clear-all"},
    {"gsk.g94.after-00", "stays|cancelled"},
    {"gsk.g94.empty-block", "none|repeat"},
    {"gsk.g94.still-axis", "alarm|ignored"},
    {"gsk.g94.taper-limit", "run|alarm"},
    {"gsk.g80.motion", "traverse|kept"},
    {"gsk.pocket.p-beyond", "r-plane|literal"},
    {"gsk.pocket.q-zero", "one-layer|alarm"},
    {"gsk.helix.return", "rapid|feed"},
    {"gsk.thread.return", "rapid|feed"},
    {"gsk.missing-axis", "skip|position|current"},
    {"gsk.zero-depth", "no-cut|alarm"},
    {"gsk.pocket.pair", "shared|each"},
    {"gsk.pocket.retained", "length|number"},
    {"gsk.pocket.R", "per-block|modal"},
    {"gsk.x-depth", "diameter|radius"},
    {"gsk.duplicate", "alarm|last"},
    {"gsk.g94.in-mode", "keep|clear"},
    {"gsk.zero-depth-end", "initial|r-plane"},
    {"gsk.g92.lead", "own|feed"},
    {"gsk.retained", "keep|clear|number|in-plane"},
    {"gsk.feed-change", "kept|deleted"},
    {"gsk.dwell-without-word", "alarm|none"},
    {"gsk.arc.closed", "alarm|none"},
    {"gsk.arc.tolerance-zero", "off|exact"},
    {"gsk.arc.no-centre", "alarm|line"},
    {"gsk.arc.small-radius", "alarm|semicircle"},
    {"gsk.g50.initial-plane", "shifted|kept"},
    {"gsk.helix.entry-side", "any|+p"},
    {"gsk.helix.flat", "off|on"},
    {"gsk.helix.L", "per-block|modal"},
    {"gsk.thread.path", "any|arc"},
    {"gsk.thread.v-from", "r-plane|initial"},
    {"gsk.thread.mode", "pairs|one"},
    {"gsk.thread.modal", "code|words|none"},
    {"gsk.thread.direction", "alarm|free"},
    {"gsk.thread.r", "optional|required"},
    {"gsk.thread.k-range", "360|table"},
    {"gsk.thread.runout", "any|polar|radial|tangent"},
    {"gsk.decimals", "keep|nearest|alarm"},
    // This machine has one outcome of these.
    {"gsk.m-functions", "one"},
    {"gsk.pocket.path", "concentric"},
    {"gsk.pocket.p-omitted", "0"},
    {"gsk.arc.zero-radius", "alarm"},
    {"gsk.feed-units", "length"},
    {"gsk.rotary-feed-inch", "scaled"},
});

consteval Reading operator""_reading(const char* name, std::size_t size) {
  return find_reading(kReadings, {name, size});
}

// The machine parameters, in the order of their table: how far radii may differ, mm, the angle and
// the length of run-outs, and whether words that stand twice alarm (below 0: the reading says).
inline constexpr std::size_t kRadiusTolerance = 0;
inline constexpr std::size_t kRunOutAngle = 1;
inline constexpr std::size_t kRunOutDistance = 2;
inline constexpr std::size_t kDuplicatesAlarm = 3;

}  // namespace gonogo::expanders::gsk
