// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the GSK 988TA manuals say of G90, G92, G94 and G110 to G117, and of the codes that programs
// with these cycles use. (p, q, d) are the first and second axis of the plane and the depth axis; A
// is where a cycle starts, C the programmed end point.
#pragma once

#include <array>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference::catalog {

inline constexpr std::string_view kG94 = "GSK 988TA programming, G94 radial cutting cycle";
inline constexpr std::string_view kG110 = "GSK 988TA milling cycles, G110/G111 circular pocket";
inline constexpr std::string_view kG90 = "GSK 988TA programming, G90 axial cutting cycle";
inline constexpr std::string_view kG92 = "GSK 988TA programming, G92 thread cutting cycle";
inline constexpr std::string_view kG112 = "GSK 988TA milling cycles, G112/G113 helical pocket";
inline constexpr std::string_view kG114 =
    "GSK 988TA milling cycles, G114/G115 external and G116/G117 internal threads";
inline constexpr std::string_view kBasic = "GSK 988TA programming, basic codes and block format";

using enum ClauseLevel;
inline constexpr auto kGsk988ta = std::to_array<Clause>({
    {"GSK-G94-01", must, kG94,
     "The positioning axis is p and the cutting axis q of the plane: G17 X and Y, G18 Z and X, "
     "G19 Y and Z.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-02", must, kG94,
     "Traverse from A to B along p alone: B lies R beyond C on p, and level with A on q.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-03", must, kG94, "Feed from B to C, given by absolute words or by increments from A.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-04", must, kG94, "Feed from C to D along p alone, until p is that of A again.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-05", must, kG94, "Traverse from D to A along q: the cycle ends where it began.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-06", must, kG94,
     "The end point, R and F are retained: a later block with only some of them repeats the cycle.",
     "reference/gsk988ta/cutting_cycle.cpp"},
    {"GSK-G94-07", must, kG94,
     "A code of group 00 other than G04, and another code of group 01, clears the retained end "
     "point and R.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-G94-08", must, kG94,
     "A word for an axis outside the plane in a block of the cycle is an alarm; one that moves "
     "nothing is one, too, or ignored.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-09", open, kG94,
     "Where R and the travel from A to C on p have opposite signs, R is not the larger; that "
     "stands below the figures alone, so a larger one runs as it stands or is an alarm.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-10", must, kG94,
     "Single block stops after the whole cycle: its motions are those of one block.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-11", derived, kG94,
     "R is a true length, also where p is X programmed as a diameter: travel and R are compared as "
     "true lengths.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-12", derived, kG94,
     "In the block that enters the cycle a missing axis has no travel and a missing R is 0; R "
     "alone runs the cycle; neither axis nor R: nothing moves, or the cycle again where a later "
     "block has its code or F.",
     "reference/gsk988ta/g94.cpp"},

    {"GSK-G90-01", must, kG90, "The positioning axis is q and the cutting axis p of the plane.",
     "reference/gsk988ta/g90.cpp"},
    {"GSK-G90-02", must, kG90,
     "Traverse from A to B along q alone: B lies R beyond C on q, and level with A on p.",
     "reference/gsk988ta/g90.cpp"},
    {"GSK-G90-03", must, kG90, "Feed from B to C, given by absolute words or by increments from A.",
     "reference/gsk988ta/g90.cpp"},
    {"GSK-G90-04", must, kG90, "Feed from C to D along q alone, until q is that of A again.",
     "reference/gsk988ta/g90.cpp"},
    {"GSK-G90-05", must, kG90, "Traverse from D to A along p: the cycle ends where it began.",
     "reference/gsk988ta/g90.cpp"},
    {"GSK-G90-06", must, kG90,
     "The end point, R and F are retained: a later block with only some of them repeats the "
     "cycle.",
     "reference/gsk988ta/cutting_cycle.cpp"},
    {"GSK-G90-07", must, kG90,
     "A code of group 00 other than G04, and another code of group 01, clears the retained end "
     "point and R.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-G90-08", must, kG90,
     "A word for an axis outside the plane in a block of the cycle is an alarm; one that moves "
     "nothing is one, too, or ignored.",
     "reference/gsk988ta/g90.cpp"},
    {"GSK-G90-09", must, kG90,
     "Where R and the travel from A to C on q have opposite signs, R may not be the larger; no "
     "travel is no opposite sign.",
     "reference/gsk988ta/g90.cpp"},
    {"GSK-G90-10", must, kG90,
     "Single block stops after the whole cycle: its motions are those of one block.",
     "reference/gsk988ta/g90.cpp"},
    {"GSK-G90-11", derived, kG90,
     "R is a true length, also where q is X programmed as a diameter: travel and R are "
     "compared as true lengths.",
     "reference/gsk988ta/g90.cpp"},
    {"GSK-G90-12", derived, kG90,
     "In the block that enters the cycle a missing axis has no travel and a missing R is 0; R "
     "alone runs the cycle; neither axis nor R: nothing moves, or the cycle again where a later "
     "block has its code or F.",
     "reference/gsk988ta/g90.cpp"},

    {"GSK-G92-01", must, kG92,
     "The positioning axis is q and the thread runs along p, with R along q.",
     "reference/gsk988ta/g92.cpp"},
    {"GSK-G92-02", must, kG92,
     "Traverse from A to B along q alone: B lies R beyond C on q, and level with A on p.",
     "reference/gsk988ta/g92.cpp"},
    {"GSK-G92-03", must, kG92,
     "Cut the thread from B to C with the lead F, the way along the longer axis in one turn of "
     "the spindle; a thread without a lead is an alarm.",
     "reference/gsk988ta/g92.cpp"},
    {"GSK-G92-04", must, kG92, "Traverse from C to D along q alone, until q is that of A again.",
     "reference/gsk988ta/g92.cpp"},
    {"GSK-G92-05", must, kG92, "Traverse from D to A along p: the cycle ends where it began.",
     "reference/gsk988ta/g92.cpp"},
    {"GSK-G92-06", open, kG92,
     "The end point, R, F, J and K are retained. F is a lead apart from the feed, a length in "
     "the units of its block.",
     "reference/gsk988ta/g92.cpp"},
    {"GSK-G92-07", open, kG92,
     "J is the run-out along the short axis and K along the long one, without sign; without "
     "both, parameter 5130 gives it in tenths of the lead. A run-out above 0 follows the "
     "drives and is not covered.",
     "reference/gsk988ta/g92.cpp"},
    {"GSK-G92-08", derived, kG92,
     "A word for an axis outside the plane in a block of the cycle is an alarm; one that moves "
     "nothing is one, too, or ignored.",
     "reference/gsk988ta/g92.cpp"},
    {"GSK-G92-09", must, kG92,
     "Where R and the travel from A to C on q have opposite signs, R may not be the larger; no "
     "travel is no opposite sign.",
     "reference/gsk988ta/g92.cpp"},
    {"GSK-G92-10", derived, kG92,
     "Single block stops after the whole cycle: its motions are those of one block.",
     "reference/gsk988ta/g92.cpp"},
    {"GSK-G92-11", derived, kG92,
     "A code of group 00 other than G04, and another code of group 01, clears the retained end "
     "point and R.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-G92-12", derived, kG92,
     "A missing axis has no travel and a missing R is 0; R alone runs the cycle; neither axis "
     "nor R: nothing moves, or the cycle again where a later block has its code or another of its "
     "words.",
     "reference/gsk988ta/g92.cpp"},
    {"GSK-G92-13", open, kG92,
     "An inch thread (I), a face thread (P), more than one start (L) and a shifted start angle "
     "(Q) are not covered.",
     "reference/gsk988ta/g92.cpp"},

    {"GSK-G110-01", must, kG110,
     "The words of the plane give the centre; the depth word is the bottom, or as an increment the "
     "distance from the R plane to it; R leads from the initial plane to the R plane, which "
     "coincide without it.",
     "reference/gsk988ta/milling.cpp"},
    {"GSK-G110-02", must, kG110,
     "I, L, Q and D must be given on entering the cycle and are retained in it.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-03", must, kG110,
     "The pocket radius I must be larger than the tool radius D, the step L smaller than the tool "
     "diameter.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-04", derived, kG110,
     "R and the way from the R plane to the bottom must have one direction.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-06", must, kG110,
     "Traverse to the centre in the plane, with every other axis that is commanded but d.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-07", derived, kG110, "Traverse d to the R plane.", "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-08", must, kG110, "Feed d by Q; the last layer takes what remains.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-09", must, kG110,
     "Clear the layer from the centre by arcs that turn as commanded, with the step L, until the "
     "circle of radius I is clean.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-10", must, kG110, "Traverse d to the R plane, then the plane axes to the centre.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-11", open, kG110,
     "Traverse d to abs(P) above the last depth; where that lies beyond the R plane, there or to "
     "the "
     "R plane. Feed to the next depth.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-12", must, kG110, "Repeat to the bottom.", "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-13", open, kG110,
     "After the last layer the tool retracts to the R plane and the centre, and then to the "
     "initial plane.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-14", must, kG110,
     "The axis words are not retained: a block without them mills nothing.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-15", derived, kG110, "G80 and every code of group 01 cancel the cycle.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-G110-16", derived, kG110, "I and L of a block that mills are above zero.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-17", derived, kG110,
     "A pocket without depth is positioned over and left again; it needs no feed.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-18", open, kG110, "X and U are diameters as the depth words of G19 too.",
     "reference/gsk988ta/milling.cpp"},
    {"GSK-G110-20", open, kG110,
     "Q = 0 of a block that mills is one layer, or an alarm: the table of ranges begins at 0.",
     "reference/gsk988ta/g110.cpp"},

    {"GSK-G112-01", must, kG112,
     "The words are those of G110; I and D must be given on entering the cycle and are "
     "retained in it; L is the number of turns, a whole number from 1 to 99999, and 1 without "
     "it; M35 clamps C before the motion.",
     "reference/gsk988ta/g112.cpp"},
    {"GSK-G112-02", must, kG112, "The pocket radius I must be larger than the tool radius D.",
     "reference/gsk988ta/g112.cpp"},
    {"GSK-G112-03", must, kG112,
     "Traverse to the centre in the plane, with every other axis that is commanded but d; "
     "traverse d to the R plane.",
     "reference/gsk988ta/g112.cpp"},
    {"GSK-G112-04", must, kG112,
     "Feed along a semicircle of radius (I - D)/2 from the centre to the circle of radius I - "
     "D.",
     "reference/gsk988ta/g112.cpp"},
    {"GSK-G112-05", must, kG112,
     "L full turns of radius I - D, each going down by its share of the depth: one helix.",
     "reference/gsk988ta/g112.cpp"},
    {"GSK-G112-06", must, kG112, "Feed along a semicircle of radius (I - D)/2 back to the centre.",
     "reference/gsk988ta/g112.cpp"},
    {"GSK-G112-07", open, kG112,
     "Back to the initial plane along d; the text prints no speed: a traverse, or a feed.",
     "reference/gsk988ta/g112.cpp"},
    {"GSK-G112-08", must, kG112, "F is the resultant speed along the helix.",
     "reference/gsk988ta/g112.cpp"},
    {"GSK-G112-09", derived, kG112,
     "Both semicircles turn as commanded and touch the circle tangentially.",
     "reference/gsk988ta/g112.cpp"},
    {"GSK-G112-10", derived, kG112,
     "R and the way from the R plane to the bottom must have one direction.",
     "reference/gsk988ta/g112.cpp"},

    {"GSK-G114-01", derived, kG114,
     "The words of the plane give the centre of the workpiece; the depth word is the bottom of "
     "the thread, or as an increment the distance from the R plane to it; R as in G110.",
     "reference/gsk988ta/g114.cpp"},
    {"GSK-G114-02", must, kG114,
     "The lead I, the diameter E before threading, the thread height P and the tool radius D "
     "must be given, each above zero; J defaults to parameter 5921 and K to parameter 5920.",
     "reference/gsk988ta/g114.cpp"},
    {"GSK-G114-03", must, kG114, "P is no larger than D.", "reference/gsk988ta/g114.cpp"},
    {"GSK-G114-04", must, kG114,
     "Without Q, or with Q not below P, one pass; else as many passes as Q goes into P, the "
     "last taking what remains.",
     "reference/gsk988ta/g114.cpp"},
    {"GSK-G114-05", must, kG114, "Traverse to the centre in the plane; traverse d to the R plane.",
     "reference/gsk988ta/g114.cpp"},
    {"GSK-G114-06", must, kG114,
     "Each pass: an arc to the start of the thread, infeed to the radius of the pass, a helix "
     "of lead I from the R plane to the bottom, a partial last turn allowed, the run-out, back to "
     "the R plane, away to the safe position.",
     "reference/gsk988ta/thread_path.cpp"},
    {"GSK-G114-07", open, kG114,
     "Back to the initial plane along d at the end; the text prints no speed: a traverse, or a "
     "feed.",
     "reference/gsk988ta/g114.cpp"},
    {"GSK-G114-08", must, kG114, "F is the resultant speed along the helix.",
     "reference/gsk988ta/g114.cpp"},
    {"GSK-G114-09", derived, kG114,
     "G114 and G116 turn clockwise, which going down is a right-hand thread; G115 and G117 "
     "counterclockwise.",
     "reference/gsk988ta/g114.cpp"},
    {"GSK-G114-10", derived, kG114,
     "The entry is an arc at the R plane, the infeed straight, the helix of so many turns as its "
     "depth has, all of one sense; from where the run-out ends the tool returns along d alone, and "
     "moves along p alone until it is as far from the axis as rho_0 + J, in a bore as near to it "
     "along p as rho_0 - J. Nothing is deeper than its pass; with J as long as the thread is deep "
     "the way back keeps off the material.",
     "reference/gsk988ta/thread_path.cpp", std::nullopt,
     "The steps of GSK-G114-06, each taken as it is written: back to the R plane, then along "
     "the first axis to the safe position that J gives."},
    {"GSK-G114-11", open, kG114,
     "A pass ends with a run-out to the free side that gains J at K degrees; what K is measured "
     "from is open, one for a whole program. J = 0: none, and K is not needed. What neither the "
     "block nor the parameters give is not known.",
     "reference/gsk988ta/thread_path.cpp", Basis::text},
    {"GSK-G114-12", open, kG114,
     "Q = 0 counts as omitted; R that leads away from the bottom is an alarm as in G110; R of "
     "G116 and G117 is optional.",
     "reference/gsk988ta/g114.cpp"},
    {"GSK-G114-13", open, kG114, "K is an angle from 0 to 360 degrees.",
     "reference/gsk988ta/words.cpp"},
    {"GSK-G114-14", derived, kG114,
     "Inside the block of a thread every motion is one of its steps (GSK-CYC-01).",
     "reference/gsk988ta/g114.cpp", std::nullopt,
     "GSK-CYC-01 and the list of steps, which is complete."},
    {"GSK-G114-15", derived, kG114,
     "An internal thread needs a tool radius that is not larger than E/2.",
     "reference/gsk988ta/g114.cpp"},
    {"GSK-G114-16", derived, kG114,
     "Every other axis that is commanded but d is positioned with the centre.",
     "reference/gsk988ta/g114.cpp"},

    {"GSK-COM-01", derived, kBasic,
     "A required word that is missing is an alarm; an arc with neither R nor a centre is one, or a "
     "straight feed, as parameter 3403#5 has it.",
     "reference/gsk988ta/arc.cpp"},
    {"GSK-COM-02", derived, kBasic,
     "A G code that the control lacks, one with decimals too, and text that cannot be read, are "
     "alarms; a comment in brackets and the text after a semicolon are ignored.",
     "reference/gsk988ta/codes.cpp"},
    {"GSK-COM-03", open, kBasic,
     "A length with more decimals than the least increment has keeps its exact value.",
     "reference/gsk988ta/words.cpp"},
    {"GSK-COM-04", derived, kBasic, "A cutting motion needs a feed in force.",
     "reference/gsk988ta/basic_motion.cpp"},
    {"GSK-COM-05", derived, kBasic,
     "Positioning, straight and circular feeds, dwell, planes, units, reference point, renaming of "
     "the position, feed modes, M, S and T; the arc's rules for R and I J K.",
     "reference/gsk988ta/basic_motion.cpp"},
    {"GSK-COM-06", derived, kBasic,
     "The ranges of the words hold in the blocks of the cycles that use them: to 999999.999 mm or "
     "99999.9999 inch, in ISC to a tenth of it; I L Q D E J K and P of a thread take no sign.",
     "reference/gsk988ta/words.cpp"},
    {"GSK-WRD-01", derived, kBasic,
     "Every word of a block is used by its code, or ignored by a rule of the list below, or it "
     "ends the program as not covered: a control may chamfer or round by it.",
     "reference/gsk988ta/word_use.cpp", std::nullopt,
     "A word that changes a path on some control, ignored, is a wrong path."},
    {"GSK-COM-07", open, kBasic,
     "One address twice, and two codes of one group, are an alarm; a parameter of the machine can "
     "let the later one win.",
     "reference/gsk988ta/words.cpp"},
    named_otherwise({"GSK-COM-08", open, kBasic,
                     "F 0 is no feed and a negative F is an alarm. No text says so; our judgement.",
                     "reference/gsk988ta/words.cpp"},
                    "value-sign value-out-of-range feed-missing"),

    {"GSK-COM-15", derived, kBasic,
     "A program that no M02, M30 or second % ends is an alarm where parameter 3404#6 of the "
     "machine is 0; else it ends with its text.",
     "reference/gsk988ta/interpreter.cpp"},

    {"GSK-MOD-01", open, kG110,
     "A cycle is entered by its code from outside, or from a cycle of another mode; G110 and G111 "
     "are one mode, and so are G112 and G113; the code written again is not an entry.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-MOD-02", derived, kG110,
     "Missing I L Q D is looked for in the entry block and in every block that mills; a block that "
     "mills nothing still takes its words in.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-CYC-01",
     derived,
     kBasic,
     "Inside the block of a cycle every motion is one that a clause of the cycle describes, within "
     "what the clause leaves open; any other is none of the cycle.",
     "reference/gsk988ta/milling.hpp",
     {},
     "The manual lists the motions of each cycle as its whole course."},
    {"GSK-CYC-02", must, kG110,
     "A level is cleared from the centre with the step L: the place first cut is the centre, and "
     "each place is cut from material already removed within L of it.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-MOD-03", open, kG110, "R and P of G110 to G113 hold for their block.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-MOD-04", open, kG114,
     "G114 and G115 are one mode, G116 and G117 one; they stay in force as G110. No text says "
     "whether their words do: each block that mills gives I, P, D and E, or I P Q D E J K are "
     "retained as in G110.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-MOD-05", derived, kG110,
     "The initial plane is the depth coordinate at which the mode was entered, and stays; another "
     "plane takes that of the new depth axis.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-MOD-06", derived, kBasic,
     "G80 and every code of group 01 end the mode; G80 also ends G90, G92 and G94. Axis words "
     "after it, in its own block too, are positioned; or, where G80 is of the group of the milling "
     "cycles, the last of G00 to G03 moves them: which group it is of is open.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-MOD-07", open, kBasic,
     "Retained words are lengths: units and planes do not change them, or clear them, or units "
     "leave their numbers; a retained increment is taken from A again; a retained word of an "
     "axis outside the new plane waits, or is cleared. No text says so; our judgement.",
     "reference/gsk988ta/cutting_cycle.cpp"},
    {"GSK-MOD-08", derived, kBasic,
     "The codes of group 00 are G04, G28 and G50; all but G04 clear the retained words of G94, "
     "none clears I L Q D.",
     "reference/gsk988ta/basic_motion.cpp"},
    named_otherwise({"GSK-MOD-09", open, kBasic,
                     "A code of group 01 and a code of the milling cycles exclude each other in a "
                     "block. No text says so; our judgement.",
                     "reference/gsk988ta/words.cpp"},
                    "duplicate-word"),
});

}  // namespace gonogo::reference::catalog
