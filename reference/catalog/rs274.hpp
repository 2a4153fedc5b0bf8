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
inline constexpr std::string_view kPolar = "LinuxCNC 2.9, G-code overview: polar coordinates";
inline constexpr std::string_view kGroups = "LinuxCNC 2.9, G-code overview: modal groups";

inline constexpr std::string_view kLaterModes =
    "LinuxCNC 2.9, G codes: modes of feed, spindle and lathe";
inline constexpr std::string_view kSaving = "LinuxCNC 2.9, M codes: modal state saved and restored";

using enum ClauseLevel;
inline constexpr auto kClauses = std::to_array<Clause>({
    {"NGC-G0-01", must, kLines,
     "G0 is a traverse to the point; G1 a feed to it, which needs a feed above zero.",
     "reference/rs274/basic_motion.cpp"},
    {"NGC-MOD-01", must, kModes,
     "G0 to G3, G33, G33.1, G73, G74, G76 and G80 to G89 are modal and of one group: a block with "
     "axis words alone repeats the motion. The words of a block act in a fixed order, not in "
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
     "is programmed, and the radius is linear in the angle. A radius of zero, for LinuxCNC one "
     "below 0.00127 mm, is an alarm of its own.",
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
    refused_by_some({"NGC-G4-03", open, kModes,
                     "A dwell beside the code of an arc comes before it, and P is its time. No "
                     "text says whether both may stand in a block, for both have a use for P; our "
                     "judgement.",
                     "reference/rs274/basic_motion.cpp", Basis::silent},
                    "conflicting-words"),
    {"NGC-COM-01", derived, kBlocks,
     "A line with a slash runs unless blocks are skipped. A word or a modal group twice in a "
     "block, more than four M functions, a code that the language lacks, and R with I J K are "
     "alarms. G40 G61 G64 S, and M6 and T without G43, are ignored. M functions, G codes times "
     "ten and P of an arc are whole numbers.",
     "reference/rs274/interpreter.cpp"},
    {"NGC-COM-02", must, kGroups,
     "A word that no code of the block uses is an alarm, also in a block without a motion: I J K "
     "belong to an arc, K to G33, I and K to G33.1, all to G76, I and J to G10; R to an arc, a "
     "canned "
     "cycle, G76 and G10; L to these cycles, G76, G10, M66 and M98; P to G4, G10, an arc, G64, a "
     "cycle that has it, G76, M50 to M53, M62 to M66 and M98; Q to G10, G64, G73, G83, G76, M61 "
     "and "
     "M66 to M68; H to G43, G43.2 and G76, E to G76 and M66 to M68; D to G96.",
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
     "The speed S is not below zero; the tool T is a whole number that is not below zero either, "
     "nor Q of M61. M62 to M65 need P, M67 and M68 E; M66 needs P or E, and with L, which goes "
     "with P alone, a time Q above zero.",
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
    refused_by_some(
        {"NGC-COM-14", open, kBlocks,
         "M6 changes to the tool of the last T, and runs where there was none. No text says "
         "whether it may; our judgement.",
         "reference/rs274/interpreter.cpp", Basis::silent},
        "no-tool missing-word"),
    refused_by_some(
        {"NGC-COM-15", open, kBlocks,
         "A switch of M50 to M53 that is neither 0 nor 1, a pin of M62 to M68 that is not one of 0 "
         "to 3, L of M66 above 4, and M67 and M68 without Q do what the machine has there. No text "
         "says which pins a machine has; our judgement.",
         "reference/rs274/m_functions.cpp", Basis::silent},
        "value-out-of-range value-sign not-an-integer missing-word"),
    {"NGC-COM-16", open, kBlocks,
     "A line has 256 characters at most, its comments included, and what the documents do not allow "
     "is an alarm. They call the number a current one: a control may read more.",
     "reference/rs274/interpreter.cpp", Basis::text},
    {"NGC-MOD-03", open, kModes,
     "G94 is units per minute. What it leaves of the feed in force no text says: LinuxCNC has none "
     "until F is given, in this block or later; NIST's interpreter keeps it.",
     "reference/rs274/interpreter.cpp", Basis::text},
    {"NGC-POL-01", must, kPolar,
     "@ is the distance of the end of a motion from the program's origin in X and Y, ^ its angle "
     "from +X toward +Y. Under G91 they add to the distance and angle of the place where the tool "
     "stands, with L of a cycle once more for each hole.",
     "reference/rs274/polar_words.cpp"},
    {"NGC-POL-02", derived, kPolar,
     "Under G90 the distance or the angle that is left out is that of the place where the tool "
     "stands.",
     "reference/rs274/polar_words.cpp"},
    {"NGC-POL-03", must, kPolar,
     "X or Y beside a polar word is an alarm, and so is an increment that begins at the origin, "
     "which has no angle.",
     "reference/rs274/polar_words.cpp"},
    {"NGC-POL-04", must, kPolar,
     "Polar words of other codes, beside G53, under G7, outside G17 or in the block that enters "
     "it, a polar word that stands twice, a distance alone from the origin under G90, and a row of "
     "holes through the origin are not read.",
     "reference/rs274/polar_words.cpp"},
    {"NGC-FED-01", must, kLaterModes,
     "G93 is inverse time: a block takes 1/F minutes, so that the feed is F times its way: that of "
     "the linear axes, along the curve where it is an arc, or that of the rotary axes where they "
     "move alone. G1, G2 and G3 need an F in their block; F of other blocks means nothing, and G0 "
     "runs as ever.",
     "reference/rs274/modes.cpp"},
    {"NGC-FED-02", must, kLaterModes,
     "G95 is feed per revolution of the spindle. Once G93, G94 or G95 has changed the mode, a feed "
     "that was in force is none, until F is given in this block or later.",
     "reference/rs274/interpreter.cpp"},
    refused_by_some(
        {"NGC-FED-03", open, kLaterModes,
         "A feed per revolution of a spindle that stands, or has no speed, is put out as "
         "it is; in inverse time an arc whose radii differ is not read, for they differ in its "
         "length. No text says what happens; our judgement.",
         "reference/rs274/modes.cpp", Basis::silent},
        "spindle-stopped"),
    {"NGC-SPD-01", must, kLaterModes,
     "G96 is constant surface speed and needs S; D is the highest speed. G97 is revolutions.",
     "reference/rs274/modes.cpp"},
    {"NGC-SPD-02", must, kLaterModes, "A feed under G96 while the spindle stands is an alarm.",
     "reference/rs274/modes.cpp"},
    {"NGC-SPD-03", must, kModes,
     "After the tool change of M6 the spindle stands until M3 or M4; these come behind M6 where "
     "they are in its block. M61 changes no tool.",
     "reference/rs274/interpreter.cpp"},
    {"NGC-DIA-01", must, kLaterModes,
     "Under G7 X is a diameter, and X moves by half; I, J and K of G76 are diameters, too. G8 ends "
     "it.",
     "reference/rs274/words.cpp"},
    {"NGC-DIA-02", open, kLaterModes,
     "No text says what X is in the block in which G7 or G8 changes the mode, nor X of offsets "
     "under "
     "G7, I under G7 and G90.1, and levels of cycles along X under G7. They are not read; our "
     "judgement.",
     "reference/rs274/modes.cpp"},
    {"NGC-SAV-01", must, kSaving,
     "M70 saves the modes of its subroutine or the program, M72 puts them in force again, M71 "
     "forgets "
     "them, M73 saves them and restores them where the subroutine ends. They are units, plane, the "
     "modes of distances, centres, diameters, feed and speed, the coordinate system, F, and the "
     "return of cycles, not the motion. F is restored as the number that was written, in the units that "
     "are restored. M72 without M70 is an alarm. Where a spindle, coolant, an override or a tool "
     "length would have to be restored, the gauge does not read on.",
     "reference/rs274/modes.cpp"},
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
