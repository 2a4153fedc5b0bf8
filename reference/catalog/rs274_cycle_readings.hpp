// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readings of the canned cycles of RS274/NGC. In the order of ReadingKey. The first alternative
// is what the documents say; where they say nothing, what NIST's interpreter does, else LinuxCNC.
#pragma once

#include <vector>

#include "reference/reading.hpp"

namespace gonogo::reference::catalog {

inline Reading of_ngc_cycle(ReadingKey key, std::string_view name,
                            std::vector<std::string_view> alternatives, ClauseId clause,
                            std::string_view text) {
  const std::string_view first = alternatives.front();
  return {key, name, "rs274", std::move(alternatives), first, false, false, clause, text};
}

// NOLINTNEXTLINE(readability-function-size): a table.
inline std::vector<Reading> rs274_cycle_readings() {
  return {
      of_ngc_cycle(ReadingKey::ngc_cycle_initial, "ngc.cycle.initial", {"series", "block"},
                   "NGC-CYC-08"_clause,
                   "the level to which G98 returns: where the tool was before the series, as the "
                   "documents and LinuxCNC have it; or before the block, as NIST's interpreter, "
                   "grblHAL, CAMotics and FreeCAD have it. Asked for only where the two differ"),
      of_ngc_cycle(ReadingKey::ngc_cycle_g91_r, "ngc.cycle.g91-r",
                   {"current", "initial", "absolute"}, "NGC-CYC-06"_clause,
                   "what R counts from under G91: from where the tool is, as the documents, NIST's "
                   "interpreter and grblHAL have it; from the initial level of the series, as "
                   "LinuxCNC has it; or R is a coordinate, as CAMotics has it"),
      of_ngc_cycle(ReadingKey::ngc_cycle_sticky, "ngc.cycle.sticky", {"number", "level"},
                   "NGC-CYC-03"_clause,
                   "what is kept of R and of the word of the third axis: their numbers, read anew "
                   "under the distance mode in force, as the documents, LinuxCNC and NIST's "
                   "interpreter have it; or the levels that they gave, as grblHAL has it. Asked "
                   "for only where the levels differ"),
      of_ngc_cycle(ReadingKey::ngc_cycle_approach, "ngc.cycle.approach",
                   {"current-level", "initial-level"}, "NGC-CYC-12"_clause,
                   "the way to the first hole of a block: lifted to R from below it, across at the "
                   "level of the tool, and down; or, as LinuxCNC has it, lifted only where the "
                   "initial level is below R, and from a tool that is not above R in one traverse "
                   "of all axes to the clear level. Asked for only where the ways differ"),
      of_ngc_cycle(ReadingKey::ngc_cycle_initial_kept, "ngc.cycle.initial-kept",
                   {"place", "number"}, "NGC-CYC-09"_clause,
                   "the initial level when units or plane change within a series: a place, and "
                   "another plane begins a new series; or, as LinuxCNC has it, a bare number that "
                   "passes over to the new units and the new axis"),
      of_ngc_cycle(ReadingKey::ngc_cycle_retract_start, "ngc.cycle.retract-start",
                   {"r-plane", "initial"}, "NGC-CYC-10"_clause,
                   "a cycle before G98 or G99 was given: as under G99, as NIST's interpreter, "
                   "LinuxCNC and CAMotics have it; or as under G98, as grblHAL has it"),
      of_ngc_cycle(ReadingKey::ngc_cycle_feed, "ngc.cycle.feed", {"needed", "free"},
                   "NGC-CYC-20"_clause,
                   "a cycle without a feed: an alarm, as LinuxCNC and grblHAL have it and as it is "
                   "of every cut; or it runs, as NIST's interpreter has it"),
      of_ngc_cycle(ReadingKey::ngc_cycle_alarm_at, "ngc.cycle.alarm-at", {"block", "late"},
                   "NGC-CYC-29"_clause,
                   "what is moved of a block that alarms: nothing; or, as LinuxCNC and NIST's "
                   "interpreter have it, the lift to R where P or Q is missing, and the way to the "
                   "first hole where Q is not above zero or the spindle does not turn as it must"),
  };
}

}  // namespace gonogo::reference::catalog
