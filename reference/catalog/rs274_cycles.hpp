// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the documents of LinuxCNC say of the canned cycles of RS274/NGC; the interpreter of NIST has
// most of them.
#pragma once

#include <array>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference::catalog::rs274 {

inline constexpr std::string_view kCycles =
    "LinuxCNC 2.9, G codes: canned cycles, what all of them share";
inline constexpr std::string_view kDrilling = "LinuxCNC 2.9, G codes: G81 and G82, drilling";
inline constexpr std::string_view kPecking =
    "LinuxCNC 2.9, G codes: G83 and G73, drilling in pecks";
inline constexpr std::string_view kBoring = "LinuxCNC 2.9, G codes: G85, G86 and G89, boring";
inline constexpr std::string_view kTapping =
    "LinuxCNC 2.9, G codes: G84 and G74, tapping with a floating chuck";

inline constexpr auto kCycleClauses = std::to_array<Clause>({
    {"NGC-CYC-01", must, kCycles,
     "G73, G74 and G81 to G89 are modal, of the group of G0 to G3, G33, G76 and G80: a block with "
     "an axis word and no code of motion runs the cycle in force again. Feed, speed, M functions "
     "before motion, G4, plane, units, distance mode, G98 and G99 act before the cycle, wherever "
     "they stand; M0, M1, M2, M30 and M60 after it.",
     "reference/rs274/interpreter.cpp"},
    {"NGC-CYC-02", must, kCycles,
     "The first block of a cycle, where another motion or none was in force, needs R and the word "
     "of the third axis; G82, G86 and G89 need P, G73 and G83 need Q. An axis of the plane may be "
     "left out: under G90 it stays, under G91 it does not step.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-03", must, kCycles,
     "R, the word of the third axis, P and Q keep their numbers while the same cycle is in force, "
     "until they are written anew; L and D count for their block. Another code forgets them.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-04", must, kCycles,
     "A block that names a cycle has a word of a linear axis. Without a code of motion and an axis "
     "word no cycle runs: R, L, P or Q alone are words that nothing uses.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-05", must, kCycles,
     "Under G90 the words of the plane are the place of the hole, R and the word of the third axis "
     "the R level and the bottom, as coordinates.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-06", must, kCycles,
     "Under G91 the words of the plane are steps, R counts from where the tool is and the word of "
     "the third axis from R. Both levels hold for all holes of the block.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-07", must, kCycles,
     "An R below the bottom is an alarm, in every plane; R at the bottom is allowed and feeds "
     "nowhere.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-08", open, kCycles,
     "The initial level is where the tool was along the third axis before the series: cycles one "
     "behind the other, also different ones. Another code of motion, or G80, ends the series.",
     "reference/rs274/initial_level.cpp", Basis::text},
    {"NGC-CYC-09", open, kCycles,
     "The initial level is a place: it stays there when the units change, and a change of plane "
     "begins a new series.",
     "reference/rs274/initial_level.cpp"},
    {"NGC-CYC-10", must, kCycles,
     "The tool leaves a hole to R under G99, under G98 to the initial level where that is above R. "
     "Both are modal, count in their own block, and may change within a series.",
     "reference/rs274/approach.cpp"},
    {"NGC-CYC-11", must, kCycles,
     "First, once a block, a tool below R is lifted to R by a traverse, where it stands.",
     "reference/rs274/approach.cpp"},
    {"NGC-CYC-12", must, kCycles,
     "Then a traverse to the hole at the level where the tool is, and another one along the third "
     "axis to R.",
     "reference/rs274/approach.cpp"},
    {"NGC-CYC-13", must, kCycles,
     "Under G91 L makes so many holes, each one step further; the tool crosses from one to the "
     "next at the level to which it left the hole.",
     "reference/rs274/holes.cpp"},
    {"NGC-CYC-14", must, kCycles,
     "Under G90 L makes the same hole so many times; between two of them the tool goes to R.",
     "reference/rs274/holes.cpp"},
    {"NGC-CYC-15", must, kCycles, "L is a whole number above zero; left out it is 1.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-16", must, kCycles,
     "In G18 and G19 a cycle is as in G17, with the axes of that plane in their order. A plane of "
     "the same block counts; a number that is in force is that of the third axis in force.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-17", must, kCycles, "G17.1, G18.1 and G19.1 and the axes B U V W are not read.",
     "reference/rs274/interpreter.cpp"},
    {"NGC-CYC-18", must, kCycles,
     "A word of a rotary axis in a block that runs a cycle is an alarm. Where a rotary axis stands "
     "is free.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-19", must, kCycles,
     "Under G20 axis words, R, Q and D are inches, P is seconds. Numbers in force are read in the "
     "units of the block that uses them.",
     "reference/rs274/cycle_state.hpp"},
    {"NGC-CYC-20", derived, kCycles, "A cycle cuts: it needs a feed above zero.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-21", must, kCycles,
     "A cycle under G93 is an alarm, and so is one under G41 to G42.1, which the gauge does not "
     "read: "
     "the program ends before it.",
     "reference/rs274/modes.cpp"},
    {"NGC-CYC-22", must, kCycles,
     "P below zero and Q not above zero are alarms, also in a block that repeats a cycle.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-23", must, kCycles,
     "Beside the words of all motions a cycle has R and L; P has G74, G82, G84, G86 and G89, Q has "
     "G73 and G83. Any other one is a word that nothing uses.",
     "reference/rs274/unused_words.cpp"},
    {"NGC-CYC-24", must, kCycles,
     "Another code of motion cancels a cycle, also without G80. Behind G80 an axis word has no "
     "motion. The next cycle is a first one, and begins a series.",
     "reference/rs274/interpreter.cpp"},
    {"NGC-CYC-25", derived, kCycles,
     "Blocks without a code of motion neither cancel a cycle nor end a series.",
     "reference/rs274/interpreter.cpp"},
    {"NGC-CYC-26", derived, kCycles,
     "Behind the block the tool is at the last hole, at the level to which it left it: from there "
     "steps go on.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-27", derived, kCycles,
     "G4 in the block of a cycle dwells before all motion. One P serves both, where the cycle "
     "takes P; else it belongs to G4.",
     "reference/rs274/interpreter.cpp"},
    {"NGC-CYC-28", derived, kCycles,
     "Where a cycle stops or starts the spindle, M5, M3 or M4 is passed on, between the motions "
     "round it. M3, M4 and M5 of the same block come before.",
     "reference/rs274/holes.hpp"},
    {"NGC-CYC-29", open, kCycles,
     "A block that alarms moves nothing. LinuxCNC and NIST's interpreter find some faults "
     "only on the way to the first hole.",
     "reference/rs274/hole_block.cpp"},
    {"NGC-CYC-30", derived, kCycles,
     "Two codes of motion in a block, and G98 with G99, are alarms.", "reference/rs274/codes.cpp"},
    {"NGC-G81-01", must, kDrilling, "G81 feeds to the bottom and leaves the hole by a traverse.",
     "reference/rs274/g81.cpp"},
    {"NGC-G82-01", must, kDrilling,
     "G82 feeds to the bottom, dwells for P seconds, which may be 0, and leaves the hole by a "
     "traverse.",
     "reference/rs274/g82.cpp"},
    {"NGC-G83-01", must, kPecking,
     "Peck k of G83 ends at R - k Q while that is above the bottom, and the last one on the "
     "bottom: there are as few as reach it, one at least, and what remains is the last.",
     "reference/rs274/pecking.cpp"},
    {"NGC-G83-02", open, kPecking, "After each peck but the last a traverse to R, also under G98.",
     "reference/rs274/g83.cpp", Basis::text},
    {"NGC-G83-03", must, kPecking,
     "Then a traverse back into the hole, to the clearance above the last peck, and on by the "
     "feed.",
     "reference/rs274/g83.cpp"},
    {"NGC-G83-04", open, kPecking, "The clearance is 0.010 inch: 0.254 mm, in both units.",
     "reference/rs274/pecking.cpp", Basis::text},
    {"NGC-G83-05", derived, kPecking,
     "That level has no limit: where the peck is not as deep as the clearance it is above R.",
     "reference/rs274/g83.cpp"},
    {"NGC-G83-06", must, kPecking,
     "After the last peck the hole is left by a traverse to the level that G98 and G99 say, in "
     "one.",
     "reference/rs274/g83.cpp"},
    {"NGC-G83-07", must, kPecking,
     "Q is a length along the third axis, downwards, the same under G90 and G91.",
     "reference/rs274/pecking.cpp"},
    {"NGC-G83-08", open, kPecking,
     "LinuxCNC 2.10 has D for the clearance of the block, not below zero; 2.9 has no such word.",
     "reference/rs274/pecking.cpp"},
    {"NGC-G73-01", must, kPecking,
     "G73 makes the pecks of G83; after each but the last there is only a traverse up to the "
     "clearance above it.",
     "reference/rs274/g73.cpp"},
    {"NGC-G73-02", open, kPecking, "At the end a traverse to R; G98 is not spoken of.",
     "reference/rs274/g73.cpp", Basis::text},
    {"NGC-G73-03", must, kPecking, "Clearance, Q and D are those of G83; L is allowed.",
     "reference/rs274/g73.cpp"},
    {"NGC-G73-04", derived, kPecking, "The traverse between two pecks is not limited by R.",
     "reference/rs274/g73.cpp"},
    {"NGC-G85-01", open, kBoring,
     "G85 feeds to the bottom and out to R, and goes on by a traverse to the level that G98 and "
     "G99 say.",
     "reference/rs274/g85.cpp", Basis::text},
    {"NGC-G86-01", must, kBoring, "G86 needs a spindle that turns, at any speed.",
     "reference/rs274/g86.cpp"},
    {"NGC-G86-02", must, kBoring,
     "G86 feeds to the bottom, dwells for P seconds, stops the spindle, leaves the hole by a "
     "traverse and starts the spindle as it turned before.",
     "reference/rs274/g86.cpp"},
    {"NGC-G89-01", must, kBoring,
     "G89 feeds to the bottom, dwells for P seconds, and feeds out to the level that G98 and G99 "
     "say.",
     "reference/rs274/g89.cpp"},
    {"NGC-G84-01", must, kTapping,
     "G84, right-hand, needs a spindle that turns clockwise, G74, left-hand, one that turns "
     "counterclockwise.",
     "reference/rs274/tapping.cpp"},
    {"NGC-G84-02", must, kTapping,
     "Both feed to the bottom, stop the spindle, start it the other way, dwell for P seconds and "
     "feed out to the level that G98 and G99 say; at the feed in force, not in step with the "
     "spindle.",
     "reference/rs274/tapping.cpp"},
    {"NGC-G84-03", derived, kTapping, "Then the spindle stops, and turns as it did at first.",
     "reference/rs274/tapping.cpp"},
    {"NGC-G84-04", open, kTapping, "P is the dwell, and may be left out.",
     "reference/rs274/tapping.cpp"},
    {"NGC-G84-05", derived, kTapping,
     "In G18 and G19 both go along the third axis like all cycles.", "reference/rs274/tapping.cpp"},
    {"NGC-G74-01", open, kTapping,
     "The documents list L with the words of G74; LinuxCNC does not take it.",
     "reference/rs274/unused_words.cpp", Basis::text},
    {"NGC-G87-01", must, kCycles,
     "G87, back boring, is not read: the documents accept it and leave what it does undefined.",
     "reference/rs274/codes.cpp"},
    {"NGC-G88-01", must, kCycles,
     "G88, boring with the way out by hand, is not read: the documents leave it undefined.",
     "reference/rs274/codes.cpp"},
});

}  // namespace gonogo::reference::catalog::rs274
