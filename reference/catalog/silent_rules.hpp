// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rules that no text states. A reference has to do something with every program; where the manuals
// say nothing it does what follows here. A departure from such a rule is an advice, not a NO-GO.
// Each has the place where its rule would stand.
#pragma once

#include <array>

#include "reference/catalog/clause.hpp"
#include "reference/catalog/gsk988ta.hpp"
#include "reference/catalog/hnc21t.hpp"
#include "reference/catalog/sinumerik.hpp"
#include "reference/catalog/sinumerik802s.hpp"

namespace gonogo::reference::catalog {
namespace silent {

using enum ClauseLevel;

inline constexpr auto kGsk988ta = std::to_array<Clause>({
    named_otherwise({"GSK-COM-09", open, kBasic,
                     "An axis given both absolute and as an increment in a block is an alarm. No "
                     "text says so; our judgement (on the 980TDi the absolute word holds).",
                     "reference/gsk988ta/words.cpp"},
                    "duplicate-word"),
    refused_by_some({"GSK-COM-10", open, kBasic,
                     "A word that the code in force does not use has no effect; in a block of a "
                     "cycle its range "
                     "is checked. No text says either; our judgement.",
                     "reference/gsk988ta/unused_words.cpp"},
                    "unused-word conflicting-words"),
    named_otherwise({"GSK-COM-11", open, kBasic,
                     "Two M functions in a block are an alarm, or up to three are passed on as "
                     "parameter 3404#7 or the reading says; one that is no whole number that a "
                     "record holds is an alarm. No text says so for every machine; our judgement.",
                     "reference/gsk988ta/words.cpp"},
                    "conflicting-words undefined-code value-out-of-range"),
    named_otherwise(
        refused_by_some({"GSK-COM-12", open, kBasic,
                         "G04 without a time, or with one below zero, is an alarm; S and T below "
                         "zero have no effect. No text says so; our judgement.",
                         "reference/gsk988ta/basic_motion.cpp"},
                        "value-sign value-out-of-range"),
        "value-out-of-range"),
    refused_by_some({"GSK-COM-13", open, kBasic,
                     "A second % ends the program, and what stands behind it is not run; a program "
                     "number before "
                     "the first block may stand again. No text says so; our judgement.",
                     "reference/gsk988ta/interpreter.cpp"},
                    "syntax program-end"),
    {"GSK-COM-14", open, kBasic,
     "Letters of words are capitals, and a block with others cannot be read. No text says whether "
     "lower case is read; our judgement.",
     "reference/dialect.cpp"},
    refused_by_some({"GSK-MOD-10", open, kBasic,
                     "A code of group 01 beside G80 holds, and G80 ends the cycles. No text says "
                     "so; our judgement.",
                     "reference/gsk988ta/interpreter.cpp"},
                    "duplicate-word conflicting-words"),
    named_otherwise({"GSK-G110-19", open, kG110,
                     "A tool radius D of zero is an alarm. No text says so, the table of ranges "
                     "begins at 0; our judgement.",
                     "reference/gsk988ta/milling.cpp"},
                    "value-sign no-tool"),
    named_otherwise({"GSK-G114-17", open, kG114,
                     "A thread height P or a diameter E of zero is an alarm. No text says so, the "
                     "table of ranges begins at 0; our judgement.",
                     "reference/gsk988ta/g114.cpp"},
                    "value-sign"),
    {"GSK-G114-18", open, kG114,
     "An internal thread with a tool radius of just E/2 is an alarm. No text says so: such a tool "
     "stands in the bore; our judgement.",
     "reference/gsk988ta/g114.cpp"},
});

inline constexpr auto kHnc21t = std::to_array<Clause>({
    named_otherwise({"HNC-COM-02", open, hnc21t::kBasic,
                     "An address twice in a block, and two codes of one group, are alarms. No text "
                     "says so; our judgement.",
                     "reference/hnc21t/interpreter.cpp"},
                    "conflicting-words"),
    named_otherwise({"HNC-COM-03", open, hnc21t::kBasic,
                     "X with U, and Z with W, in a block are an alarm. No text says so; our "
                     "judgement.",
                     "reference/hnc21t/interpreter.cpp"},
                    "duplicate-word"),
    named_otherwise(
        refused_by_some(
            {"HNC-COM-04", open, hnc21t::kBasic,
             "F 0 is no feed; a feed below zero, a dwell without P or below zero, and an M "
             "function that is no whole number that a record holds are alarms; S and T below zero "
             "do nothing. No text says so; our judgement.",
             "reference/hnc21t/interpreter.cpp"},
            "value-sign value-out-of-range"),
        "value-sign value-out-of-range feed-missing undefined-code"),
    named_otherwise({"HNC-COM-05", open, hnc21t::kBasic,
                     "The radii of an arc at its start and its end may differ by 0.01 mm, or as "
                     "the profile says. No text says by how much; our judgement.",
                     "reference/hnc21t/arc.cpp"},
                    "arc-radius"),
    refused_by_some({"HNC-COM-06", open, hnc21t::kBasic,
                     "A second % alone ends the program, and what stands behind it is not run; a "
                     "program number "
                     "before the first block may stand again. No text says so; our judgement.",
                     "reference/hnc21t/interpreter.cpp"},
                    "syntax program-end"),
    refused_by_some({"HNC-COM-07", open, hnc21t::kBasic,
                     "A word that the code in force does not use has no effect. No text says so; "
                     "our judgement.",
                     "reference/hnc21t/unused_words.cpp"},
                    "unused-word conflicting-words"),
    {"HNC-COM-08", open, hnc21t::kBasic,
     "Letters of words are capitals, and a block with others cannot be read. No text says whether "
     "lower case is read; our judgement.",
     "reference/dialect.cpp"},
    {"HNC-G82-11", open, hnc21t::kG82,
     "A thread with several starts needs their angle P. No text says what a control does without "
     "it; our judgement.",
     "reference/hnc21t/g82.cpp"},
    refused_by_some({"HNC-G82-12", open, hnc21t::kG82,
                     "R and E, and C and P, are judged on the values in force, of which a block "
                     "may write one alone; an R or E of zero needs no other. No text says so; our "
                     "judgement.",
                     "reference/hnc21t/g82.cpp"},
                    "retract-pair missing-word"),
    refused_by_some({"HNC-G82-13", open, hnc21t::kG82,
                     "The travels of which the longer is along the long axis are those from B to "
                     "C, X as a radius; of equal ones Z is the long one. No text says so; our "
                     "judgement.",
                     "reference/hnc21t/g82.cpp"},
                    "retract-ratio"),
    named_otherwise({"HNC-G75-06", open, hnc21t::kG75,
                     "A width without a number of axial steps, and a number written without a "
                     "width, are alarms. No text says so; our judgement.",
                     "reference/hnc21t/g75.cpp"},
                    "conflicting-words unused-word"),
});

inline constexpr auto kSinumerikPath = std::to_array<Clause>({
    named_otherwise({"SIE-LEX-02", open, sinumerik::kProgram,
                     "A code that stands by itself takes no value: CIP=0 is a syntax alarm; so are "
                     "two signs in a "
                     "row, and G=1. No text says which alarm comes of it; our judgement.",
                     "reference/sinumerik/codes.cpp"},
                    "undefined-code"),
    refused_by_some({"SIE-LEX-03", open, sinumerik::kProgram,
                     "'&' and characters that are not printed are blanks on the 802S, too. No text "
                     "says so; our judgement.",
                     "reference/sinumerik/interpreter.cpp"},
                    "syntax undefined-code"),
    refused_by_some({"SIE-LEX-04", open, sinumerik::kProgram,
                     "A line with % behind a block ends the program, and what stands behind it is "
                     "not run. No text says so; our judgement.",
                     "reference/sinumerik/interpreter.cpp"},
                    "syntax program-end"),
    named_otherwise({"SIE-PAR-02", open, sinumerik::kProgram,
                     "The 840D has the R parameters R0 to R999. No text says how many: a machine "
                     "data does; our judgement.",
                     "reference/sinumerik/interpreter.cpp"},
                    "syntax undefined-code"),
    refused_by_some({"SIE-G1-04", open, sinumerik::kLines,
                     "Under the reading sie.spindle = off a block that cuts without a turning "
                     "spindle runs on. No "
                     "text says that the control alarms; our judgement.",
                     "reference/sinumerik/basic_motion.cpp"},
                    "spindle-stopped"),
    named_otherwise({"SIE-ARC-14", open, sinumerik::kArcs,
                     "A centre word along the axis that stands upright on the arc is an alarm. No "
                     "text says so; our judgement.",
                     "reference/sinumerik/arc.cpp"},
                    "conflicting-words unused-word"),
    {"SIE-ARC-15", open, sinumerik::kArcs,
     "A corrected centre is worked out as finely as the end point. No text says how finely; our "
     "judgement.",
     "reference/sinumerik/basic_motion.cpp"},
    named_otherwise({"SIE-POL-03", open, sinumerik::kPolar,
                     "Beside G110, G111 and G112 nothing stands but the words of the pole. No text "
                     "says so; our judgement.",
                     "reference/sinumerik/alone.cpp"},
                    "syntax unused-word"),
    named_otherwise({"SIE-MOD-06", open, sinumerik::kModes,
                     "G4 without F and S, or with one below zero, is an alarm, and so are "
                     "revolutions of a spindle without a speed. No text says so; our judgement.",
                     "reference/sinumerik/basic_motion.cpp"},
                    "syntax value-out-of-range"),
    refused_by_some({"SIE-MOD-09", open, sinumerik::kModes,
                     "G4 S counts the turns of the speed in force though the spindle stands, and "
                     "the spindle turns behind SPOS, SPOSA, M6, M19 and M70 as it did before them. "
                     "No text says either; our judgement.",
                     "reference/sinumerik/basic_motion.cpp"},
                    "spindle-stopped"),
    named_otherwise({"SIE-COM-02", open, sinumerik::kModes,
                     "A word that has no meaning for the motion in force is an alarm. No text says "
                     "so; our judgement.",
                     "reference/sinumerik/basic_motion.cpp"},
                    "syntax undefined-code unused-word"),
    named_otherwise({"SIE-MOD-10", open, sinumerik::kModes,
                     "A word that moves nothing is an alarm beside G4, which has a block of its "
                     "own. No text says what comes of one; our judgement.",
                     "reference/sinumerik/alone.cpp"},
                    "syntax unused-word"),
    named_otherwise({"SIE-COM-03", open, sinumerik::kModes,
                     "A spindle speed below zero is an alarm. No text says so; our judgement.",
                     "reference/sinumerik/feed_and_speed.cpp"},
                    "value-out-of-range"),
    refused_by_some({"SIE-COM-04", open, sinumerik::kModes,
                     "H and M may stand more than once in a block; a second M function that ends "
                     "the program has "
                     "no effect. No text says so; our judgement.",
                     "reference/sinumerik/interpreter.cpp"},
                    "duplicate-word"),
    refused_by_some({"SIE-COM-05", open, sinumerik::kModes,
                     "T and D below zero, T, D and H with a fraction, and D above 9 are taken in. "
                     "No text says so; our judgement.",
                     "reference/sinumerik/feed_and_speed.cpp"},
                    "value-sign value-out-of-range not-an-integer"),
    refused_by_some({"SIE-COM-06", open, sinumerik::kModes,
                     "F 0 takes the feed away, which is an alarm where a block cuts, that of a "
                     "missing feed. No text says so; our judgement.",
                     "reference/sinumerik/feed_and_speed.cpp"},
                    "value-sign value-out-of-range feed-missing"),
});

inline constexpr auto kSinumerikCycles = std::to_array<Clause>({
    named_otherwise({"SIE-FRM-05", open, sinumerik::kFrames,
                     "While a rotation is in force another plane than its own is an alarm. No text "
                     "says so; our judgement.",
                     "reference/sinumerik/frame.cpp"},
                    "conflicting-words"),
    named_otherwise({"SIE-FRM-07", open, sinumerik::kFrames,
                     "A word that moves nothing is an alarm beside G158, G258 and G259, which have "
                     "a block of their own. No text says what comes of one; our judgement.",
                     "reference/sinumerik/alone.cpp"},
                    "syntax unused-word"),
    named_otherwise({"SIE-LC82-04", open, sinumerik::kDrilling,
                     "R105 or R102 below zero, and R101 between the reference plane and the "
                     "clearance above it, are alarms. No text says so; our judgement.",
                     "reference/sinumerik/cycle.cpp"},
                    "value-out-of-range"),
    named_otherwise({"SIE-LC82-05", open, sinumerik::kDrilling,
                     "The call of a cycle shares its block with no other word. No text says so, "
                     "the examples are written so; our judgement.",
                     "reference/sinumerik/alone.cpp"},
                    "syntax unused-word"),
    named_otherwise({"SIE-LC75-15", open, sinumerik::kPockets,
                     "An infeed R121 that is not above zero, R120, R124 or R125 below zero, and an "
                     "allowance R125 that leaves nothing to be roughed are alarms. No text says "
                     "so; our judgement.",
                     "reference/sinumerik/lcyc75_rules.cpp"},
                    "value-out-of-range"),
});

}  // namespace silent
}  // namespace gonogo::reference::catalog
