// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the RS274/NGC interpreter of NIST, version 3, says of path commands, with the few words that
// LinuxCNC adds.
#pragma once

#include <array>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference::catalog::rs274 {

inline constexpr std::string_view kLines = "RS274/NGC interpreter, version 3: traverses and feeds";
inline constexpr std::string_view kModes = "RS274/NGC interpreter, version 3: modes and order";
inline constexpr std::string_view kArcs = "RS274/NGC interpreter, version 3: arcs";
inline constexpr std::string_view kBlocks = "RS274/NGC interpreter, version 3: lines of a program";
inline constexpr std::string_view kOverview =
    "LinuxCNC 2.9, G-code overview: format of a line, the end of a program";
inline constexpr std::string_view kGroups = "LinuxCNC 2.9, G-code overview: modal groups";

using enum ClauseLevel;
inline constexpr auto kClauses = std::to_array<Clause>({
    {"NGC-G0-01", must, kLines,
     "G0 is a traverse to the point; G1 a feed to it, which needs a feed above zero.",
     "reference/rs274/basic_motion.cpp"},
    {"NGC-MOD-01", must, kModes,
     "G0 to G3, G33, G33.1, G73, G74, G76 and G80 to G89 are modal and of one group: a block with "
     "axis words alone repeats the motion. The words of a block act in a fixed order, whatever "
     "their order on the line.",
     "reference/rs274/interpreter.cpp"},
    {"NGC-DIS-01", must, kModes,
     "G90 and G91 choose absolute and incremental axis words; G90.1 and G91.1 the same for I J K.",
     "reference/rs274/interpreter.cpp"},
    {"NGC-UNI-01", must, kModes, "G20 is inches of exactly 25.4 mm, G21 millimetres.",
     "reference/rs274/words.cpp"},
    {"NGC-ARC-01", must, kArcs,
     "G2 is clockwise and G3 counterclockwise in the plane of X and Y, Z and X, or Y and Z, seen "
     "from the positive end of the third axis.",
     "reference/rs274/arc.cpp"},
    {"NGC-ARC-02", must, kArcs,
     "Centre form: I J K are offsets along the axes of the plane; one at least is needed, and one "
     "of the third axis is an alarm. An end at the start is a full circle.",
     "reference/rs274/arc.cpp"},
    {"NGC-ARC-03", must, kArcs,
     "The radii at start and end may differ by the tolerance; within it the centre stays where it "
     "is programmed, and the radius is linear in the angle.",
     "reference/rs274/arc.cpp"},
    {"NGC-ARC-04", must, kArcs,
     "Radius form: R above zero is an arc of at most half a turn, below zero of more. The end "
     "cannot be the start, nor the chord longer than twice the radius.",
     "reference/rs274/arc.cpp"},
    {"NGC-ARC-05", must, kArcs,
     "With a word of the third axis an arc is a helix; P, a positive whole number, is how many "
     "turns it begins.",
     "reference/rs274/arc.cpp"},
    {"NGC-G4-01", must, kLines, "G4 dwells for P seconds.", "reference/rs274/basic_motion.cpp"},
    {"NGC-G4-02", open, kModes,
     "A dwell comes before the motion of its block. LinuxCNC has dwelt when it finds what is wrong "
     "with the motion; a word that is read wrong alarms before.",
     "reference/rs274/interpreter.cpp", Basis::text},
    {"NGC-COM-01", derived, kBlocks,
     "A line with a slash runs unless blocks are skipped. A word or a modal group twice in a "
     "block, more than four M functions, a code that the language lacks, and R with I J K are "
     "alarms. G40 G61 G64 S, and M6 and T without G43, are passed over. M functions, G codes times "
     "ten and P of an arc are whole numbers. M70 and M71 save modes and forget them; M72 and M73, "
     "which restore them, the gauge does not read.",
     "reference/rs274/interpreter.cpp"},
    {"NGC-COM-02", must, kGroups,
     "A word that no code of the block uses is an alarm, also in a block without a motion: I J K "
     "belong to an arc, K to G33, I and K to G33.1, all to G76; R to an arc, a canned cycle, G76 "
     "and "
     "G10; L to these cycles, G76, G10 and M66; P to G4, G10, an arc, G64, a cycle that has it, "
     "G76, "
     "M50 to M53 and M62 to M66; Q to G64, G73, G83, G76, M61 and M66 to M68; H to G43 and G76, E "
     "to "
     "G76 and M66 to M68; D to no code that the gauge reads.",
     "reference/rs274/unused_words.cpp"},
    {"NGC-COM-03", open, kGroups,
     "Two codes of a modal group in a block are an alarm. LinuxCNC forgets G80 beside another code "
     "of the motion group, wherever it stands: the other one acts and stays in force.",
     "reference/rs274/codes.cpp", Basis::text},
    {"NGC-COM-04", must, kOverview,
     "Blanks and tabs mean nothing outside comments, also inside a number and after its sign.",
     "grammar/x3/squeezed.hpp"},
    {"NGC-COM-05", must, kOverview,
     "A line number stands first, is whole, or two whole numbers with a point between, and has no "
     "meaning.",
     "reference/rs274/program_text.cpp"},
    {"NGC-COM-06", open, kOverview,
     "A line that is O, a number and perhaps comments behind them names the program; with other "
     "other words it is not read, and with a control word it is an O word.",
     "reference/rs274/program_text.cpp"},
    {"NGC-COM-07", must, kOverview,
     "A % line opens the program where no line but blank ones stands before it; then a second % "
     "line ends the program, and nothing after it is read. A % anywhere else is an alarm.",
     "reference/rs274/program_text.cpp"},
    {"NGC-COM-08", must, kOverview,
     "A program ends with M2 or M30, or with the second of two % lines. Where the text ends "
     "before, "
     "its last line alarms, after all motion.",
     "reference/rs274/program_text.cpp"},
    {"NGC-COM-09", must, kBlocks,
     "The speed S is not below zero; the tool T is a whole number that is not below zero either.",
     "reference/rs274/m_functions.cpp"},
    {"NGC-COM-10", must, kOverview,
     "The last comment in brackets of a line may say something: (abort,...) ends the program with "
     "an "
     "error, before anything else of its line.",
     "reference/rs274/program_text.cpp"},
    {"NGC-COM-11", open, kBlocks,
     "T selects a tool. LinuxCNC looks for it in its table and alarms where it is not there; "
     "NIST's "
     "interpreter does not look.",
     "reference/rs274/m_functions.cpp", Basis::text},
    {"NGC-COM-12", open, kBlocks,
     "Where blocks are skipped, a line with a slash before everything else does not run. Whether "
     "it "
     "is read, and alarms where it cannot be, no text says.",
     "reference/rs274/interpreter.cpp", Basis::text},
    {"NGC-COM-13", open, kBlocks,
     "A line ends with a line feed, behind a carriage return or alone. A carriage return without a "
     "line feed ends one, too, or is a blank and counts no line.",
     "reference/rs274/interpreter.cpp", Basis::text},
    {"NGC-MOD-03", open, kModes,
     "G94 is units per minute. What it leaves of the feed in force no text says: LinuxCNC has none "
     "until F is given, in this block or later; NIST's interpreter keeps it.",
     "reference/rs274/interpreter.cpp", Basis::text},
    {"NGC-MOD-02", open, kLines,
     "G0 and G1 without an axis word: an alarm to NIST's interpreter; to LinuxCNC no motion, and "
     "an "
     "alarm only for a G1 without a feed.",
     "reference/rs274/basic_motion.cpp", Basis::text},
    {"NGC-ARC-06", open, kArcs,
     "I J K alone, while G2 or G3 is in force, are an arc to LinuxCNC and words that nothing uses "
     "to "
     "NIST's interpreter.",
     "reference/rs274/interpreter.cpp"},
});

}  // namespace gonogo::reference::catalog::rs274
