// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readings of the HNC-21T.
#pragma once

#include "reference/catalog/reading.hpp"
#include "reference/clause_literal.hpp"

namespace gonogo::reference::catalog {

inline constexpr auto kHncReadings = of_dialect(
    "hnc21t",
    std::to_array<Reading>({
        {.name = "hnc.missing-axis",
         .alternatives = {"reject", "keep", "none", "nothing"},
         .clause = "HNC-MOD-03"_clause,
         .text = "a block of a cycle with only one of X and Z: an alarm, the other as in the block "
                 "before, no travel along it, or nothing moves"},
        {.name = "hnc.peck.from",
         .alternatives = {"last-bottom", "withdrawn"},
         .clause = "HNC-G74-02"_clause,
         .text = "where the depth of a peck counts from: the bottom of the last peck, or the "
                 "withdrawn point"},
        {.name = "hnc.peck.withdraw",
         .alternatives = {"rapid", "feed"},
         .clause = "HNC-G74-02"_clause,
         .text = "the withdrawal between pecks: a traverse, or at the feed"},
        {.name = "hnc.peck.clamp",
         .alternatives = {"none", "start"},
         .clause = "HNC-G74-04"_clause,
         .text = "a withdrawal that would pass A: not limited, or ending at A"},
        {.name = "hnc.g75.i",
         .alternatives = {"I", "P"},
         .clause = "HNC-G75-04"_clause,
         .text = "the address of the number of axial steps, which the text never prints"},
        {.name = "hnc.g75.steps",
         .alternatives = {"i-plus-1", "i"},
         .clause = "HNC-G75-04"_clause,
         .text = "how many plunges i axial infeeds are: one more, or as many"},
        {.name = "hnc.g75.end",
         .alternatives = {"start", "last"},
         .clause = "HNC-G75-04"_clause,
         .text = "where a groove with a width ends: at A, or above its last plunge"},
        {.name = "hnc.g75.mode3",
         .alternatives = {"off", "on"},
         .clause = "HNC-G75-03"_clause,
         .text = "a groove with a width and the depth of a peck but without a withdrawal: plunges "
                 "to X, or traverses to X and that depth further at the feed"},
        {.name = "hnc.g75.depth-scale",
         .alternatives = {"radius", "diameter"},
         .clause = "HNC-G75-01"_clause,
         .text = "e and the depth of a peck in G75: radii, or diameters where X is one"},
        {.name = "hnc.g82.q",
         .alternatives = {"read", "alarm"},
         .clause = "HNC-G82-10"_clause,
         .text = "Q in a block of G82: the constant of the run-out, or a word that the control "
                 "lacks, being older than the versions that have it"},
        {.name = "hnc.g82.exit",
         .alternatives = {"rapid", "feed"},
         .clause = "HNC-G82-01"_clause,
         .text = "from C back to X of A: a traverse, or the thread going on"},
        {.name = "hnc.g82.e-scale",
         .alternatives = {"radius", "diameter"},
         .clause = "HNC-G82-02"_clause,
         .text = "E: a radius value, or a diameter where X is one"},
        {.name = "hnc.g82.starts",
         .alternatives = {"all", "one"},
         .clause = "HNC-G82-09"_clause,
         .text = "a block with several starts: cuts all of them, or only the first"},
        {.name = "hnc.modal.f",
         .alternatives = {"feed", "forgotten"},
         .clause = "HNC-MOD-04"_clause,
         .text = "F of the cycles other than G82: the ordinary feed, or a word of its cycle, "
                 "forgotten with it"},
        {.name = "hnc.modal.words",
         .alternatives = {"forgotten", "kept"},
         .clause = "HNC-MOD-05"_clause,
         .text = "words of a cycle, but F of a feed and its end, where the same cycle comes again "
                 "behind G00 or another motion code that is not of its group: forgotten, or still "
                 "in force"},
        {.name = "hnc.retained",
         .alternatives = {"length", "number"},
         .clause = "HNC-MOD-05"_clause,
         .text =
             "I K R E and Q that a cycle retains, behind a change between G20 and G21: the same "
             "lengths, or the same numbers in the new units"},
        {.name = "hnc.g32.lead",
         .alternatives = {"alarm", "kept", "feed"},
         .clause = "HNC-MOD-04"_clause,
         .text = "G32 without F or J behind another motion code: the lead is missing, or that of "
                 "the last G32 is in force, or F is one word: the lead is the feed in force, and "
                 "the feed behind a thread is its lead"},
        {.name = "hnc.rewrite",
         .alternatives = {"keep", "clear"},
         .clause = "HNC-MOD-05"_clause,
         .text = "the code of the cycle in force written again: its words are kept, or forgotten "
                 "as by another command"},
        {.name = "hnc.empty-block",
         .alternatives = {"none", "repeat"},
         .clause = "HNC-MOD-05"_clause,
         .text = "a block of G74 or G80 to G82 with the code or words of the cycle but no axis "
                 "word: no cycle, or the cycle again"},
        {.name = "hnc.g74.x",
         .alternatives = {"none", "first"},
         .clause = "HNC-G74-04"_clause,
         .text = "X or U in a block of G74: without effect, or a traverse to that X first"},
        {.name = "hnc.g74.mode3",
         .alternatives = {"off", "on"},
         .clause = "HNC-G74-03"_clause,
         .text = "a hole with the depth of a peck but without a withdrawal: drilled to Z, or a "
                 "traverse to Z and that depth further at the feed"},
        {.name = "hnc.g75.zero-width",
         .alternatives = {"each", "once"},
         .clause = "HNC-G75-05"_clause,
         .text = "a groove whose width is zero: as many plunges at one place, or one"},
        {.name = "hnc.g82.order",
         .alternatives = {"rising", "falling"},
         .clause = "HNC-G82-09"_clause,
         .text = "the passes of a thread with several starts: from the first start to the last, or "
                 "the other way"},
        {.name = "hnc.feed-units",
         .alternatives = {"length", "number"},
         .clause = "HNC-COM-01"_clause,
         .text = "F of an earlier block behind a change between G20 and G21: the same speed, or "
                 "the same number in the new units"},
        {.name = "hnc.feed-change",
         .alternatives = {"kept", "deleted"},
         .clause = "HNC-COM-01"_clause,
         .text = "F of an earlier block behind a change between G94 and G95: it stays in force, or "
                 "a new one is due"},
        {.name = "hnc.dwell.unit",
         .alternatives = {"ms", "s"},
         .clause = "HNC-COM-01"_clause,
         .text = "P of G04: milliseconds, or seconds"},
        {.name = "hnc.offset.initial",
         .alternatives = {"G54", "none"},
         .clause = "HNC-COM-01"_clause,
         .text = "the work offset in force at power-on"},
        {.name = "hnc.lead.unit",
         .alternatives = {"mm", "units", "tpi", "units-tpi"},
         .clause = "HNC-G82-07"_clause,
         .text =
             "F and J as leads: F in mm and J in inches; F in the unit in force and J in inches; F "
             "in mm and J as threads per inch; F in the unit in force and J as threads per inch"},
        {.name = "hnc.arc.zero-radius",
         .alternatives = {"alarm", "none"},
         .clause = "HNC-COM-01"_clause,
         .text = "an arc whose start, end and centre are one point: an alarm, or no motion"},
        {.name = "hnc.arc.closed",
         .alternatives = {"alarm", "none"},
         .clause = "HNC-COM-01"_clause,
         .text = "an arc given by R that ends where it starts: an alarm, or no motion"},
        {.name = "hnc.arc.small-radius",
         .alternatives = {"alarm", "semicircle"},
         .clause = "HNC-COM-01"_clause,
         .text = "R less than half the chord by no more than radii may be apart, 0.01 mm or "
                 "parameter 3410: an alarm, or a semicircle over the chord"},
    }));

}  // namespace gonogo::reference::catalog
