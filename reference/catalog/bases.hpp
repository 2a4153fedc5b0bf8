// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the clauses rest on that no text states word for word: of each that is derived its
// derivation in one line. A clause of the level `open` that is decided by a reading rests on the
// reading as chosen: what departs from it departs from the choice. What has neither is unstated
// (silent_rules.hpp, and the open clauses that are not named here).
#pragma once

#include <array>

#include "reference/catalog/clause.hpp"

namespace gonogo::reference::catalog {

struct ClauseBasis {
  std::string_view id;
  std::string_view derivation;
};

inline constexpr std::string_view kAsChosen =
    "The text leaves it open; it holds as the reading says that the profile chooses.";
inline constexpr std::string_view kNotExpected =
    "The texts have these forms and the gauge does not read them: it expects nothing of them.";

inline constexpr auto kBases = std::to_array<ClauseBasis>({
    {"GSK-G94-09", kAsChosen},
    {"GSK-G94-11", "R is said to be a radius value; the end points are diameters."},
    {"GSK-G94-12",
     "What is not commanded has no travel; the straight form is the taper form without R."},
    {"GSK-G90-11", "R is said to be a radius value; the end points are diameters."},
    {"GSK-G90-12",
     "What is not commanded has no travel; the straight form is the taper form without R."},
    {"GSK-G92-06", kAsChosen},
    {"GSK-G92-07", kNotExpected},
    {"GSK-G92-08", "Note 1 of G90 and G94 speaks of all cutting cycles of the group."},
    {"GSK-G92-10", "Note 3 of G90 and G94, for the third cycle of their kind."},
    {"GSK-G92-11", "Note 2 of G90 and G94, for the third cycle of their kind."},
    {"GSK-G92-12", "As for G90, whose words it has."},
    {"GSK-G92-13", kNotExpected},
    {"GSK-G110-04",
     "Note 2 wants one direction of R and Q; Q has no sign, so its direction is that of the "
     "infeed, from the R plane to the bottom."},
    {"GSK-G110-07", "Step 2 moves by R without a feed; the sister cycles print the traverse."},
    {"GSK-G110-11", kAsChosen},
    {"GSK-G110-13", kAsChosen},
    {"GSK-G110-15",
     "The list of the codes has G80 and the cutting codes in group 01, and a modal code holds "
     "until another of its group."},
    {"GSK-G110-16",
     "A step of nothing never comes to an end; I is larger than D, which is no less than 0."},
    {"GSK-G110-17", kAsChosen},
    {"GSK-G110-18", kAsChosen},
    {"GSK-G110-20", kAsChosen},
    {"GSK-G112-07", kAsChosen},
    {"GSK-G112-09",
     "Only the tangential semicircles from the centre to the circle of I - D have the "
     "radius (I - D)/2; the code names one sense."},
    {"GSK-G112-10",
     "Note 2, printed again below G112: R has the direction of the infeed, which Q stands for."},
    {"GSK-G114-01", "The table of the words, as that of G110 in the same chapter."},
    {"GSK-G114-07", kAsChosen},
    {"GSK-G114-09",
     "Clockwise and counterclockwise as in the rest of the chapter; clockwise on the way down is a "
     "right-hand thread."},
    {"GSK-G114-10", "The steps of the text in their order leave room for nothing else."},
    {"GSK-G114-11", kAsChosen},
    {"GSK-G114-12", kAsChosen},
    {"GSK-G114-13", kAsChosen},
    {"GSK-G114-15",
     "The tool goes down at the centre of a bore of diameter E; one of a larger diameter 2D "
     "cannot."},
    {"GSK-G114-16",
     "Note 1 of G110 and G112, of the same chapter: all axes but the milling axis are positioned."},
    {"GSK-COM-01",
     "A code whose word is missing does not say what to do; of an arc it holds as the reading says "
     "that the profile chooses."},
    {"GSK-COM-02",
     "The manual lists the codes and the form of a block: what is outside commands nothing that a "
     "control could carry out."},
    {"GSK-COM-03", kAsChosen},
    {"GSK-COM-04", "F is the speed of a cut: without one the cut has none."},
    {"GSK-COM-05",
     "The chapters on the basic codes, where those of the 988TA were not at hand those of the "
     "980TDi; parameters 3410 and 3403#4 for the radii of an arc."},
    {"GSK-COM-06", "The tables of ranges stand with the words of a cycle, and for them."},
    {"GSK-COM-07",
     "Parameter 3403#6 allows both; it holds as the profile chooses by the parameter or the "
     "reading."},
    {"GSK-COM-15",
     "Parameter 3404#6 allows both; it holds as the profile chooses by the parameter."},
    {"GSK-MOD-01", kAsChosen},
    {"GSK-MOD-02",
     "What must be given on entering the cycle is in force when it first mills, or is missing."},
    {"GSK-MOD-03", kAsChosen},
    {"GSK-MOD-04", kAsChosen},
    {"GSK-MOD-05",
     "R leads from the initial plane, where the tool is when the cycle is entered, and each pocket "
     "ends there."},
    {"GSK-MOD-06",
     "Every list of the codes has G80 for the end of a cycle, one in group 01 and one in the group "
     "of the drilling cycles; it holds as the reading says that the profile chooses."},
    {"GSK-MOD-08", "Note 2 of G94, with the list of the codes of group 00."},

    {"HNC-G80-01",
     "The path A B C D A, and its legend: R is a traverse, F the feed; older print: AB and DA "
     "traverses."},
    {"HNC-G80-02", "The difference of two radii has no other bound than that it has its sign."},
    {"HNC-G81-01",
     "The path A B C D A, and its legend: R is a traverse, F the feed; older print: AB and DA "
     "traverses."},
    {"HNC-G82-01", "The path A B C D A of the simple cycles, with the figure of G82: 1R 2F 3R 4R."},
    {"HNC-G82-02", "R and E are vectors, drawn from the end point C outward."},
    {"HNC-G82-06",
     "C counts starts, so it is whole and not below zero; P is the angle between adjacent "
     "starts."},
    {"HNC-G82-07", "The format prints F/J: one lead, in one of two units."},
    {"HNC-G82-10",
     "Q is said to be of the run-out, and to come with the versions 7.11 and 4.03: an older "
     "control "
     "has no such word."},
    {"HNC-G74-02",
     "The letters of the path of way 1 in G75: five pecks and four withdrawals, then out."},
    {"HNC-G74-03", "The letters of the path of way 2: A B A."},
    {"HNC-G74-05", "Way 1 has both words, way 2 goes down in one for any depth of a peck."},
    {"HNC-G75-02", "The letters of the path of way 1: five pecks and four withdrawals, then out."},
    {"HNC-G75-03", "The letters of the path of way 2: A B A."},
    {"HNC-G75-04",
     "The letters of the path with a width: each plunge ends at X of A, then a step along Z; how "
     "many holds as the readings say that the profile chooses."},
    {"HNC-MOD-02",
     "A modal code holds until another of its group; the printed programs repeat X and Z alone."},
    {"HNC-MOD-03", kAsChosen},
    {"HNC-MOD-04", kAsChosen},
    {"HNC-COM-01",
     "The manual lists the codes and their words: one that is missing, or a code that is not "
     "there, says nothing to carry out; a cut without F has no speed."},

    {"NGC-COM-06", kAsChosen},
    {"NGC-ARC-06", kAsChosen},
    {"NGC-CYC-09", kAsChosen},
    {"NGC-CYC-17", kNotExpected},
    {"NGC-POL-02", "A program that LinuxCNC ships drills a bolt circle by ^ alone."},
    {"NGC-POL-04", kNotExpected},
    {"NGC-CYC-20", "The feeds of a cycle are cuts, and a cut without F has no speed."},
    {"NGC-CYC-25", "The codes of motion are named that cancel a cycle; no other code does."},
    {"NGC-CYC-26",
     "The steps of the cycle end there, and axis words go on from where the tool is."},
    {"NGC-CYC-27", "The order in which the words of a block act: a dwell before motion."},
    {"NGC-CYC-28",
     "The steps of the cycle in the order of the text, with spindle stops and starts between "
     "motions; speed and M functions act before motion."},
    {"NGC-CYC-29", kAsChosen},
    {"NGC-CYC-30", "The table of modal groups: one code of each in a block."},
    {"NGC-G83-05", "The level is said by the last peck alone."},
    {"NGC-G83-08", kAsChosen},
    {"NGC-G73-04", "The level is said by the last peck alone."},
    {"NGC-G84-03",
     "The next hole needs the spindle as the first did; both interpreters have it so."},
    {"NGC-G84-04", kAsChosen},
    {"NGC-G84-05", "What is said of all cycles in G18 and G19."},
    {"NGC-G87-01", kNotExpected},
    {"NGC-G88-01", kNotExpected},
    {"NGC-G33-05", kAsChosen},
    {"NGC-OFS-01",
     "Each of the offsets is said to be added, and the machine's coordinates to have none."},
    {"NGC-OFS-07", kAsChosen},
    {"NGC-EXP-05", kAsChosen},
    {"NGC-EXP-06", "There is no such number."},
    {"NGC-EXP-07", kNotExpected},
    {"NGC-EXP-08", kNotExpected},
    {"NGC-OWD-10", kNotExpected},
    {"NGC-OWD-12", kNotExpected},
    {"NGC-G33-06", "The table of modal groups, and the prototype of the code with its words."},
    {"NGC-G331-02",
     "The text has the spindle turn the other way at both ends, by no word of the "
     "program."},
    {"NGC-G331-03", "A synchronous path is the same at any speed."},
    {"NGC-G76-07",
     "All passes are cut from a start that moves in with the depth, and leave as they "
     "came."},
    {"NGC-G76-08", kAsChosen},
    {"NGC-G76-13", "The feed comes from the lead; the prototype shows the words that are needed."},
    {"NGC-G76-14",
     "The units are said of lengths; the rest are counts, a degression and an angle."},
    {"NGC-COM-01",
     "The language is a list of words, codes and groups, of which one of each may stand on a "
     "line."},

    {"SIE-LEX-01",
     "The list of characters says what is a blank, the chapter on the structure of a block where "
     "'=' is needed and what a value is: anything else is no block."},
    {"SIE-PAR-01",
     "An assignment holds from where it stands; a value that does not exist cannot be assigned."},
    {"SIE-G1-03", "G90, G91, AC and IC are said of end points; a rotary axis has one."},
    {"SIE-ARC-07", "The text of alarm 14040, with the machine data that it names."},
    {"SIE-ARC-08", "The text of alarm 14040: a new centre, and how far it may move."},
    {"SIE-ARC-09", "The chapter on helices: a third axis, and TURN for further turns."},
    {"SIE-ARC-10", "A full circle ends where it starts: decided without rounding."},
    {"SIE-ARC-11", "The forms of G2 and G3 are listed; half a form, or two, is none of them."},
    {"SIE-ARC-12",
     "The axes of the end point choose the plane, but not with AR= and not of a helix."},
    {"SIE-ARC-13",
     "The chapter on helices: TURN from 0 to 999, as a word of G2 and G3; 0 beside CT, and beside "
     "CIP "
     "by the text of alarm 14920."},
    {"SIE-ARC-16", kAsChosen},
    {"SIE-CIP-01", "The chapter on CIP, and the text of alarm 14920."},
    {"SIE-CIP-02", "Through fewer than three points there is no one circle."},
    {"SIE-CT-01", "An arc is tangent in one way; straight behind there is none of finite radius."},
    {"SIE-CT-02", "The chapter on CT: the last path element, its projection, and a helix."},
    {"SIE-POL-01", "The chapter on polar coordinates."},
    {"SIE-POL-02", "The chapter on polar coordinates: ranges, and how long AP and RP hold."},
    {"SIE-POL-04", kAsChosen},
    {"SIE-MOD-02", "The lists of codes, of the initial settings and of the M functions."},
    {"SIE-MOD-03", "The chapter on the dwell: F seconds or S revolutions, in a block of its own."},
    {"SIE-MOD-04", "The chapter on G70 and G71: what is converted and what is not."},
    {"SIE-MOD-05",
     "Alarm 12060 of the control: two codes of one group in a block; '/' is read when skipping is "
     "on."},
    {"SIE-MOD-07", "The chapter on the constant cutting rate: G96, G961, G97, G971 and LIMS."},
    {"SIE-MOD-08", kAsChosen},
    {"SIE-COM-01",
     "Alarms 10860, 14800, 12010 and 16420 of the control: no feed, a feed below zero, an address "
     "twice; a point has one kind of coordinates."},
    {"SIE-FRM-01", "TRANS of the successor: it replaces; alone it clears; or as the reading says."},
    {"SIE-FRM-02", "ROT and AROT of the successor; the example's comments: rotate, rotate on."},
    {"SIE-FRM-03", kAsChosen},
    {"SIE-FRM-04", "Statements of frames need a block of their own on the successor."},
    {"SIE-FRM-06", kAsChosen},
    {"SIE-LC82-01", "The example, and the same cycle of the successor: CYCLE82."},
    {"SIE-LC82-02",
     "From the retract plane the tool comes down to the reference plane, and drills down from "
     "there."},
    {"SIE-LC82-03",
     "Drilling is a cut; a cut without F has no speed. What is modal holds until another of its "
     "group."},
    {"SIE-LC75-06", kAsChosen},
    {"SIE-LC75-08", "What is cut is what a disc of the tool's radius reaches inside the pocket."},
    {"SIE-LC75-09",
     "The table of the parameters: two values of R126 and of R127, a feed each, sizes, and an "
     "allowance below the tool's diameter."},
    {"SIE-LC75-10", "What is cut is what a disc of the tool's radius reaches inside the pocket."},
    {"SIE-LC75-12", "G2 or G3 is the way round the pocket, which only its border shows."},
    {"SIE-LC75-13", "G0 to the centre from any place, and back to it at the end."},
    {"SIE-LC75-14", kAsChosen},
});

}  // namespace gonogo::reference::catalog
