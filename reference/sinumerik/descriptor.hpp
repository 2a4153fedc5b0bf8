// SPDX-License-Identifier: GPL-3.0-or-later
//
// The codes, names and words of SINUMERIK. The 840D has the rows whose features it has.
#pragma once

#include "reference/clause_literal.hpp"
#include "reference/descriptor.hpp"

namespace gonogo::reference::sinumerik {
namespace table {

using enum Role;

inline constexpr auto kEnds = std::to_array<CodeWord>({
    {"X", place, "end point"},
    {"Y", place, "end point"},
    {"Z", place, "end point"},
    {"A", place, "end point, degrees", Life::block, "rotary"},
    {"C", place, "end point, degrees", Life::block, "rotary"},
});
inline constexpr auto kPolar = std::to_array<CodeWord>({
    {"AP", polar_angle, "end point's angle about the pole", Life::modal, "polar"},
    {"RP", polar_radius, "end point's distance from the pole", Life::modal, "polar"},
});
inline constexpr auto kArc = std::to_array<CodeWord>({
    {"I", centre, "centre from the start along X"},
    {"J", centre, "centre from the start along Y"},
    {"K", centre, "centre from the start along Z"},
    {"CR", radius, "radius; below zero of an arc of more than half a turn", Life::block, "cr"},
    {"AR", angle, "angle of the arc", Life::block, "ar"},
    {"TURN", turns, "whole turns before the arc", Life::block, "helix"},
    {"X Y Z", place, "end point of a helix", Life::block, "helix"},
});
inline constexpr auto kIntermediate = std::to_array<CodeWord>({
    {"I1", middle, "intermediate point along X"},
    {"J1", middle, "intermediate point along Y"},
    {"K1", middle, "intermediate point along Z"},
});
inline constexpr auto kDwell = std::to_array<CodeWord>({
    {"F", time, "dwell, s"},
    {"S", count, "dwell, turns of the spindle"},
});
inline constexpr auto kOrigin = std::to_array<CodeWord>({
    {"X", place, "pole"},
    {"Y", place, "pole"},
    {"Z", place, "pole"},
    {"AP", polar_angle, "pole's angle", Life::block, "polar"},
    {"RP", polar_radius, "pole's distance", Life::block, "polar"},
});
inline constexpr auto kShift = std::to_array<CodeWord>({
    {"X", place, "translation"},
    {"Y", place, "translation"},
    {"Z", place, "translation"},
});
inline constexpr auto kTurn = std::to_array<CodeWord>({
    {"RPL", angle, "angle of the rotation"},
});

// Parameters keep their values; a cycle takes those of its call.
inline constexpr auto kDepths = std::to_array<CodeWord>({
    {"R101", along_d, "retract plane", Life::modal},
    {"R102", size, "safety clearance", Life::modal},
    {"R103", along_d, "reference plane", Life::modal},
    {"R104", along_d, "depth", Life::modal},
});
inline constexpr auto kHole = std::to_array<CodeWord>({
    {"R105", time, "dwell, s", Life::modal},
});
inline constexpr auto kPocket = std::to_array<CodeWord>({
    {"R116", along_p, "centre of the pocket", Life::modal},
    {"R117", along_q, "centre of the pocket", Life::modal},
    {"R118", size, "length of the pocket", Life::modal},
    {"R119", size, "width of the pocket", Life::modal},
    {"R120", radius, "radius of the corners", Life::modal},
    {"R121", step, "depth of an infeed", Life::modal},
    {"R122", feed, "feed along the depth", Life::modal},
    {"R123", feed, "feed in the plane", Life::modal},
    {"R124", size, "allowance in the plane", Life::modal},
    {"R125", size, "allowance along the depth", Life::modal},
    {"R126", number, "sense", Life::modal},
    {"R127", number, "roughing or finishing", Life::modal},
});

// SIE-WRD-01: a word that no rule ignores is used, has no meaning for the motion in force
// (SIE-COM-01), or is a name that is not read (SIE-MOD-02).
inline constexpr auto kAnyBlock = std::to_array<IgnoredWords>({
    {"", "S T D H H<n>=", "SIE-MOD-02"_clause,
     "the spindle, the tool and auxiliary functions do not shape the path (G4 and LCYC75 look at "
     "S, T and D)"},
    {"", "NAME:", "SIE-LEX-01"_clause, "a label only says where a jump would lead"},
});
inline constexpr auto kNoFeed = std::to_array<IgnoredWords>({
    {"", "F", "SIE-G1-01"_clause, "the feed is taken in; a traverse has none"},
});

inline constexpr auto kNoTurns = std::to_array<IgnoredWords>({
    {"of 0", "TURN", "SIE-ARC-13"_clause, "no turn is added"},
});

inline constexpr ClauseId kLines = "SIE-G1-01"_clause;
inline constexpr Code kTraverse =
    does(Kind::traverse, Group::motion, kLines, "basic", {kEnds, kPolar}).passing(kNoFeed);
inline constexpr Code kFeed = does(Kind::line, Group::motion, kLines, "basic", {kEnds, kPolar});
inline constexpr Code kRound =
    does(Kind::arc, Group::motion, "SIE-ARC-01"_clause, "arc", {kEnds, kPolar, kArc});
inline constexpr Code kThroughPoint =
    does(Kind::circle, Group::motion, "SIE-CIP-01"_clause, "cip", {kEnds, kIntermediate})
        .passing(kNoTurns);
inline constexpr Code kTangent =
    does(Kind::circle, Group::motion, "SIE-CT-01"_clause, "ct", {kEnds, kPolar}).passing(kNoTurns);
inline constexpr Code kPause =
    does(Kind::dwell, Group::once, "SIE-MOD-03"_clause, "basic", {kDwell});
inline constexpr Code kPole =
    does(Kind::pole, Group::once, "SIE-POL-01"_clause, "polar", {kOrigin});
inline constexpr Code kTranslation =
    does(Kind::frame, Group::once, "SIE-FRM-01"_clause, "frames", {kShift});
inline constexpr Code kRotation =
    does(Kind::frame, Group::once, "SIE-FRM-02"_clause, "frames", {kTurn});
inline constexpr Code kLcyc82 =
    does(Kind::cycle, Group::once, "SIE-LC82-01"_clause, "lcyc82", {kDepths, kHole});
inline constexpr Code kLcyc75 =
    does(Kind::cycle, Group::once, "SIE-LC75-01"_clause, "lcyc75", {kDepths, kPocket}).open();

inline constexpr auto kCodes = std::to_array<Code>({
    kTraverse.named("G0", "traverse"),
    kFeed.named("G1", "straight feed"),
    kRound.named("G2", "arc clockwise", -1),
    kRound.named("G3", "arc counterclockwise", +1),
    kPause.named("G4", "dwell"),
    outside("G5", Group::once, "arc through a point (802S), oblique plunge grinding (840D)"),
    outside("G7", Group::once, "compensating motion of oblique plunge grinding"),
    no_effect("G9", Group::exact_stop, "exact stop"),
    sets("G17", Group::plane, Setting::plane_xy, "plane XY"),
    sets("G18", Group::plane, Setting::plane_zx, "plane ZX").needing("planes"),
    sets("G19", Group::plane, Setting::plane_yz, "plane YZ").needing("planes"),
    outside("G22", Group::diameter, "radius programming"),
    outside("G23", Group::diameter, "diameter programming"),
    outside("G25", Group::once, "lower limit of the working area"),
    outside("G26", Group::once, "upper limit of the working area"),
    outside("G33", Group::motion, "thread cutting of constant lead"),
    outside("G34", Group::motion, "thread cutting of growing lead"),
    outside("G35", Group::motion, "thread cutting of falling lead"),
    no_effect("G40", Group::compensation, "radius compensation off").initial(),
    outside("G41", Group::compensation, "radius compensation left"),
    outside("G42", Group::compensation, "radius compensation right"),
    no_effect("G53", Group::frame, "work offset off in the block"),
    no_effect("G54", Group::offset, "work offset 1"),
    no_effect("G55", Group::offset, "work offset 2"),
    no_effect("G56", Group::offset, "work offset 3"),
    no_effect("G57", Group::offset, "work offset 4"),
    outside("G58", Group::once, "translation along an axis"),
    outside("G59", Group::once, "translation along an axis, added"),
    no_effect("G60", Group::path_mode, "exact stop, modal"),
    outside("G62", Group::path_mode, "corner deceleration"),
    outside("G63", Group::once, "tapping with a compensating chuck"),
    no_effect("G64", Group::path_mode, "continuous path"),
    sets("G70", Group::units, Setting::inch, "inch"),
    sets("G71", Group::units, Setting::metric, "metric"),
    outside("G74", Group::once, "reference point approach"),
    outside("G75", Group::once, "fixed point approach"),
    sets("G90", Group::distance, Setting::absolute, "absolute").initial(),
    sets("G91", Group::distance, Setting::incremental, "incremental"),
    outside("G93", Group::feed_mode, "inverse time feed"),
    sets("G94", Group::feed_mode, Setting::none, "feed per minute").initial(),
    sets("G95", Group::feed_mode, Setting::none, "feed per revolution"),
    sets("G96", Group::feed_mode, Setting::none, "constant cutting speed, feed per revolution"),
    sets("G97", Group::feed_mode, Setting::none, "constant cutting speed off, feed per revolution"),
    kPole.named("G110", "pole from the last position"),
    kPole.named("G111", "pole from the workpiece zero"),
    kPole.named("G112", "pole from the last pole"),
    outside("G140", Group::approach, "direction of a soft approach").to("G143"),
    outside("G147", Group::approach, "soft approach along a straight line"),
    outside("G148", Group::approach, "soft retraction along a straight line"),
    outside("G153", Group::frame, "all frames off in the block"),
    kTranslation.named("G158", "translation"),
    outside("G247", Group::approach, "soft approach along a quadrant"),
    outside("G248", Group::approach, "soft retraction along a quadrant"),
    kRotation.named("G258", "rotation"),
    kRotation.named("G259", "rotation, added"),
    outside("G290", Group::language, "SINUMERIK language"),
    outside("G291", Group::language, "ISO language"),
    outside("G331", Group::motion, "rigid tapping"),
    outside("G332", Group::motion, "retraction of rigid tapping"),
    outside("G335", Group::motion, "thread on an arc, clockwise"),
    outside("G336", Group::motion, "thread on an arc, counterclockwise"),
    outside("G340", Group::approach, "approach in space"),
    outside("G341", Group::approach, "approach in the plane"),
    outside("G347", Group::approach, "soft approach along a semicircle"),
    outside("G348", Group::approach, "soft retraction along a semicircle"),
    no_effect("G450", Group::corner, "transition circle at corners"),
    no_effect("G451", Group::corner, "intersection at corners"),
    outside("G460", Group::corner, "approach and retraction with compensation").to("G462"),
    no_effect("G500", Group::offset, "work offset off"),
    outside("G505", Group::offset, "further work offset").to("G599"),
    no_effect("G601", Group::exact_window, "fine exact stop window"),
    no_effect("G602", Group::exact_window, "coarse exact stop window"),
    outside("G603", Group::exact_window, "exact stop at the set point"),
    outside("G621", Group::path_mode, "corner deceleration at all corners"),
    outside("G641", Group::path_mode, "smoothing by distance"),
    outside("G642", Group::path_mode, "smoothing by axis tolerances"),
    outside("G643", Group::path_mode, "smoothing within the block"),
    outside("G644", Group::path_mode, "smoothing by the axes' dynamics"),
    outside("G645", Group::path_mode, "smoothing of tangential transitions too"),
    outside("G700", Group::units, "inch for feeds too"),
    outside("G710", Group::units, "metric for feeds too"),
    outside("G751", Group::once, "fixed point approach through a point"),
    outside("G810", Group::macro, "code of the machine's maker").to("G819"),
    outside("G820", Group::macro, "code of the machine's maker, another group").to("G829"),
    outside("G931", Group::feed_mode, "feed by the time of the motion"),
    outside("G942", Group::feed_mode, "feed per minute of the last speed code"),
    outside("G952", Group::feed_mode, "feed per revolution of the last speed code"),
    outside("G961", Group::feed_mode, "constant cutting speed, feed per minute"),
    outside("G962", Group::feed_mode, "feed mode of the last speed code"),
    outside("G971", Group::feed_mode, "constant cutting speed off, feed per minute"),
    outside("G972", Group::feed_mode, "constant cutting speed off, feed mode kept"),
    outside("G973", Group::feed_mode, "constant cutting speed off, no limit of the speed"),
    // Names.
    outside("ACC", Group::once, "acceleration of an axis"),
    outside("AMIRROR", Group::once, "mirroring, added"),
    outside("ANG", Group::once, "angle of a straight line"),
    outside("AROT", Group::once, "rotation, added"),
    outside("ASCALE", Group::once, "scaling, added"),
    outside("ASPLINE", Group::once, "Akima spline"),
    outside("ATRANS", Group::once, "translation, added"),
    outside("B", Group::once, "axis that the gauge does not have"),
    no_effect("BRISK", Group::once, "acceleration by steps"),
    outside("BSPLINE", Group::once, "B spline"),
    no_effect("CFC", Group::once, "constant feed at the contour"),
    no_effect("CFIN", Group::once, "constant feed at inner radii"),
    no_effect("CFTCP", Group::once, "constant feed of the tool's centre"),
    outside("CHF", Group::once, "chamfer by its length"),
    outside("CHR", Group::once, "chamfer by its width"),
    kThroughPoint.named("CIP", "circle through an intermediate point"),
    outside("COMPCAD", Group::once, "compressor"),
    outside("COMPCURV", Group::once, "compressor"),
    no_effect("COMPOF", Group::once, "compressor off"),
    outside("COMPON", Group::once, "compressor"),
    outside("CSPLINE", Group::once, "cubic spline"),
    kTangent.named("CT", "tangent circle"),
    outside("CYCLE<n>", Group::once, "cycle"),
    outside("DIAM90", Group::once, "diameters under G90"),
    no_effect("DIAMOF", Group::once, "radius programming"),
    outside("DIAMON", Group::once, "diameter programming"),
    no_effect("DRIVE", Group::once, "acceleration of the drives"),
    outside("E", Group::once, "axis that the gauge does not have"),
    outside("FB", Group::once, "feed of the block"),
    no_effect("FFWOF", Group::once, "feedforward control off"),
    no_effect("FFWON", Group::once, "feedforward control on"),
    outside("FGROUP", Group::once, "axes that the feed holds for"),
    outside("FL", Group::once, "limit of an axis' feed"),
    outside("FRC", Group::once, "feed of chamfers and roundings"),
    outside("FRCM", Group::once, "feed of chamfers and roundings, modal"),
    outside("FXS", Group::once, "travel to a fixed stop"),
    outside("HOLES1", Group::once, "row of holes"),
    outside("HOLES2", Group::once, "circle of holes"),
    outside("INIT", Group::once, "selection of a program of another channel"),
    outside("INVCCW", Group::once, "involute counterclockwise"),
    outside("INVCW", Group::once, "involute clockwise"),
    no_effect("KONT", Group::once, "approach round the contour"),
    outside("L", Group::once, "subprogram"),
    outside("LCYC60", Group::once, "row of holes"),
    outside("LCYC61", Group::once, "circle of holes"),
    kLcyc75.named("LCYC75", "milling of a pocket, a slot or a circle"),
    kLcyc82.named("LCYC82", "drilling"),
    outside("LCYC83", Group::once, "deep drilling"),
    outside("LCYC84", Group::once, "rigid tapping"),
    outside("LCYC840", Group::once, "tapping with a compensating chuck"),
    outside("LCYC85", Group::once, "boring"),
    outside("LCYC93", Group::once, "groove"),
    outside("LCYC94", Group::once, "undercut"),
    outside("LCYC95", Group::once, "stock removal"),
    outside("LCYC96", Group::once, "thread undercut"),
    outside("LCYC97", Group::once, "thread cutting"),
    no_effect("LIMS", Group::once, "limit of the spindle speed"),
    outside("LONGHOLE", Group::once, "slots on a circle, of the tool's width"),
    outside("MIRROR", Group::once, "mirroring"),
    no_effect("MSG", Group::once, "message"),
    no_effect("NORM", Group::once, "approach along a normal"),
    outside("O", Group::once, "address that the gauge does not have"),
    outside("OFFN", Group::once, "allowance on the contour"),
    outside("OVR", Group::once, "override"),
    outside("P", Group::once, "passes of a subprogram"),
    outside("POCKET1", Group::once, "rectangular pocket"),
    outside("POCKET2", Group::once, "circular pocket"),
    outside("POCKET3", Group::once, "rectangular pocket"),
    outside("POCKET4", Group::once, "circular pocket"),
    outside("POLY", Group::once, "polynomial"),
    outside("PUTFTOC", Group::once, "tool correction while moving"),
    outside("Q", Group::once, "axis that the gauge does not have"),
    outside("RND", Group::once, "rounding"),
    outside("RNDM", Group::once, "rounding, modal"),
    outside("ROT", Group::once, "rotation"),
    outside("ROTS", Group::once, "rotation by angles in space"),
    outside("RPL", Group::once, "angle of a rotation"),
    outside("SCALE", Group::once, "scaling"),
    outside("SETAL", Group::once, "alarm set by the program"),
    outside("SLOT1", Group::once, "slots on a circle"),
    outside("SLOT2", Group::once, "slots along a circle"),
    no_effect("SOFT", Group::once, "acceleration without jerks"),
    no_effect("SPCOF", Group::once, "position control of the spindle off"),
    no_effect("SPCON", Group::once, "position control of the spindle on"),
    no_effect("SPOS", Group::once, "position of the spindle"),
    no_effect("SPOSA", Group::once, "position of the spindle, while blocks run on"),
    outside("START", Group::once, "start of a program of another channel"),
    no_effect("STOPRE", Group::once, "stop of the block preparation"),
    outside("SUPA", Group::once, "all offsets off in the block"),
    outside("TRACYL", Group::once, "transformation of a cylinder's surface"),
    outside("TRAFOOF", Group::once, "transformation off"),
    outside("TRANS", Group::once, "translation"),
    outside("TRANSMIT", Group::once, "transformation of a face"),
    outside("TRAORI", Group::once, "transformation of the tool's orientation"),
    outside("U", Group::once, "axis that the gauge does not have"),
    outside("V", Group::once, "axis that the gauge does not have"),
    outside("W", Group::once, "axis that the gauge does not have"),
    outside("WAITM", Group::once, "waiting for another channel"),
    no_effect("WAITS", Group::once, "waiting for the spindle's position"),
    outside("WORKPIECE", Group::once, "blank of the simulation"),
    outside("address <n>", Group::once, "address with a number, whose meaning is the machine's"),
    outside("axis <n>", Group::once, "axis by its number"),
    outside("name <n>", Group::once,
            "name of a subprogram, of a variable, or of a code that the list lacks"),
    outside("spindle <n>", Group::once, "word of a spindle by its number"),
    // M functions.
    m_function("M0", Kind::stop, Group::program, "stop"),
    m_function("M1", Kind::stop, Group::program, "optional stop"),
    m_function("M2", Kind::program_end, Group::program, "end of the program"),
    m_function("M3", Kind::machine, Group::spindle, "spindle clockwise"),
    m_function("M4", Kind::machine, Group::spindle, "spindle counterclockwise"),
    m_function("M5", Kind::machine, Group::spindle, "spindle stop"),
    m_function("M6", Kind::machine, Group::tool, "tool change"),
    m_function("M17", Kind::program_end, Group::program, "end of the program"),
    m_function("M30", Kind::program_end, Group::program, "end of the program"),
});

inline constexpr auto kEverywhere = std::to_array<CodeWord>({
    {"F", feed, "feed", Life::modal},
    {"M", number, "M function"},
    {"S", speed, "spindle speed", Life::modal},
    {"T", number, "tool", Life::modal},
    {"D", number, "edge of the tool", Life::modal},
    {"H", number, "auxiliary function"},
    {"H<n>", number, "auxiliary function"},
    {"R<n>", parameter, "R parameter", Life::modal, "expressions"},
});

inline constexpr auto kPathFeatures = std::to_array<DialectFeature>({
    {"basic", "G0, G1, G4, planes, units, G90, G91, AC and IC, G94 and G95, M functions and S"},
    {"arc", "G2 and G3 by their centre in the plane in force"},
    {"cr", "G2 and G3 by CR="},
    {"ar", "G2 and G3 by AR="},
    {"polar", "AP=, RP= and the poles G110, G111, G112"},
    {"planes", "G2 and G3 in G18, G19 and the plane that end points choose"},
    {"helix", "G2 and G3 with the third axis and TURN="},
    {"cip", "CIP, the circle through an intermediate point"},
    {"ct", "CT, the tangent circle"},
    {"expressions", "R parameters, calculations and functions"},
    {"rotary", "the rotary axes A and C"},
});
inline constexpr auto kOwnOf802s = std::to_array<DialectFeature>({
    {"frames", "G158, G258 and G259"},
    {"lcyc82", "the drilling cycle LCYC82"},
    {"lcyc75", "the pocket milling cycle LCYC75"},
});
inline constexpr auto kFeatures802s = [] {
  std::array<DialectFeature, kPathFeatures.size() + kOwnOf802s.size()> all{};
  std::ranges::copy(kOwnOf802s, std::ranges::copy(kPathFeatures, all.begin()).out);
  return all;
}();

// G22 and G23 are the 802S's own.
constexpr bool is_of_840d(const Code& code) {
  if (code.name == "G22" || code.name == "G23") return false;
  if (code.kind == Kind::cycle) return true;
  return std::ranges::find(kPathFeatures, code.feature, &DialectFeature::name) !=
         kPathFeatures.end();
}
// SIE-MOD-07: the 802S has G96 and G97 alone.
constexpr bool is_speed_mode(const Code& code) {
  return code.name == "G961" || code.name == "G971";
}
inline constexpr auto kCodes840d = [] {
  std::array<Code, static_cast<std::size_t>(std::ranges::count_if(kCodes, is_of_840d))> some{};
  std::ranges::copy_if(kCodes, some.begin(), is_of_840d);
  for (Code& code : some) {
    // SIE-MOD-02: nothing that is read moves its zero.
    if (code.name == "SUPA") code.treatment = Treatment::without_effect;
    if (is_speed_mode(code)) code = sets(code.name, code.group, Setting::none, code.title);
    // SIE-MOD-02: its cycles LCYC75 and LCYC82 are read no further than LCYC60 to LCYC97.
    if (code.kind == Kind::cycle) code = outside(code.name, code.group, code.title);
  }
  return some;
}();

inline constexpr auto kHolding = std::to_array<HoldingRule>({
    {Holds::motion, "", Group::motion, "SIE-MOD-01"_clause},
    {Holds::mode, "", Group::units, "SIE-MOD-04"_clause},
});

}  // namespace table

inline constexpr Descriptor kDescriptor840d = {
    table::kPathFeatures, table::kCodes840d, table::kEverywhere, table::kAnyBlock, table::kHolding};
inline constexpr Descriptor kDescriptor802s = {
    table::kFeatures802s, table::kCodes, table::kEverywhere, table::kAnyBlock, table::kHolding};

}  // namespace gonogo::reference::sinumerik
