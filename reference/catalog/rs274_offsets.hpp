// SPDX-License-Identifier: GPL-3.0-or-later
//
// What LinuxCNC's documents say of the offsets between the coordinates of a program and those of
// the machine.
#pragma once

#include <array>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference::catalog::rs274 {

inline constexpr std::string_view kOffsets =
    "LinuxCNC 2.9, coordinate systems, and G codes: offsets and machine coordinates";

inline constexpr auto kOffsetClauses = std::to_array<Clause>({
    {"NGC-OFS-01", derived, kOffsets,
     "Coordinates of a program, and of G90.1, count from the coordinate system in force, the "
     "offset "
     "of G92 and the tool length, one upon the other. Records are in coordinates of the machine: "
     "an "
     "offset has no record and moves those that follow; increments are as they are.",
     "reference/rs274/offsets.cpp"},
    {"NGC-OFS-02", must, kOffsets,
     "G54 to G59 and G59.1 to G59.3 put one of nine coordinate systems in force, from their own "
     "block on; G54 is in force at first. The profile says where they lie.",
     "reference/rs274/offsets.cpp"},
    {"NGC-OFS-03", must, kOffsets,
     "G10 L2 P puts the origin of coordinate system P, 1 to 9 or 0 for the one in force, where the "
     "axis words say, in coordinates of the machine, also under G91; an axis without a word keeps "
     "its own. It acts at once, and selects no system. A P that is no whole number from 0 to 9 is "
     "an alarm. I, J and Q beside L2, and these and R beside L20, are words that nothing uses.",
     "reference/rs274/offsets.cpp"},
    {"NGC-OFS-04", must, kOffsets,
     "G10 L20 P puts the origin of system P where the position gets the coordinates that the axis "
     "words say; along an axis without a word it keeps those that it has there.",
     "reference/rs274/offsets.cpp"},
    {"NGC-OFS-05", must, kOffsets,
     "G92 moves all coordinate systems so that the position gets the coordinates that its axis "
     "words say; nothing moves. It needs one of them, and G91 does not matter.",
     "reference/rs274/offsets.cpp"},
    {"NGC-OFS-06", must, kOffsets,
     "G92.1 ends the offset of G92 and forgets it; G92.2 ends it and keeps it; G92.3 puts the one "
     "that was kept in force.",
     "reference/rs274/offsets.cpp"},
    {"NGC-OFS-07", open, kOffsets,
     "The offset of an axis that G92 does not name: zero, as the page of G92 says; or as it was, "
     "as "
     "NIST's report and LinuxCNC have it.",
     "reference/rs274/offsets.cpp"},
    {"NGC-OFS-08", must, kOffsets,
     "G43 H moves the axes by the length of tool H in what follows, G43 alone by that of the tool "
     "that M6 or M61 has loaded; nothing moves. H is whole and not below zero. The length is the "
     "profile's and along Z; what H0, or no tool in the spindle, means is the tool changer's.",
     "reference/rs274/tool_lengths.cpp"},
    {"NGC-OFS-09", must, kOffsets,
     "G43.1 puts the offset along each axis that has a word in place of the one of the tool; "
     "nothing "
     "moves, and a motion in its block is an alarm.",
     "reference/rs274/tool_lengths.cpp"},
    {"NGC-OFS-10", must, kOffsets, "G49 ends the tool length.", "reference/rs274/tool_lengths.cpp"},
    {"NGC-OFS-11", must, kOffsets,
     "G28 and G30 traverse to a point of the machine that the profile says (reference_point for "
     "G28, the parameters 5181 to 5186 for G30; its origin where it says nothing): without axis "
     "words with all axes, else first to the point that they say and then with these axes alone.",
     "reference/rs274/offsets.cpp"},
    {"NGC-OFS-12", must, kOffsets, "G28.1 and G30.1 make the position that point.",
     "reference/rs274/offsets.cpp"},
    {"NGC-OFS-13", must, kOffsets,
     "Axis words beside G53 are coordinates of the machine, without any offset. It needs G0 or G1 "
     "in "
     "force and holds for its block.",
     "reference/rs274/offsets.cpp"},
    {"NGC-OFS-14", open, kOffsets,
     "G53 under G91 is an alarm. No text says so, NIST's interpreter and LinuxCNC have it; our "
     "judgement.",
     "reference/rs274/offsets.cpp"},
    refused_by_some(
        {"NGC-OFS-20", open, kOffsets,
         "G53 without axis words, and without G0 or G1 in its block, does nothing. No text says "
         "whether it may stand so; our judgement.",
         "reference/rs274/offsets.cpp", Basis::silent},
        "conflicting-words missing-word"),
    {"NGC-OFS-21", open, kOffsets,
     "P0 of G10 L2 is the coordinate system in force, as LinuxCNC has it; to NIST's interpreter P "
     "is from 1 to 9, and another one an alarm.",
     "reference/rs274/offsets.cpp", Basis::text},
    {"NGC-OFS-22", open, kOffsets,
     "Behind the point that axis words of G28 and G30 say, these axes alone go on to the reference "
     "point, as LinuxCNC has it; or all axes do, as NIST's report has it.",
     "reference/rs274/offsets.cpp", Basis::text},
    {"NGC-OFS-23", open, kOffsets,
     "G43 without H takes the tool that is loaded, as LinuxCNC has it; to NIST's interpreter it is "
     "an alarm.",
     "reference/rs274/tool_lengths.cpp", Basis::text},
    {"NGC-OFS-15", must, kGroups,
     "G10, G28, G30, G52 and G92 take the axis words of their block: the motion in force does not "
     "act there, and another code that takes them is an alarm.",
     "reference/rs274/offsets.cpp"},
    {"NGC-OFS-16", must, kOffsets,
     "G10 L2 P R turns system P by R degrees, counterclockwise as seen from above Z, about its own "
     "origin; until R is given anew. The offset of G92 is along the turned axes, those of the "
     "system "
     "and of the tool are along the machine's. Threads, and arcs in G18 and G19, are not read "
     "there.",
     "reference/rs274/frame.cpp"},
    {"NGC-OFS-17", must, kOffsets,
     "G10 L1 P puts what tool P moves the axes by into the tool table; L10 puts there what gives "
     "the position the coordinates of the axis words once G43 takes it, L11 the same in G59.3 "
     "without an offset of G92. An axis without a word keeps its own; what is in force stays until "
     "G43. R I J and Q do not shape the path. P is the number of a tool of the table, else an "
     "alarm.",
     "reference/rs274/tool_lengths.cpp"},
    {"NGC-OFS-18", must, kOffsets,
     "G52 puts the origin of the program where the axis words say in the coordinate system in "
     "force, in place of the offset of G92; an axis without a word keeps its own. Nothing moves.",
     "reference/rs274/offsets.cpp"},
    {"NGC-OFS-19", must, kOffsets,
     "G43.2 adds the length of tool H, or what the axis words say, to the tool length in force; "
     "nothing moves. Without both, or with both, it is an alarm.",
     "reference/rs274/tool_lengths.cpp"},
});

}  // namespace gonogo::reference::catalog::rs274
