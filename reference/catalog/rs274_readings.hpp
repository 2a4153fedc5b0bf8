// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readings of RS274/NGC: where its interpreters differ.
#pragma once

#include "reference/catalog/reading.hpp"
#include "reference/clause_literal.hpp"

namespace gonogo::reference::catalog {

inline constexpr auto kNgcReadings = of_dialect(
    "rs274",
    std::to_array<Reading>({
        {.name = "ngc.arc-tolerance",
         .alternatives = {"nist", "linuxcnc", "page", "grbl"},
         .clause = "NGC-ARC-03"_clause,
         .text = "how far an arc's end may miss its circle: as NIST's interpreter has it, or as "
                 "LinuxCNC's; or by 0.005 mm (0.0005 inch) and, up to 0.5 mm (0.05 inch), a "
                 "thousandth of the radius, as LinuxCNC's page says; or so in mm alone and of the "
                 "radius at the start, as grbl has it"},
        {.name = "ngc.full-circle-words",
         .alternatives = {"free", "needed"},
         .clause = "NGC-ARC-04"_clause,
         .text =
             "an arc by its centre without an axis word of the plane: a full circle, or an alarm"},
        {.name = "ngc.whole",
         .alternatives = {"exact", "nist", "linuxcnc", "grbl"},
         .clause = "NGC-COM-01"_clause,
         .text = "how far an M function, ten times a G code, or P of an arc may be from a whole "
                 "number and count as it: not at all; by 0.0001, as NIST's report says; as "
                 "LinuxCNC has it, by 0.0001 for M and 0.001 for the others; or, as grbl has it, "
                 "M and G are cut at the point and what is behind it is rounded to hundredths"},
        {.name = "ngc.g80-beside",
         .alternatives = {"alarm", "ignored"},
         .clause = "NGC-COM-03"_clause,
         .text = "G80 in a block with another code of the motion group: an alarm, as the documents "
                 "and NIST's interpreter have it; or forgotten, as LinuxCNC has it. Open, for the "
                 "usual first line of a program, G00 G17 G21 G40 G49 G80 G90, hangs on it. Asked "
                 "for only where the group has one other code or G80 again"},
        {.name = "ngc.unused-words",
         .alternatives = {"alarm", "ignored"},
         .fallback = "alarm",
         .clause = "NGC-COM-02"_clause,
         .text = "a word that no code of its block uses: an alarm, on which the documents and all "
                 "interpreters of controls agree; or ignored, as viewers of programs have it. "
                 "Asked for only where such a word stands"},
        {.name = "ngc.line-number",
         .alternatives = {"decimal", "whole"},
         .clause = "NGC-COM-05"_clause,
         .text = "a line number with decimals or above 99999: without meaning as any other, as the "
                 "documents and LinuxCNC have it; or an alarm, as NIST's interpreter has it. Open, "
                 "and asked for only where there is one"},
        {.name = "ngc.o-name",
         .alternatives = {"passed-over", "syntax"},
         .clause = "NGC-COM-06"_clause,
         .text = "a line of O and a number alone: ignored, as LinuxCNC has it; or an alarm, as "
                 "NIST's interpreter has it. No text says which: open, and asked for only where "
                 "there is one"},
        {.name = "ngc.program-end",
         .alternatives = {"needed", "free"},
         .fallback = "needed",
         .clause = "NGC-COM-08"_clause,
         .text = "a text that ends before the program does: an alarm, on which the documents, "
                 "LinuxCNC and NIST's interpreter agree; or the end, as controls have it that are "
                 "sent blocks one by one. Asked for only at such an end"},
        {.name = "ngc.bare-motion",
         .alternatives = {"nothing", "missing-word"},
         .clause = "NGC-MOD-02"_clause,
         .text = "G0 or G1 without an axis word: no motion, as LinuxCNC has it; or an alarm, as "
                 "NIST's interpreter has it. Open, and asked for only where there is one"},
        {.name = "ngc.arc-words-alone",
         .alternatives = {"arc", "alarm"},
         .clause = "NGC-ARC-06"_clause,
         .text = "I J K in a block without a code of motion and axis words, while G2 or G3 is in "
                 "force: an arc, as LinuxCNC has it; or words that nothing uses, as NIST's "
                 "interpreter has it. Open, and asked for only in such a block"},
        {.name = "ngc.g92-other-axes",
         .alternatives = {"zero", "kept"},
         .clause = "NGC-OFS-07"_clause,
         .text = "the offset of an axis that G92 does not name: zero, as the page of G92 says; or "
                 "as it was, as NIST's report and LinuxCNC have it. Open, and asked for only where "
                 "it is not zero"},
        {.name = "ngc.g28-axes",
         .alternatives = {"named", "all"},
         .clause = "NGC-OFS-22"_clause,
         .text = "the axes that G28 and G30 with axis words move on to the reference point: those "
                 "that have a word, as LinuxCNC has it; or all of them, as NIST's report has it. "
                 "Open, and asked for only where an axis without a word is not there"},
        {.name = "ngc.g10-p0",
         .alternatives = {"in-force", "alarm"},
         .clause = "NGC-OFS-21"_clause,
         .text =
             "P0 of G10 L2: the coordinate system in force, as LinuxCNC has it; or an alarm, as "
             "NIST's interpreter has it. Open, and asked for only where there is one"},
        {.name = "ngc.g43-without-h",
         .alternatives = {"loaded", "missing-word"},
         .clause = "NGC-OFS-23"_clause,
         .text = "G43 without H: the length of the tool that is loaded, as LinuxCNC has it; or an "
                 "alarm, as NIST's interpreter has it. Open, and asked for only where there is "
                 "one"},
        {.name = "ngc.logic-order",
         .alternatives = {"last", "among-sums"},
         .clause = "NGC-EXP-09"_clause,
         .text = "AND, OR and XOR before + or - in the same brackets: behind it, as LinuxCNC's "
                 "documents have it; or the left one first, as NIST's report has it. Open, and "
                 "asked for only there, where no comparison stands in the value"},
        {.name = "ngc.equal",
         .alternatives = {"millionth", "ten-thousandth"},
         .clause = "NGC-EXP-02"_clause,
         .text = "by how much less values differ that EQ and NE take for equal: a millionth, as "
                 "the documents say; or a ten-thousandth, as LinuxCNC 2.9 has it. Open, and asked "
                 "for only in between"},
        {.name = "ngc.sign-of-value",
         .alternatives = {"taken", "syntax"},
         .clause = "NGC-EXP-05"_clause,
         .text = "a sign before a parameter, brackets or a function: taken, as LinuxCNC has it; or "
                 "an alarm, as the grammar of NIST's report has it. Open, and asked for only where "
                 "there is one"},
        {.name = "ngc.call-parameters",
         .alternatives = {"kept", "zero"},
         .clause = "NGC-OWD-02"_clause,
         .text = "a parameter up to #30 that a call gives no value: as in the calling lines, as "
                 "the documents say; or zero, as LinuxCNC 2.9 has it. Open, and asked for only "
                 "where one is read that was not zero"},
        {.name = "ngc.m98-before",
         .alternatives = {"runs", "syntax"},
         .clause = "NGC-OWD-14"_clause,
         .text = "M98 of a subprogram that stands before it in the file: it runs, as controls have "
                 "it that keep subprograms in files; or an alarm, as the documents have it. Open, "
                 "and asked for only where there is one"},
        {.name = "ngc.missing-tool",
         .alternatives = {"taken", "alarm"},
         .clause = "NGC-COM-11"_clause,
         .text = "T of a tool that the table, `tools` of the profile, has not: taken, as NIST's "
                 "interpreter has it; or an alarm, as LinuxCNC has it. Open, and asked for only "
                 "where there is one; T0 is no tool"},
        {.name = "ngc.g94-feed",
         .alternatives = {"kept", "none"},
         .clause = "NGC-MOD-03"_clause,
         .text = "the feed behind G94: the one that was in force, as NIST's interpreter has it; or "
                 "none until F is given, as LinuxCNC has it. Open, and asked for only where one "
                 "was in force and the block has no F"},
        {.name = "ngc.feed-units",
         .alternatives = {"before", "after"},
         .fallback = "before",
         .clause = "NGC-MOD-01"_clause,
         .text = "F in the block of a G20 or G21 that changes the units: in the units before it, "
                 "as the order of execution says in which F comes first; or in the units behind "
                 "it, as grblHAL and bCNC have it"},
        {.name = "ngc.block-delete",
         .alternatives = {"unread", "read"},
         .clause = "NGC-COM-12"_clause,
         .text = "a line behind a slash, where such lines are left out, that cannot be read: "
                 "nothing in it is wrong; or an alarm, as on a control that reads a line before it "
                 "leaves it out. Open, and asked for only where there is one"},
        {.name = "ngc.lone-cr",
         .alternatives = {"line-end", "blank"},
         .clause = "NGC-COM-13"_clause,
         .text = "a carriage return without a line feed: ends a line; or is a blank, as NIST's "
                 "interpreter, LinuxCNC, grblHAL and uCNC have it. Open, and asked for only where "
                 "there is one before other text"},
        {.name = "ngc.long-line",
         .alternatives = {"read", "syntax"},
         .clause = "NGC-COM-16"_clause,
         .text = "a line of more than 256 characters: read; or an alarm, as the documents have it. "
                 "Open, and asked for only where there is one"},
        {.name = "ngc.alarm-dwell",
         .alternatives = {"none", "dwells"},
         .clause = "NGC-G4-02"_clause,
         .text = "the dwell of a G4 beside a motion that alarms: none; or the control dwells "
                 "before it finds what is wrong, as LinuxCNC has it. Open, and asked for only "
                 "where nothing else alarms"},
    }));

}  // namespace gonogo::reference::catalog
