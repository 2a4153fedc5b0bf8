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

using enum ClauseLevel;
inline constexpr auto kClauses = std::to_array<Clause>({
    {"NGC-G0-01", must, kLines,
     "G0 is a traverse to the point; G1 a feed to it, which needs a feed above zero.",
     "reference/rs274/basic_motion.cpp"},
    {"NGC-MOD-01", must, kModes,
     "G0 G1 G2 G3 and G80 are modal: a block with axis words alone repeats the motion. The words "
     "of a block act in a fixed order, whatever their order on the line.",
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
    {"NGC-COM-01", derived, kBlocks,
     "A line with a slash runs unless blocks are skipped. An axis word or a modal group twice in a "
     "block, a code that the language lacks, and R with I J K are alarms. G40 G49 G54 G61 G64 G80 "
     "M6 S and T are passed over. M functions, G codes times ten and P of an arc are whole "
     "numbers.",
     "reference/rs274/interpreter.cpp"},
});

}  // namespace gonogo::reference::catalog::rs274
