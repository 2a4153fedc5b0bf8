// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the HNC-21T manual says of G74, G75 and G80 to G82, and of the codes that programs with
// these cycles use. A is where a cycle starts, C the programmed end point, B where the cut begins.
#pragma once

#include <array>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference::catalog::hnc21t {

inline constexpr std::string_view kG80 = "HNC lathe cycles, (1) G80 inner and outer diameter";
inline constexpr std::string_view kG81 = "HNC lathe cycles, (2) G81 face";
inline constexpr std::string_view kG82 = "HNC lathe cycles, (3) G82 thread";
inline constexpr std::string_view kG74 = "HNC lathe cycles, (4) G74 deep drilling of the face";
inline constexpr std::string_view kG75 = "HNC lathe cycles, (5) G75 grooving of the diameter";
inline constexpr std::string_view kSimple = "HNC lathe cycles, simple cycles, introduction";
inline constexpr std::string_view kBasic = "HNC-21T programming, basic codes and block format";

using enum ClauseLevel;
inline constexpr auto kClauses = std::to_array<Clause>({
    {"HNC-G80-01", derived, kG80,
     "Traverse from A to B along X alone, B lying I beyond C on X and level with A on Z; feed to "
     "C; "
     "feed to D, back at X of A and level with C on Z; traverse back to A.",
     "reference/hnc21t/g80.cpp"},
    {"HNC-G80-02", derived, kG80,
     "I is the radius of B less the radius of C, signed, the same in absolute and incremental "
     "programs; nothing limits it.",
     "reference/hnc21t/g80.cpp"},
    {"HNC-G81-01", derived, kG81,
     "Traverse from A to B along Z alone, B lying K beyond C on Z and level with A on X; feed to "
     "C; "
     "feed to D, back at Z of A and level with C on X; traverse back to A.",
     "reference/hnc21t/g81.cpp"},
    {"HNC-G81-02", must, kG81, "K is the Z of B less the Z of C, signed.",
     "reference/hnc21t/g81.cpp"},
    {"HNC-G82-01", derived, kG82,
     "Traverse from A to B as G80 with I; thread from B to C with the lead F or J; the run-out, if "
     "there is one; traverse along X to the X of A, then along Z to A.",
     "reference/hnc21t/g82.cpp"},
    {"HNC-G82-02", derived, kG82,
     "R along Z and E along X, a radius value, are signed amounts beyond C: the thread goes on to "
     "the point that lies E and R from C.",
     "reference/hnc21t/g82.cpp"},
    {"HNC-G82-03", must, kG82, "R and E are given both or neither.", "reference/hnc21t/g82.cpp"},
    {"HNC-G82-04", must, kG82,
     "The run-out along the short axis is at most 20 times that along the long axis, the axis of "
     "the longer thread travel.",
     "reference/hnc21t/g82.cpp"},
    {"HNC-G82-05", must, kG82, "Q is not negative, has no effect on the geometry, and is modal.",
     "reference/hnc21t/g82.cpp"},
    {"HNC-G82-06", derived, kG82,
     "C is the number of starts: omitted, 0 or 1 is one, at spindle angle P; n above 1 are n whole "
     "passes, pass k at k times P, and P is needed.",
     "reference/hnc21t/g82.cpp"},
    {"HNC-G82-07", derived, kG82,
     "A thread needs F or J in force, and not both. F is the lead; J is the lead of an inch "
     "thread, "
     "in inches or as threads to the inch.",
     "reference/hnc21t/g82.cpp"},
    named_otherwise(
        refused_by_some({"HNC-G82-08", open, kG82,
                         "A lead is above zero, and a later one replaces the one in force. No "
                         "text says so; our judgement.",
                         "reference/hnc21t/interpreter.cpp"},
                        "conflicting-words"),
        "value-out-of-range lead-missing"),
    {"HNC-G82-09", open, kG82,
     "Start angles count modulo 360 degrees; the run-out keeps the lead and the start of its "
     "thread; the passes come in the order of k, or of falling k. The signs of R and E are free. "
     "No text says so; our judgement.",
     "reference/hnc21t/g82.cpp"},
    {"HNC-G82-10", derived, kG82,
     "Feed hold, the meaning of Q and the versions that have it change nothing in the path. "
     "Whether the control is of a version that has Q is open.",
     "reference/hnc21t/g82.cpp"},
    {"HNC-G74-01", must, kG74,
     "Z is the bottom of the hole. The withdrawal e (word R) is not negative and the depth of a "
     "peck (word Q) is above zero.",
     "reference/hnc21t/g74.cpp"},
    {"HNC-G74-02", derived, kG74,
     "Pecks end at multiples of their depth from A, each but the last followed by a withdrawal of "
     "e; the last ends on Z; then one traverse to A.",
     "reference/hnc21t/g74.cpp"},
    {"HNC-G74-03", derived, kG74,
     "Without a withdrawal: feed to Z, traverse to A. Whether a depth of a peck beside it asks for "
     "the third way of drilling, which the text announces and has lost, is open.",
     "reference/hnc21t/g74.cpp"},
    {"HNC-G74-04", open, kG74,
     "Nothing limits the withdrawal. X and U in a block of G74 have no effect, or the tool is "
     "positioned there first. No text says more; our judgement.",
     "reference/hnc21t/g74.cpp"},
    {"HNC-G74-05", derived, kG74,
     "A withdrawal needs a depth of a peck; where the tool goes down in one that depth has no "
     "effect.",
     "reference/hnc21t/pecking.cpp"},
    {"HNC-G75-01", must, kG75,
     "X is the bottom of the groove; e and the depth of a peck as in G74, measured as radii along "
     "X.",
     "reference/hnc21t/g75.cpp"},
    {"HNC-G75-02", derived, kG75,
     "Pecks and withdrawals as in G74, along X; then straight out to X of A.",
     "reference/hnc21t/g75.cpp"},
    {"HNC-G75-03", derived, kG75,
     "Without a withdrawal: one plunge to X, traverse out. Whether a width and a depth of a peck "
     "ask for the third way, a traverse to X and that depth further, is open.",
     "reference/hnc21t/g75.cpp"},
    {"HNC-G75-04", open, kG75,
     "With a width (Z or W) and a number of axial steps (I) the plunge is repeated at each step, "
     "with traverses along Z at X of A between; then traverse to A. The number is a positive whole "
     "one.",
     "reference/hnc21t/g75.cpp"},
    {"HNC-G75-05", open, kG75,
     "A number of steps from an earlier block counts only in a block with Z or W. A width of zero "
     "plunges at one place again and again, or once. No text says so; our judgement.",
     "reference/hnc21t/g75.cpp"},
    {"HNC-MOD-01", must, kSimple,
     "G74, G75, G80, G81 and G82 are one modal group. I K R E C A P F J Q given in one of them are "
     "modal within it and forgotten when the command changes to another of them.",
     "reference/hnc21t/interpreter.cpp"},
    {"HNC-MOD-02", derived, kSimple,
     "A following block with X and Z alone repeats the cycle from A; another motion code cancels "
     "it.",
     "reference/hnc21t/interpreter.cpp"},
    {"HNC-MOD-03", open, kSimple,
     "What a block of a cycle does that has only one of X and Z is open; G74 needs Z alone, G75 "
     "without a width X alone.",
     "reference/hnc21t/cycle.cpp"},
    {"HNC-MOD-04", open, kSimple,
     "F of G74, G75, G80 and G81 is the ordinary feed. A lead becomes no feed, nor a feed a lead, "
     "and G32 needs a lead of its own; whether one from before another motion code is in force, or "
     "F is one word for feeds and leads, is open.",
     "reference/hnc21t/interpreter.cpp"},
    named_otherwise(
        refused_by_some({"HNC-MOD-05", open, kSimple,
                         "The same code again, at once or behind motion codes that are not of the "
                         "group, is no change of command, or it is one. A code or a word of a "
                         "cycle without an axis word is stored and moves nothing, or the cycle "
                         "runs again. Other units leave retained lengths, or their numbers. Y and "
                         "V are not words of a lathe. G18 is the only plane; G40, G96 and G97 have "
                         "no effect. No text says so; our judgement.",
                         "reference/hnc21t/interpreter.cpp"},
                        "missing-word"),
        "undefined-code axis-not-in-plane unused-word syntax"),
    {"HNC-COM-01", derived, kBasic,
     "A missing required word, a code that the maker lacks, unreadable text and a cut without a "
     "feed are alarms. A blank may stand between a letter and its number. Basic codes: G00 to G04, "
     "G20, G21, G32, G36, G37, G54 to G59, G90 to G92, G94 and G95. Whether P of G04 is in "
     "milliseconds or in seconds is open.",
     "reference/hnc21t/interpreter.cpp"},
    {"HNC-WRD-01", derived, kBasic,
     "Every word of a block is used by its code, or ignored by a rule of the list below, or it "
     "ends the program as not covered: a control may chamfer or round by it (C, R, RL= and RC= of "
     "G01).",
     "reference/hnc21t/word_use.cpp", std::nullopt,
     "A word that changes a path on some control, ignored, is a wrong path."},
});

}  // namespace gonogo::reference::catalog::hnc21t
