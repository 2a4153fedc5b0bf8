// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readings of the canned cycles of RS274/NGC. In the order of ReadingKey. The first alternative
// is what the documents of LinuxCNC say; where they say nothing, what NIST's interpreter does, else
// LinuxCNC. Open where they say nothing, or where NIST's report or another edition says otherwise.
#pragma once

#include <vector>

#include "reference/reading.hpp"

namespace gonogo::reference::catalog {

inline Reading of_ngc_cycle(ReadingKey key, std::string_view name,
                            std::vector<std::string_view> alternatives, ClauseId clause,
                            std::string_view text) {
  return {key, name, "rs274", std::move(alternatives), "any", false, false, clause, text};
}

// The documents, which agree, have the first one alone.
inline Reading stated_of_ngc_cycle(ReadingKey key, std::string_view name,
                                   std::vector<std::string_view> alternatives, ClauseId clause,
                                   std::string_view text) {
  Reading reading = of_ngc_cycle(key, name, std::move(alternatives), clause, text);
  reading.fallback = reading.alternatives.front();
  return reading;
}

// NOLINTNEXTLINE(readability-function-size): a table.
inline std::vector<Reading> rs274_cycle_readings() {
  return {
      of_ngc_cycle(ReadingKey::ngc_cycle_initial, "ngc.cycle.initial", {"series", "block"},
                   "NGC-CYC-08"_clause,
                   "the level to which G98 returns: where the tool was before the series, as the "
                   "documents and LinuxCNC have it; or before the block, as NIST's interpreter, "
                   "grblHAL, CAMotics and FreeCAD have it. Asked for only where the two differ"),
      stated_of_ngc_cycle(
          ReadingKey::ngc_cycle_g91_r, "ngc.cycle.g91-r", {"current", "initial", "absolute"},
          "NGC-CYC-06"_clause,
          "what R counts from under G91: from where the tool is, as the documents, NIST's "
          "interpreter and grblHAL have it; from the initial level of the series, as "
          "LinuxCNC has it; or R is a coordinate, as CAMotics has it"),
      stated_of_ngc_cycle(
          ReadingKey::ngc_cycle_sticky, "ngc.cycle.sticky", {"number", "level"},
          "NGC-CYC-03"_clause,
          "what is kept of R and of the word of the third axis: their numbers, read anew "
          "under the distance mode in force, as the documents, LinuxCNC and NIST's "
          "interpreter have it; or the levels that they gave, as grblHAL has it. Asked "
          "for only where the levels differ"),
      stated_of_ngc_cycle(
          ReadingKey::ngc_cycle_approach, "ngc.cycle.approach", {"current-level", "initial-level"},
          "NGC-CYC-12"_clause,
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
                   "first hole where Q is not above zero or the spindle does not turn as it must, "
                   "behind the dwell of a G4 of the block"),
      of_ngc_cycle(ReadingKey::ngc_g83_retract, "ngc.g83.retract", {"r-plane", "clear"},
                   "NGC-G83-02"_clause,
                   "the way out between two pecks of G83: to R, also under G98, as the documents, "
                   "LinuxCNC and FreeCAD have it; or to the level to which the hole is left, as "
                   "NIST's interpreter and grblHAL have it. Asked for only where the two differ"),
      stated_of_ngc_cycle(
          ReadingKey::ngc_g83_return, "ngc.g83.return", {"rapid", "feed"}, "NGC-G83-03"_clause,
          "the way back into the hole of G83: a traverse to the clearance above the last "
          "peck; or none, so that the next peck feeds all the way, as grblHAL has it"),
      of_ngc_cycle(ReadingKey::ngc_peck_clearance, "ngc.peck.clearance",
                   {"ten-thou", "one-mm", "tenth-mm", "twentieth"}, "NGC-G83-04"_clause,
                   "how far above the last peck G73 withdraws and G83 comes back: 0.010 inch, as "
                   "the documents, LinuxCNC and NIST's interpreter have it; the number 1 of a "
                   "metric machine or 0.05 of an inch machine, in the units in force, as LinuxCNC "
                   "2.10 has it; 0.1 mm, as grblHAL has it for G73; or a twentieth of Q, as "
                   "FreeCAD has it"),
      of_ngc_cycle(ReadingKey::ngc_peck_d, "ngc.peck.d", {"barred", "clearance"},
                   "NGC-G83-08"_clause,
                   "D of G73 and G83: a word that nothing uses; or that clearance, as LinuxCNC "
                   "2.10 has it"),
      stated_of_ngc_cycle(
          ReadingKey::ngc_peck_dwell, "ngc.peck.dwell", {"none", "quarter"}, "NGC-G83-01"_clause,
          "a dwell at the bottom of every peck of G73 and G83: none; or of a quarter of a "
          "second, as grblHAL has it"),
      of_ngc_cycle(ReadingKey::ngc_g73_end, "ngc.g73.end", {"r-plane", "clear", "both"},
                   "NGC-G73-02"_clause,
                   "where G73 leaves the hole: to R, also under G98, as its page in the documents "
                   "has it; to the level that G98 and G99 say, as LinuxCNC and grblHAL have it; or "
                   "to the one and then to the other, as FreeCAD has it. Asked for only where the "
                   "two differ"),
      of_ngc_cycle(ReadingKey::ngc_g85_out, "ngc.g85.out", {"r-plane", "clear"},
                   "NGC-G85-01"_clause,
                   "how far G85 feeds out of the hole: to R, as the documents and LinuxCNC have "
                   "it; or to the level that G98 and G99 say, as NIST's interpreter and CAMotics "
                   "have it. Asked for only where the two differ"),
      of_ngc_cycle(ReadingKey::ngc_tap_p, "ngc.tap.p", {"optional", "last", "needed", "barred"},
                   "NGC-G84-04"_clause,
                   "P of G84 and G74: a dwell where it stands; left out, that of the last cycle "
                   "that had one, as LinuxCNC has it; an alarm where a first block lacks it, as "
                   "grblHAL has it; or a word that nothing uses, as NIST's interpreter has it"),
      of_ngc_cycle(ReadingKey::ngc_g74_l, "ngc.g74.l", {"allowed", "barred"}, "NGC-G74-01"_clause,
                   "L of G74: the number of holes, as its page in the documents has it; or a word "
                   "that nothing uses, as LinuxCNC has it"),
      of_ngc_cycle(ReadingKey::ngc_g33_k, "ngc.g33.k", {"positive", "free"}, "NGC-G33-05"_clause,
                   "K of G33 and G33.1 that is not above zero: an alarm; or taken, as LinuxCNC has "
                   "it"),
      stated_of_ngc_cycle(
          ReadingKey::ngc_g76_checks, "ngc.g76.checks", {"text", "linuxcnc"}, "NGC-G76-03"_clause,
          "what of a G76 alarms: all that the documents forbid; or what LinuxCNC looks "
          "at, which takes any plane, X and Y for its last traverse, no Z for the place "
          "where it is, any P, R below 1 for 1, H-1 for no full pass, E below zero for 0 "
          "and any other, the last two bits of L, and Q-1 for 0"),
      of_ngc_cycle(ReadingKey::ngc_g76_slide, "ngc.g76.slide", {"start", "end"},
                   "NGC-G76-08"_clause,
                   "where the passes of a G76 with Q begin: the later the deeper, as LinuxCNC has "
                   "it; or all of one length, the last where the block begins, as grblHAL has it"),
      of_ngc_cycle(ReadingKey::ngc_g76_entry, "ngc.g76.entry", {"thread", "feed", "rapid"},
                   "NGC-G76-09"_clause,
                   "how G76 goes in to a taper at its start: in step with the spindle, as LinuxCNC "
                   "has it; at the feed, as the documents have it; or by a traverse, as grblHAL "
                   "has it"),
  };
}

}  // namespace gonogo::reference::catalog
