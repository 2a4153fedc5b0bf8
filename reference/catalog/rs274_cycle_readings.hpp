// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readings of the canned cycles of RS274/NGC. The first alternative
// is what the documents of LinuxCNC say; where they say nothing, what NIST's interpreter does, else
// LinuxCNC. Open where they say nothing, or where NIST's report or another edition says otherwise.
#pragma once

#include "reference/catalog/reading.hpp"
#include "reference/clause_literal.hpp"

namespace gonogo::reference::catalog {

inline constexpr auto kNgcCycleReadings = of_dialect(
    "rs274",
    std::to_array<Reading>({
        {.name = "ngc.cycle.initial",
         .alternatives = {"series", "block"},
         .clause = "NGC-CYC-08"_clause,
         .text = "the level to which G98 returns: where the tool was before the series, as the "
                 "documents and LinuxCNC have it; or before the block, as NIST's interpreter, "
                 "grblHAL, CAMotics and FreeCAD have it. Asked for only where the two differ"},
        {.name = "ngc.cycle.g91-r",
         .alternatives = {"current", "initial", "absolute"},
         .fallback = "current",
         .clause = "NGC-CYC-06"_clause,
         .text = "what R counts from under G91: from where the tool is, as the documents, NIST's "
                 "interpreter and grblHAL have it; from the initial level of the series, as "
                 "LinuxCNC has it; or R is a coordinate, as CAMotics has it"},
        {.name = "ngc.cycle.sticky",
         .alternatives = {"number", "level"},
         .fallback = "number",
         .clause = "NGC-CYC-03"_clause,
         .text = "what is kept of R and of the word of the third axis: their numbers, read anew "
                 "under the distance mode in force, as the documents, LinuxCNC and NIST's "
                 "interpreter have it; or the levels that they gave, as grblHAL has it. Asked for "
                 "only where the levels differ"},
        {.name = "ngc.cycle.approach",
         .alternatives = {"current-level", "initial-level"},
         .fallback = "current-level",
         .clause = "NGC-CYC-12"_clause,
         .text = "the way to the first hole of a block: lifted to R from below it, across at the "
                 "level of the tool, and down; or, as LinuxCNC has it, lifted only where the "
                 "initial level is below R, and from a tool that is not above R in one traverse of "
                 "all axes to the clear level. Asked for only where the ways differ"},
        {.name = "ngc.cycle.initial-kept",
         .alternatives = {"place", "number"},
         .clause = "NGC-CYC-09"_clause,
         .text = "the initial level when units or plane change within a series: a place, and "
                 "another plane begins a new series; or, as LinuxCNC has it, a bare number that "
                 "passes over to the new units and the new axis"},
        {.name = "ngc.cycle.retract-start",
         .alternatives = {"r-plane", "initial"},
         .clause = "NGC-CYC-10"_clause,
         .text = "a cycle before G98 or G99 was given: as under G99, as NIST's interpreter, "
                 "LinuxCNC and CAMotics have it; or as under G98, as grblHAL has it"},
        {.name = "ngc.cycle.feed",
         .alternatives = {"needed", "free"},
         .clause = "NGC-CYC-20"_clause,
         .text = "a cycle without a feed: an alarm, as LinuxCNC and grblHAL have it and as it is "
                 "of every cut; or it runs, as NIST's interpreter has it"},
        {.name = "ngc.cycle.alarm-at",
         .alternatives = {"block", "late"},
         .clause = "NGC-CYC-29"_clause,
         .text = "what is moved of a block that alarms: nothing; or, as LinuxCNC and NIST's "
                 "interpreter have it, the lift to R where P or Q is missing, and the way to the "
                 "first hole where Q is not above zero or the spindle does not turn as it must, "
                 "behind the dwell of a G4 of the block"},
        {.name = "ngc.cycle.alarm-at-q",
         .alternatives = {"hole", "block"},
         .clause = "NGC-CYC-29"_clause,
         .text = "what is moved under ngc.cycle.alarm-at = late of a block whose Q is not above "
                 "zero: the way to the first hole, as LinuxCNC has it; or nothing, as NIST's "
                 "interpreter has it, which looks at Q as it reads it"},
        {.name = "ngc.g83.retract",
         .alternatives = {"r-plane", "clear"},
         .clause = "NGC-G83-02"_clause,
         .text = "the way out between two pecks of G83: to R, also under G98, as the documents, "
                 "LinuxCNC and FreeCAD have it; or to the level to which the hole is left, as "
                 "NIST's interpreter and grblHAL have it. Asked for only where the two differ"},
        {.name = "ngc.g83.return",
         .alternatives = {"rapid", "feed"},
         .fallback = "rapid",
         .clause = "NGC-G83-03"_clause,
         .text = "the way back into the hole of G83: a traverse to the clearance above the last "
                 "peck; or none, so that the next peck feeds all the way, as grblHAL has it"},
        {.name = "ngc.peck.clearance",
         .alternatives = {"ten-thou", "one-mm", "tenth-mm", "twentieth"},
         .clause = "NGC-G83-04"_clause,
         .text = "how far above the last peck G73 withdraws and G83 comes back: 0.010 inch, as the "
                 "documents, LinuxCNC and NIST's interpreter have it; the number 1 of a metric "
                 "machine or 0.05 of an inch machine, in the units in force, as LinuxCNC 2.10 has "
                 "it; 0.1 mm, as grblHAL has it for G73; or a twentieth of Q, as FreeCAD has it"},
        {.name = "ngc.peck.d",
         .alternatives = {"barred", "clearance"},
         .clause = "NGC-G83-08"_clause,
         .text = "D of G73 and G83: a word that nothing uses; or that clearance, as LinuxCNC 2.10 "
                 "has it"},
        {.name = "ngc.peck.dwell",
         .alternatives = {"none", "quarter"},
         .fallback = "none",
         .clause = "NGC-G83-01"_clause,
         .text = "a dwell at the bottom of every peck of G73 and G83: none; or of a quarter of a "
                 "second, as grblHAL has it"},
        {.name = "ngc.g73.end",
         .alternatives = {"r-plane", "clear", "both"},
         .clause = "NGC-G73-02"_clause,
         .text =
             "where G73 leaves the hole: to R, also under G98, as its page in the documents has "
             "it; to the level that G98 and G99 say, as LinuxCNC and grblHAL have it; or to the "
             "one and then to the other, as FreeCAD has it. Asked for only where the two differ"},
        {.name = "ngc.g85.out",
         .alternatives = {"r-plane", "clear"},
         .clause = "NGC-G85-01"_clause,
         .text = "how far G85 feeds out of the hole: to R, as the documents and LinuxCNC have it; "
                 "or to the level that G98 and G99 say, as NIST's interpreter and CAMotics have "
                 "it. Asked for only where the two differ"},
        {.name = "ngc.tap.p",
         .alternatives = {"optional", "last", "needed", "barred"},
         .clause = "NGC-G84-04"_clause,
         .text = "P of G84 and G74: a dwell where it stands; left out, that of the last cycle that "
                 "had one, as LinuxCNC has it; an alarm where a first block lacks it, as grblHAL "
                 "has it; or a word that nothing uses, as NIST's interpreter has it"},
        {.name = "ngc.g74.l",
         .alternatives = {"allowed", "barred"},
         .clause = "NGC-G74-01"_clause,
         .text = "L of G74: the number of holes, as its page in the documents has it; or a word "
                 "that nothing uses, as LinuxCNC has it"},
        {.name = "ngc.g33.k",
         .alternatives = {"positive", "free"},
         .clause = "NGC-G33-05"_clause,
         .text =
             "K of G33 and G33.1 that is not above zero: an alarm; or taken, as LinuxCNC has it"},
        {.name = "ngc.g76.checks",
         .alternatives = {"text", "linuxcnc"},
         .fallback = "text",
         .clause = "NGC-G76-03"_clause,
         .text = "what of a G76 alarms: all that the documents forbid; or what LinuxCNC looks at, "
                 "which takes any plane, X and Y for its last traverse, no Z for the place where "
                 "it is, any P, R below 1 for 1, H-1 for no full pass, E below zero for 0 and any "
                 "other, the last two bits of L, and Q-1 for 0"},
        {.name = "ngc.g76.slide",
         .alternatives = {"start", "end"},
         .clause = "NGC-G76-08"_clause,
         .text = "where the passes of a G76 with Q begin: the later the deeper, as LinuxCNC has "
                 "it; or all of one length, the last where the block begins, as grblHAL has it"},
        {.name = "ngc.g76.entry",
         .alternatives = {"thread", "feed", "rapid"},
         .clause = "NGC-G76-09"_clause,
         .text =
             "how G76 goes in to a taper at its start: in step with the spindle, as LinuxCNC has "
             "it; at the feed, as the documents have it; or by a traverse, as grblHAL has it"},
    }));

}  // namespace gonogo::reference::catalog
