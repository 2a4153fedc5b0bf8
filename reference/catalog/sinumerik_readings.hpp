// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readings of SINUMERIK: of the path commands, which both controls have, and of the frames and
// cycles of the 802S.
#pragma once

#include "reference/catalog/reading.hpp"
#include "reference/clause_literal.hpp"

namespace gonogo::reference::catalog {

inline constexpr auto kSinumerikPathReadings = of_dialect(
    "sinumerik840d", "sinumerik802s",
    std::to_array<Reading>({
        {.name = "sie.arc.correct",
         .alternatives = {"start-radius", "project", "programmed"},
         .clause = "SIE-ARC-08"_clause,
         .text = "the centre of an arc whose end misses its circle within the limit: on the "
                 "perpendicular bisector at the radius of the start, the programmed one projected "
                 "on it, or the programmed one with a radius linear in the angle"},
        {.name = "sie.cr.tolerance",
         .alternatives = {"0", "const"},
         .clause = "SIE-ARC-11"_clause,
         .text = "by how much a chord may exceed twice CR: not at all, or by CIRCLE_ERROR_CONST "
                 "(the arc is then half a turn about the chord's middle)"},
        {.name = "sie.cr.centre",
         .alternatives = {"alarm", "radius", "centre"},
         .clause = "SIE-ARC-16"_clause,
         .text = "CR= beside I, J or K: an alarm, an arc of that radius, or one about that centre"},
        {.name = "sie.arc.plane",
         .alternatives = {"ends", "helix"},
         .clause = "SIE-ARC-12"_clause,
         .text = "an arc to two axes that are not the plane's, by CR= or the centre word of the "
                 "common axis alone: in the plane of these axes, or a helix of the plane in force"},
        {.name = "sie.ar.zero",
         .alternatives = {"none", "alarm"},
         .clause = "SIE-ARC-05"_clause,
         .text = "an arc of the angle AR=0 that would move nothing: no motion, or an alarm"},
        {.name = "sie.ap.g91",
         .alternatives = {"absolute", "incremental"},
         .clause = "SIE-POL-02"_clause,
         .text = "AP under G91: counted from the first axis of the plane, or from the angle in "
                 "force"},
        {.name = "sie.pole.same-plane",
         .alternatives = {"reset", "kept"},
         .clause = "SIE-POL-04"_clause,
         .text = "the code of the plane in force: it puts the pole at the zero and ends AP and RP, "
                 "or leaves them"},
        {.name = "sie.cip.collinear",
         .alternatives = {"straight", "alarm"},
         .clause = "SIE-CIP-01"_clause,
         .text = "CIP with its intermediate point on the straight line between start and end: that "
                 "line, or an alarm"},
        {.name = "sie.spindle",
         .alternatives = {"off", "alarm"},
         .fallback = "off",
         .clause = "SIE-G1-02"_clause,
         .text = "cutting while the spindle stands: no matter, or an alarm"},
        {.name = "sie.initial-motion",
         .alternatives = {"g1", "g0"},
         .clause = "SIE-MOD-02"_clause,
         .text = "the motion in force before any code: G1 or G0"},
        {.name = "sie.g70.f",
         .alternatives = {"mm", "inch"},
         .clause = "SIE-MOD-04"_clause,
         .text = "F under G70: millimetres, or inches"},
        {.name = "sie.feed-change",
         .alternatives = {"kept", "deleted"},
         .clause = "SIE-MOD-08"_clause,
         .text = "F where G94, G95, G96, G961, G97 or G971 changes the feed between minutes and "
                 "revolutions: it stays in force, or a new one is due"},
    }));

inline constexpr auto kSinumerikCycleReadings = of_dialect(
    "sinumerik802s",
    std::to_array<Reading>({
        {.name = "sie.g158",
         .alternatives = {"absolute", "additive", "translation-only"},
         .clause = "SIE-FRM-01"_clause,
         .text = "G158: it replaces translation and rotation, is added to those in force, or "
                 "replaces the translation alone"},
        {.name = "sie.rpl-equals",
         .alternatives = {"lenient", "required"},
         .clause = "SIE-FRM-03"_clause,
         .text = "RPL45 without '=': read as RPL=45, or an alarm"},
        {.name = "sie.g258",
         .alternatives = {"absolute", "rotation-only"},
         .clause = "SIE-FRM-04"_clause,
         .text = "G258: it replaces translation and rotation, or the rotation alone"},
        {.name = "sie.frame.increment",
         .alternatives = {"alone", "with-translation"},
         .clause = "SIE-FRM-06"_clause,
         .text = "an increment behind another translation: its number alone, or that and what the "
                 "translation has moved along the axis"},
        {.name = "sie.infeed",
         .alternatives = {"equal", "max-rest"},
         .by_properties = true,
         .clause = "SIE-LC75-06"_clause,
         .text = "how the depth of a pocket is divided: equal infeeds, whole ones and a rest, or "
                 "any of at most R121"},
        {.name = "sie.infeed-from",
         .alternatives = {"reference", "clearance"},
         .clause = "SIE-LC75-06"_clause,
         .text = "where the divided depth begins: at the reference plane, or R102 above it"},
        {.name = "sie.finish.levels",
         .alternatives = {"split"},
         .by_properties = true,
         .clause = "SIE-LC75-11"_clause,
         .text = "the levels of finishing: divided as in roughing, or also one at the full depth"},
        {.name = "sie.corner",
         .alternatives = {"clamp", "reject"},
         .clause = "SIE-LC75-09"_clause,
         .text = "a corner radius above half the width or length: as large as fits, or an alarm"},
        {.name = "sie.pocket.path",
         .alternatives = {"contour-parallel"},
         .by_properties = true,
         .clause = "SIE-LC75-12"_clause,
         .text = "the path that clears a level: judged by what it clears, or the given one"},
        {.name = "sie.lcyc.unit",
         .alternatives = {"mm", "inch", "inch-with-feeds"},
         .clause = "SIE-LC75-01"_clause,
         .text = "the lengths among the parameters of LCYC75 and LCYC82 under G70: millimetres, or "
                 "inches; and whether the feeds R122 and R123 are inches with them"},
        {.name = "sie.lc75.r125-limit",
         .alternatives = {"none", "alarm"},
         .clause = "SIE-LC75-09"_clause,
         .text = "an allowance in depth R125 that is not smaller than the tool's diameter: no "
                 "matter, or an alarm"},
        {.name = "sie.lc75.finish-limit",
         .alternatives = {"alarm", "none"},
         .clause = "SIE-LC75-09"_clause,
         .text = "an allowance R124 that is not smaller than the tool's diameter, in finishing: an "
                 "alarm as in roughing, or no matter"},
        {.name = "sie.lc75.feed-after",
         .alternatives = {"kept", "of-cycle"},
         .clause = "SIE-LC75-14"_clause,
         .text = "the feed behind LCYC75, where no F stands behind it: F of before, or R123"},
        {.name = "sie.lc75.no-sense",
         .alternatives = {"alarm", "g2", "g3"},
         .clause = "SIE-LC75-09"_clause,
         .text = "R126=0, as in the maker's second example: an alarm, or the way round of G2 or of "
                 "G3"},
    }));

}  // namespace gonogo::reference::catalog
