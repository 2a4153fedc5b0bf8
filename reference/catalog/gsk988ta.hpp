// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the GSK 988TA manuals say of G94, G110 and G111, and of the codes that programs with these
// cycles use. (p, q, d) are the first and second axis of the plane and the depth axis; A is where a
// cycle starts, C the programmed end point.
#pragma once

#include <array>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference::catalog {

inline constexpr std::string_view kG94 = "GSK 988TA programming, G94 radial cutting cycle";
inline constexpr std::string_view kG110 = "GSK 988TA milling cycles, G110/G111 circular pocket";
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
    {"GSK-G94-03", must, kG94,
     "Feed from B to C, given by absolute words or by increments from A.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-04", must, kG94, "Feed from C to D along p alone, until p is that of A again.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-05", must, kG94, "Traverse from D to A along q: the cycle ends where it began.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-06", must, kG94,
     "The end point, R and F are retained: a later block with only some of them repeats the cycle.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-07", must, kG94,
     "A code of group 00 other than G04, and another code of group 01, clears the retained end "
     "point and R.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-G94-08", must, kG94,
     "A word for an axis outside the plane in a block of the cycle is an alarm.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-09", derived, kG94,
     "Where R and the travel from A to C on p have opposite signs, R may not be the larger.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-10", must, kG94,
     "Single block stops after the whole cycle: its motions are those of one block.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-11", derived, kG94,
     "R is a true length, also where p is X programmed as a diameter: travel and R are compared as "
     "true lengths.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-G94-12", derived, kG94,
     "In the block that enters the cycle a missing axis has no travel and a missing R is 0; R alone "
     "runs the cycle; neither axis nor R: nothing moves.",
     "reference/gsk988ta/g94.cpp"},

    {"GSK-G110-01", must, kG110,
     "The words of the plane give the centre; the depth word is the bottom, or as an increment the "
     "distance from the R plane to it; R leads from the initial plane to the R plane, which "
     "coincide without it.",
     "reference/gsk988ta/g110.cpp"},
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
    {"GSK-G110-11", derived, kG110,
     "Traverse d to abs(P) above the last depth, never beyond the R plane; feed to the next depth.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-12", must, kG110, "Repeat to the bottom.", "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-13", open, kG110,
     "After the last layer the tool retracts to the R plane and the centre, and then to the initial "
     "plane.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-14", must, kG110,
     "The axis words are not retained: a block without them mills nothing.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-15", open, kG110, "G80 and every code of group 01 cancel the cycle.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-G110-16", derived, kG110, "I, L, Q and D of a block that mills are above zero.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-17", derived, kG110,
     "A pocket without depth is positioned over and left again; it needs no feed.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-G110-18", open, kG110,
     "X and U are diameters as the depth words of G19 too.",
     "reference/gsk988ta/g110.cpp"},

    {"GSK-COM-01", derived, kBasic,
     "A required word that is missing, an address written twice, and an axis given both absolute "
     "and as an increment are alarms.",
     "reference/gsk988ta/words.cpp"},
    {"GSK-COM-02", derived, kBasic,
     "A G code that the control lacks, and text that cannot be read, are alarms.",
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
    {"GSK-COM-06", open, kBasic,
     "The ranges of the words hold in the blocks of the cycles; a word that the code does not use "
     "is checked against its range and ignored.",
     "reference/gsk988ta/words.cpp"},
    {"GSK-COM-07", open, kBasic,
     "One address twice, and two codes of one group, are an alarm; a parameter of the machine can "
     "let the later one win.",
     "reference/gsk988ta/words.cpp"},
    {"GSK-COM-08", open, kBasic,
     "F 0 is no feed and a negative F is an alarm; the text after a semicolon is ignored; a decimal "
     "G code that the control lacks is undefined.",
     "reference/gsk988ta/words.cpp"},

    {"GSK-MOD-01", open, kG110,
     "A cycle is entered by its code from outside; G110 and G111 are one mode, and the code written "
     "again is not an entry.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-MOD-02", derived, kG110,
     "Missing I L Q D is looked for in the entry block and in every block that mills; a block that "
     "mills nothing still takes its words in.",
     "reference/gsk988ta/g110.cpp"},
    {"GSK-MOD-03", open, kG110, "R and P hold for their block.", "reference/gsk988ta/g110.cpp"},
    {"GSK-MOD-05", open, kG110,
     "The initial plane is the depth coordinate at which the mode was entered, and stays; a plane "
     "code takes that of the new depth axis.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-MOD-06", open, kBasic,
     "G80 and every code of group 01 end the mode; G80 also ends G94, and axis words after it, in "
     "its own block too, are positioned.",
     "reference/gsk988ta/interpreter.cpp"},
    {"GSK-MOD-07", open, kBasic,
     "Retained words are lengths: units and planes do not change them; a retained increment is taken "
     "from A again; a retained word of an axis outside the new plane waits.",
     "reference/gsk988ta/g94.cpp"},
    {"GSK-MOD-08", derived, kBasic,
     "The codes of group 00 are G04, G28 and G50; all but G04 clear the retained words of G94, none "
     "clears I L Q D.",
     "reference/gsk988ta/basic_motion.cpp"},
    {"GSK-MOD-09", open, kBasic,
     "A code of group 01 and a code of the milling cycles exclude each other in a block.",
     "reference/gsk988ta/words.cpp"},
});

}  // namespace gonogo::reference::catalog
