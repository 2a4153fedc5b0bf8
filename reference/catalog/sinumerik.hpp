// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the SINUMERIK manuals say of path commands: the 840D, and as far as it has them the 802S.
#pragma once

#include <array>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference::catalog::sinumerik {

inline constexpr std::string_view kProgram = "SINUMERIK 840D, programming: structure of programs";
inline constexpr std::string_view kLines = "SINUMERIK 840D, programming: traverses and feeds";
inline constexpr std::string_view kArcs = "SINUMERIK 840D, programming: circles and helices";
inline constexpr std::string_view kPolar = "SINUMERIK 840D, programming: polar coordinates";
inline constexpr std::string_view kModes = "SINUMERIK 840D, programming: modal codes";

using enum ClauseLevel;
inline constexpr auto kPathClauses = std::to_array<Clause>({
    {"SIE-LEX-01", derived, kProgram,
     "Letters stand in either case; ';' begins a comment; '&' and characters that are not printed "
     "are blanks. An '=' is needed behind an address of several letters or with a number, and "
     "before an expression. Values are numbers, R parameters, + - * / with brackets, SIN COS TAN "
     "SQRT and ABS.",
     "grammar/x3/sinumerik.cpp"},
    {"SIE-PAR-01", derived, kProgram,
     "Assignments to R parameters act from left to right, each at once; one that was never "
     "assigned is 0.",
     "reference/sinumerik/expression.cpp"},
    {"SIE-G1-01", must, kLines,
     "G0 and G1 go to a Cartesian or polar target; all axes named arrive together. A rotary axis "
     "goes along: F holds for X Y Z.",
     "reference/sinumerik/basic_motion.cpp"},
    {"SIE-G1-02", must, kLines, "Cutting wants a spindle that turns; its alarm is ours.",
     "reference/sinumerik/basic_motion.cpp"},
    {"SIE-G1-03", derived, kLines,
     "Rotary axes follow G90, G91, AC and IC in degrees, under G0 too.",
     "reference/sinumerik/words.cpp"},
    {"SIE-ADDR-01", must, kLines,
     "G90 and G91 choose absolute and incremental end points; AC() and IC() override them word by "
     "word.",
     "reference/sinumerik/words.cpp"},
    {"SIE-ARC-01", must, kArcs,
     "G2 is clockwise and G3 counterclockwise in the plane in force, or in the one that the end "
     "point's axes choose.",
     "reference/sinumerik/arc.cpp"},
    {"SIE-ARC-02", must, kArcs,
     "I J K are the centre from the start, under G90 and G91 alike, or absolute with AC(); one "
     "may be left out where it is 0.",
     "reference/sinumerik/arc.cpp"},
    {"SIE-ARC-03", must, kArcs,
     "A centre without an end point, or with an end at the start, is a full circle.",
     "reference/sinumerik/arc.cpp"},
    {"SIE-ARC-04", must, kArcs,
     "CR= above zero is an arc of at most half a turn, below zero of more; no full circle, and no "
     "chord above twice the radius.",
     "reference/sinumerik/arc_forms.cpp"},
    {"SIE-ARC-05", must, kArcs,
     "AR= is the angle of the arc, from 0 to below 360 degrees, with its centre or its end point; "
     "whether 0 moves nothing or is an alarm is open.",
     "reference/sinumerik/arc_forms.cpp"},
    {"SIE-ARC-06", must, kArcs,
     "AP= RP= is an end point about the pole; the pole of an arc is its centre and RP its radius.",
     "reference/sinumerik/polar.cpp"},
    {"SIE-ARC-07", derived, kArcs,
     "The radii at start and end may differ by the larger of CIRCLE_ERROR_CONST and "
     "CIRCLE_ERROR_FACTOR times the radius at the start.",
     "reference/sinumerik/arc_correction.cpp"},
    {"SIE-ARC-08", derived, kArcs,
     "Within that limit the end point is exact and the centre is corrected, by no more than the "
     "root of 0.001 radians seen from the start.",
     "reference/sinumerik/arc_correction.cpp"},
    {"SIE-ARC-09", derived, kArcs,
     "A word of the third axis makes a helix; TURN= adds whole turns before it.",
     "reference/sinumerik/arc.cpp"},
    {"SIE-ARC-10", derived, kArcs,
     "Whether the end is the start is decided exactly: polar points of one pole and one RP whose "
     "angles differ by whole turns are one point for every angle.",
     "reference/sinumerik/polar.cpp"},
    {"SIE-ARC-11", derived, kArcs,
     "An arc has one form: a centre, CR=, AR= with a centre or an end point, or a polar end point.",
     "reference/sinumerik/arc.cpp"},
    {"SIE-ARC-12", derived, kArcs,
     "Two end-point axes that are not the plane's choose the plane, unless TURN=, AR= or a centre "
     "word of the plane's other axis makes a helix of it. Whether the centre word of the common "
     "axis alone, or CR= alone, makes one, too, is open.",
     "reference/sinumerik/arc.cpp"},
    {"SIE-ARC-13", derived, kArcs,
     "TURN= is whole, 0 to 999, and belongs to G2 and G3; beside CIP and CT it is 0 and adds "
     "nothing.",
     "reference/sinumerik/arc.cpp"},
    {"SIE-ARC-16", derived, kArcs,
     "With CR= the centre need not be given. Whether one that is given is an alarm, has no effect, "
     "or makes the arc is open.",
     "reference/sinumerik/arc.cpp"},
    {"SIE-CIP-01", derived, kArcs,
     "CIP is an arc in space through the point I1= J1= K1=, its sense the order of the points; "
     "G90, G91, AC and IC hold for it from the arc's start. A point between start and end on their "
     "line makes a straight line, or is an alarm; any other point on that line is an alarm.",
     "reference/sinumerik/cip.cpp"},
    {"SIE-CIP-02", derived, kArcs,
     "CIP needs an intermediate point other than its ends; its coordinates left out are the "
     "start's.",
     "reference/sinumerik/cip.cpp"},
    {"SIE-CT-01", derived, kArcs,
     "CT is an arc in the plane in force, tangent to the motion before it; an end straight ahead "
     "makes a straight line, one straight behind is an alarm.",
     "reference/sinumerik/ct.cpp"},
    {"SIE-CT-02", derived, kArcs,
     "The motion before is the last one of a length, a traverse counting as a straight line; its "
     "direction is projected into the plane. A word of the third axis makes a helix.",
     "reference/sinumerik/ct.cpp"},
    {"SIE-POL-01", derived, kPolar,
     "G110, G111 and G112 put the pole relative to the position, the zero, and the pole before; "
     "without one it is the zero.",
     "reference/sinumerik/polar.cpp"},
    {"SIE-POL-02", derived, kPolar,
     "AP and RP hold until the pole or the plane changes. RP is not below zero, AP within 360 "
     "degrees; AP is absolute, under G91 perhaps not, and IC() adds to it. The code of another "
     "plane puts the pole at the zero.",
     "reference/sinumerik/polar.cpp"},
    {"SIE-POL-04", derived, kPolar,
     "Whether the code of the plane in force puts the pole at the zero and ends AP and RP, too, is "
     "open.",
     "reference/sinumerik/polar.cpp"},
    {"SIE-MOD-01", must, kModes, "G0 G1 G2 G3 CIP and CT are one modal group.",
     "reference/sinumerik/codes.cpp"},
    {"SIE-MOD-02", derived, kModes,
     "The control comes up in G1 G17 G90 G71 G94 without a feed; its codes are those of the lists "
     "below.",
     "reference/sinumerik/codes.cpp"},
    {"SIE-MOD-03", derived, kModes,
     "G4 F dwells for seconds, G4 S for revolutions, alone in its block; F and S in force stay.",
     "reference/sinumerik/basic_motion.cpp"},
    {"SIE-MOD-04", derived, kModes,
     "G70 makes lengths inches of 25.4 mm: positions, centres, radii and offsets; not F, not R "
     "parameters.",
     "reference/sinumerik/words.cpp"},
    {"SIE-MOD-05", derived, kModes,
     "Two codes of one group in a block are an alarm; a block with a slash runs unless blocks are "
     "skipped.",
     "reference/sinumerik/codes.cpp"},
    {"SIE-MOD-07", derived, kModes,
     "G96 and G97 give feeds per revolution as G95 does, G961 and G971 per minute as G94. After "
     "G96 "
     "and G961 S is a cutting speed; how fast the spindle turns is not known until an S counts "
     "revolutions again, and G4 S is not covered. The 802S has only G96 and G97.",
     "reference/sinumerik/feed_and_speed.cpp"},
    {"SIE-MOD-08", derived, kModes,
     "Whether F stays in force where the feed changes between minutes and revolutions is open.",
     "reference/sinumerik/basic_motion.cpp"},
    {"SIE-COM-01", derived, kModes,
     "Cutting needs a feed. An address twice, a code that the control lacks, and Cartesian with "
     "polar words are alarms.",
     "reference/sinumerik/interpreter.cpp"},
    {"SIE-WRD-01", derived, kModes,
     "Every word of a block is used, has no meaning for the motion in force (an alarm), or is "
     "ignored by a rule of the list below. Names of own subprograms and variables, and addresses "
     "that "
     "only the machine gives a meaning, are not covered: no alarm of the machine.",
     "reference/sinumerik/descriptor.hpp", std::nullopt,
     "What a name of the machine's owner does stands in no manual."},
});

}  // namespace gonogo::reference::catalog::sinumerik
