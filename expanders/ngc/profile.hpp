// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "expanders/common/machine_profile.hpp"

namespace gonogo::expanders::ngc {

inline constexpr auto kReadings = std::to_array<ReadingChoices>({
    {"ngc.whole", "exact|nist|linuxcnc|grbl"},
    {"ngc.arc-tolerance", "nist|linuxcnc|page|grbl"},
    {"ngc.full-circle-words", "free|needed"},
    {"ngc.g80-beside", "alarm|ignored"},
    {"ngc.unused-words", "alarm|ignored"},
    {"ngc.line-number", "decimal|whole"},
    {"ngc.o-name", "passed-over|syntax"},
    {"ngc.program-end", "needed|free"},
    {"ngc.bare-motion", "nothing|missing-word"},
    {"ngc.arc-words-alone", "arc|alarm"},
    {"ngc.missing-tool", "taken|alarm"},
    {"ngc.g94-feed", "kept|none"},
    {"ngc.feed-units", "before|after"},
    {"ngc.block-delete", "unread|read"},
    {"ngc.lone-cr", "line-end|blank"},
    {"ngc.long-line", "read|syntax"},
    {"ngc.alarm-dwell", "none|dwells"},
    {"ngc.cycle.initial", "series|block"},
    {"ngc.cycle.g91-r", "current|initial|absolute"},
    {"ngc.cycle.sticky", "number|level"},
    {"ngc.cycle.approach", "current-level|initial-level"},
    {"ngc.cycle.initial-kept", "place|number"},
    {"ngc.cycle.retract-start", "r-plane|initial"},
    {"ngc.cycle.feed", "needed|free"},
    {"ngc.cycle.alarm-at", "block|late"},
    {"ngc.cycle.alarm-at-q", "hole|block"},
    {"ngc.g83.retract", "r-plane|clear"},
    {"ngc.g83.return", "rapid|feed"},
    {"ngc.peck.clearance", "ten-thou|one-mm|tenth-mm|twentieth"},
    {"ngc.peck.d", "barred|clearance"},
    {"ngc.peck.dwell", "none|quarter"},
    {"ngc.g73.end", "r-plane|clear|both"},
    {"ngc.g85.out", "r-plane|clear"},
    {"ngc.tap.p", "optional|last|needed|barred"},
    {"ngc.g74.l", "allowed|barred"},
    {"ngc.g33.k", "positive|free"},
    {"ngc.g76.checks", "text|linuxcnc"},
    {"ngc.g76.slide", "start|end"},
    {"ngc.g76.entry", "thread|feed|rapid"},
});

consteval Reading operator""_reading(const char* name, std::size_t size) {
  return find_reading(kReadings, {name, size});
}

}  // namespace gonogo::expanders::ngc
