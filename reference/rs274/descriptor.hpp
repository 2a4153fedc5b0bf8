// SPDX-License-Identifier: GPL-3.0-or-later
//
// The codes and words of RS274/NGC. M functions exclude each other by the language's groups.
#pragma once

#include "reference/clause_literal.hpp"
#include "reference/descriptor.hpp"

namespace gonogo::reference::rs274 {
namespace table {

using enum Role;

inline constexpr auto kEnds = std::to_array<CodeWord>({
    {"X", place, "end point"},
    {"Y", place, "end point"},
    {"Z", place, "end point"},
    {"A", place, "end point, degrees", Life::block, "rotary"},
    {"C", place, "end point, degrees", Life::block, "rotary"},
});
// NGC-POL-01
inline constexpr auto kPolar = std::to_array<CodeWord>({
    {"@", polar_radius, "distance of the end from the origin in X and Y", Life::block,
     "polar-words"},
    {"^", polar_angle, "angle of the end about the origin, degrees from +X toward +Y", Life::block,
     "polar-words"},
});
inline constexpr auto kArc = std::to_array<CodeWord>({
    {"I", centre, "centre along X, from the start or under G90.1 absolute"},
    {"J", centre, "centre along Y"},
    {"K", centre, "centre along Z"},
    {"R", radius, "radius; below zero of an arc of more than half a turn", Life::block, "arc-r"},
    {"P", turns, "number of turns that are begun", Life::block, "turns"},
    {"X Y Z", place, "end point of a helix", Life::block, "helix"},
});
// The place of a hole and its bottom; the numbers of a cycle stay in force (NGC-CYC-03).
inline constexpr auto kHole = std::to_array<CodeWord>({
    {"X", place, "place of the hole, or its bottom along the third axis", Life::modal},
    {"Y", place, "place of the hole, or its bottom along the third axis", Life::modal},
    {"Z", place, "place of the hole, or its bottom along the third axis", Life::modal},
    {"R", along_d, "R level, under G91 the way to it", Life::modal},
    {"L", count, "number of holes", Life::block, "cycle-steps"},
});
inline constexpr auto kPecks = std::to_array<CodeWord>({
    {"Q", step, "depth of a peck", Life::modal},
    {"D", size, "clearance above the last peck, under ngc.peck.d = clearance"},
});
inline constexpr auto kHoleDwell = std::to_array<CodeWord>({
    {"P", time, "dwell at the bottom, s", Life::modal},
});
inline constexpr auto kThreadEnd = std::to_array<CodeWord>({
    {"X", place, "end point"},
    {"Y", place, "end point"},
    {"Z", place, "end point"},
    {"K", lead, "lead along the motion"},
});
inline constexpr auto kThreading = std::to_array<CodeWord>({
    {"Z", place, "end of the thread"},
    {"P", lead, "lead"},
    {"I", along_q, "way from the drive line to the peak; below zero outside"},
    {"J", size, "depth of the first pass"},
    {"K", size, "depth of the thread"},
    {"R", number, "degression of the depths"},
    {"Q", angle, "slide angle"},
    {"H", count, "number of spring passes"},
    {"E", size, "length of the taper"},
    {"L", number, "ends that have the taper"},
});
inline constexpr auto kDwell = std::to_array<CodeWord>({
    {"P", time, "dwell, s"},
});
inline constexpr auto kBlending = std::to_array<CodeWord>({
    {"P", size, "tolerance of the path", Life::block, "linuxcnc"},
    {"Q", size, "tolerance of joined lines", Life::block, "linuxcnc"},
});
inline constexpr auto kSwitch = std::to_array<CodeWord>({
    {"P", number, "switch or output"},
});
inline constexpr auto kInput = std::to_array<CodeWord>({
    {"P", number, "digital input"},
    {"E", number, "analogue input"},
    {"L", number, "what is waited for"},
    {"Q", time, "longest wait"},
});
inline constexpr auto kAnalogue = std::to_array<CodeWord>({
    {"E", number, "analogue output"},
    {"Q", number, "value"},
});
inline constexpr auto kToolNumber = std::to_array<CodeWord>({
    {"Q", number, "tool"},
});

inline constexpr auto kSurfaceSpeed = std::to_array<CodeWord>({
    {"D", speed, "highest speed of the spindle"},
});
inline constexpr auto kSubprogram = std::to_array<CodeWord>({
    {"P", number, "subprogram"},
    {"L", count, "how often it runs"},
});

inline constexpr auto kOrigin = std::to_array<CodeWord>({
    {"X", number, "coordinate, or way of an origin"},
    {"Y", number, "coordinate, or way of an origin"},
    {"Z", number, "coordinate, or way of an origin"},
    {"A", number, "coordinate, or way of an origin, degrees", Life::block, "rotary"},
    {"C", number, "coordinate, or way of an origin, degrees", Life::block, "rotary"},
});
inline constexpr auto kSystem = std::to_array<CodeWord>({
    {"L", number, "2, 20: a coordinate system; 1, 10, 11: a tool of the table"},
    {"P", number, "coordinate system, 0 the one in force; or a tool"},
    {"R", number, "rotation in X and Y, degrees, of L2; radius of a tool", Life::block,
     "local-offsets"},
    {"I", number, "front angle of a tool", Life::block, "local-offsets"},
    {"J", number, "back angle of a tool", Life::block, "local-offsets"},
    {"Q", number, "orientation of a tool", Life::block, "local-offsets"},
});
inline constexpr auto kToolLength = std::to_array<CodeWord>({
    {"H", number, "tool"},
});

inline constexpr auto kReturn = std::to_array<IgnoredWords>({
    {"", "I", "NGC-G331-03"_clause,
     "it multiplies the speed of the spindle on the way back, which no record has"},
});
inline constexpr auto kNoTaper = std::to_array<IgnoredWords>({
    {"without L", "E", "NGC-G76-09"_clause, "no end of the thread has the taper"},
    {"without E", "L", "NGC-G76-09"_clause, "a taper without length is none"},
});
// Any other word that its block does not use is an alarm (NGC-COM-02).
inline constexpr auto kAnyBlock = std::to_array<IgnoredWords>({
    {"", "S T", "NGC-COM-01"_clause, "the spindle and the tool do not shape the path"},
});

// What a program needs beside the feature of its code.
inline constexpr auto kArcUse = std::to_array<UseFeature>({
    {Use::outside_xy, "planes"},
});
inline constexpr auto kHoleUse = std::to_array<UseFeature>({
    {Use::repeated, "cycle-modal"},
    {Use::incremental, "cycle-steps"},
    {Use::outside_xy, "cycle-planes"},
});

inline constexpr ClauseId kLines = "NGC-G0-01"_clause;
inline constexpr Code kTraverse =
    does(Kind::traverse, Group::motion, kLines, "basic", {kEnds, kPolar});
inline constexpr Code kFeed = does(Kind::line, Group::motion, kLines, "basic", {kEnds, kPolar});
inline constexpr Code kRound =
    does(Kind::arc, Group::motion, "NGC-ARC-01"_clause, "arc", {kEnds, kPolar, kArc}).used(kArcUse);
inline constexpr Code kPause =
    does(Kind::dwell, Group::once, "NGC-G4-01"_clause, "basic", {kDwell});

inline constexpr Code kHome =
    does(Kind::reference_point, Group::once, "NGC-OFS-11"_clause, "offsets", {kEnds});
inline constexpr Code kHomeSetting =
    does(Kind::reference_point, Group::once, "NGC-OFS-12"_clause, "offsets", {});
inline constexpr Code kShiftSwitch =
    does(Kind::rename, Group::once, "NGC-OFS-06"_clause, "offsets", {});
inline constexpr Code kSystemOf = sets("", Group::offset, Setting::none, "").needing("offsets");

constexpr Code drills(std::string_view name, std::string_view title, ClauseId clause,
                      std::string_view feature, const WordLists& words) {
  return does(Kind::cycle, Group::motion, clause, feature, words).used(kHoleUse).named(name, title);
}
inline constexpr WordLists kPlain = {kHole, kPolar};
inline constexpr WordLists kDwelling = {kHole, kPolar, kHoleDwell};
inline constexpr WordLists kPecking = {kHole, kPolar, kPecks};

constexpr Code of_linuxcnc(std::string_view name, Group group, std::string_view title,
                           const WordLists& words = {}) {
  return m_function(name, Kind::machine, group, title, words).needing("linuxcnc");
}
inline constexpr Code kOff =
    does(Kind::off, Group::motion, "NGC-MOD-01"_clause, "basic", {}).initial();

inline constexpr auto kCodes = std::to_array<Code>({
    kTraverse.named("G0", "traverse"),
    kFeed.named("G1", "straight feed"),
    kRound.named("G2", "arc clockwise", -1),
    kRound.named("G3", "arc counterclockwise", +1),
    kPause.named("G4", "dwell"),
    outside("G5", Group::motion, "cubic spline"),
    outside("G5.1", Group::motion, "quadratic spline"),
    outside("G5.2", Group::motion, "spline of control points"),
    outside("G5.3", Group::motion, "end of the spline"),
    sets("G7", Group::diameter, Setting::diameter, "diameter programming").needing("linuxcnc"),
    sets("G8", Group::diameter, Setting::radius, "radius programming")
        .needing("linuxcnc")
        .initial(),
    does(Kind::rename, Group::once, "NGC-OFS-03"_clause, "offsets", {kOrigin, kSystem})
        .named("G10", "setting of a coordinate system"),
    sets("G17", Group::plane, Setting::plane_xy, "plane XY"),
    outside("G17.1", Group::plane, "plane UV"),
    sets("G18", Group::plane, Setting::plane_zx, "plane ZX"),
    outside("G18.1", Group::plane, "plane WU"),
    sets("G19", Group::plane, Setting::plane_yz, "plane YZ"),
    outside("G19.1", Group::plane, "plane VW"),
    sets("G20", Group::units, Setting::inch, "inch"),
    sets("G21", Group::units, Setting::metric, "metric"),
    kHome.named("G28", "return to the first reference point"),
    kHomeSetting.named("G28.1", "setting of the first reference point"),
    kHome.named("G30", "return to the second reference point"),
    kHomeSetting.named("G30.1", "setting of the second reference point"),
    does(Kind::thread, Group::motion, "NGC-G33-01"_clause, "g33", {kThreadEnd})
        .named("G33", "spindle-synchronous motion"),
    does(Kind::cycle, Group::motion, "NGC-G331-01"_clause, "g33.1", {kThreadEnd})
        .passing(kReturn)
        .passing_m()
        .named("G33.1", "rigid tapping"),
    outside("G38.2", Group::motion, "probing towards the part, with an error"),
    outside("G38.3", Group::motion, "probing towards the part"),
    outside("G38.4", Group::motion, "probing away from the part, with an error"),
    outside("G38.5", Group::motion, "probing away from the part"),
    no_effect("G40", Group::compensation, "radius compensation off").initial(),
    outside("G41", Group::compensation, "radius compensation left"),
    outside("G41.1", Group::compensation, "dynamic radius compensation left"),
    outside("G42", Group::compensation, "radius compensation right"),
    outside("G42.1", Group::compensation, "dynamic radius compensation right"),
    sets("G43", Group::tool_length, Setting::none, "tool length offset")
        .with({kToolLength})
        .needing("offsets"),
    does(Kind::rename, Group::tool_length, "NGC-OFS-09"_clause, "offsets", {kOrigin})
        .named("G43.1", "dynamic tool length offset"),
    does(Kind::rename, Group::tool_length, "NGC-OFS-19"_clause, "local-offsets",
         {kOrigin, kToolLength})
        .named("G43.2", "additional tool length offset"),
    sets("G49", Group::tool_length, Setting::none, "tool length offset off").initial(),
    outside("G50", Group::scaling, "scaling off"),
    outside("G51", Group::scaling, "scaling"),
    does(Kind::rename, Group::once, "NGC-OFS-18"_clause, "local-offsets", {kOrigin})
        .named("G52", "local coordinate system"),
    sets("G53", Group::once, Setting::none, "machine coordinates").needing("offsets"),
    sets("G54", Group::offset, Setting::none, "coordinate system 1").initial(),
    kSystemOf.named("G55", "coordinate system 2"),
    kSystemOf.named("G56", "coordinate system 3"),
    kSystemOf.named("G57", "coordinate system 4"),
    kSystemOf.named("G58", "coordinate system 5"),
    kSystemOf.named("G59", "coordinate system 6"),
    kSystemOf.named("G59.1", "coordinate system 7"),
    kSystemOf.named("G59.2", "coordinate system 8"),
    kSystemOf.named("G59.3", "coordinate system 9"),
    no_effect("G61", Group::path_mode, "exact path"),
    no_effect("G61.1", Group::path_mode, "exact stop").needing("linuxcnc"),
    no_effect("G64", Group::path_mode, "continuous path").with({kBlending}),
    outside("G70", Group::motion, "lathe finishing"),
    outside("G71", Group::motion, "lathe roughing along Z"),
    outside("G71.1", Group::motion, "lathe roughing along Z"),
    outside("G71.2", Group::motion, "lathe roughing along Z"),
    outside("G72", Group::motion, "lathe roughing along X"),
    outside("G72.1", Group::motion, "lathe roughing along X"),
    outside("G72.2", Group::motion, "lathe roughing along X"),
    drills("G73", "drilling with chip breaking", "NGC-G73-01"_clause, "g73", kPecking),
    drills("G74", "left-hand tapping", "NGC-G84-02"_clause, "g74", kDwelling).passing_m(),
    does(Kind::cycle, Group::motion, "NGC-G76-01"_clause, "g76", {kThreading})
        .passing(kNoTaper)
        .named("G76", "compound threading"),
    kOff.named("G80", "no motion"),
    drills("G81", "drilling", "NGC-G81-01"_clause, "g81", kPlain),
    drills("G82", "drilling with a dwell", "NGC-G82-01"_clause, "g81", kDwelling),
    drills("G83", "deep drilling", "NGC-G83-01"_clause, "g83", kPecking),
    drills("G84", "right-hand tapping", "NGC-G84-02"_clause, "g84", kDwelling).passing_m(),
    drills("G85", "boring, feed out", "NGC-G85-01"_clause, "g85", kPlain),
    drills("G86", "boring, spindle stop, traverse out", "NGC-G86-02"_clause, "g86", kDwelling)
        .passing_m(),
    outside("G87", Group::motion, "back boring"),
    outside("G88", Group::motion, "boring, spindle stop, out by hand"),
    drills("G89", "boring with a dwell, feed out", "NGC-G89-01"_clause, "g85", kDwelling),
    sets("G90", Group::distance, Setting::absolute, "absolute").initial(),
    sets("G90.1", Group::arc_distance, Setting::absolute_centre, "absolute centres")
        .needing("arc-distance"),
    sets("G91", Group::distance, Setting::incremental, "incremental"),
    sets("G91.1", Group::arc_distance, Setting::incremental_centre, "incremental centres")
        .needing("arc-distance")
        .initial(),
    does(Kind::rename, Group::once, "NGC-OFS-05"_clause, "offsets", {kOrigin})
        .named("G92", "offset of the coordinate systems"),
    kShiftSwitch.named("G92.1", "offset cancelled and cleared"),
    kShiftSwitch.named("G92.2", "offset cancelled"),
    kShiftSwitch.named("G92.3", "offset restored"),
    sets("G93", Group::feed_mode, Setting::inverse_time, "inverse time feed").needing("feed-modes"),
    sets("G94", Group::feed_mode, Setting::none, "feed per minute").initial(),
    sets("G95", Group::feed_mode, Setting::none, "feed per revolution").needing("feed-modes"),
    sets("G96", Group::speed, Setting::none, "constant surface speed")
        .with({kSurfaceSpeed})
        .needing("linuxcnc"),
    sets("G97", Group::speed, Setting::none, "constant spindle speed")
        .needing("linuxcnc")
        .initial(),
    sets("G98", Group::retract, Setting::none, "return to the initial level"),
    sets("G99", Group::retract, Setting::none, "return to the R level"),
    m_function("M0", Kind::stop, Group::program, "stop"),
    m_function("M1", Kind::stop, Group::program, "optional stop"),
    m_function("M2", Kind::program_end, Group::program, "end of the program"),
    m_function("M3", Kind::machine, Group::spindle, "spindle clockwise"),
    m_function("M4", Kind::machine, Group::spindle, "spindle counterclockwise"),
    m_function("M5", Kind::machine, Group::spindle, "spindle stop"),
    m_function("M6", Kind::machine, Group::tool, "tool change"),
    m_function("M7", Kind::machine, Group::coolant, "mist on"),
    m_function("M8", Kind::machine, Group::coolant, "flood on"),
    m_function("M9", Kind::machine, Group::coolant, "coolant off"),
    outside("M19", Group::spindle, "spindle orientation"),
    m_function("M30", Kind::program_end, Group::program, "end of the program"),
    m_function("M48", Kind::machine, Group::override_switches, "overrides on"),
    m_function("M49", Kind::machine, Group::override_switches, "overrides off"),
    of_linuxcnc("M50", Group::override_switches, "feed override", {kSwitch}),
    of_linuxcnc("M51", Group::override_switches, "spindle override", {kSwitch}),
    of_linuxcnc("M52", Group::override_switches, "adaptive feed", {kSwitch}),
    of_linuxcnc("M53", Group::override_switches, "feed stop", {kSwitch}),
    m_function("M60", Kind::stop, Group::program, "stop for a pallet change"),
    of_linuxcnc("M61", Group::tool, "number of the tool", {kToolNumber}),
    of_linuxcnc("M62", Group::signals, "output on, with motion", {kSwitch}),
    of_linuxcnc("M63", Group::signals, "output off, with motion", {kSwitch}),
    of_linuxcnc("M64", Group::signals, "output on", {kSwitch}),
    of_linuxcnc("M65", Group::signals, "output off", {kSwitch}),
    of_linuxcnc("M66", Group::signals, "wait for an input", {kInput}),
    of_linuxcnc("M67", Group::signals, "analogue output, with motion", {kAnalogue}),
    of_linuxcnc("M68", Group::signals, "analogue output", {kAnalogue}),
    of_linuxcnc("M70", Group::saved_modes, "modes saved"),
    of_linuxcnc("M71", Group::saved_modes, "saved modes forgotten"),
    of_linuxcnc("M72", Group::saved_modes, "modes restored"),
    of_linuxcnc("M73", Group::saved_modes, "modes saved, and restored after the subroutine"),
    m_function("M98", Kind::stop, Group::program, "call of a subprogram", {kSubprogram})
        .needing("subprograms"),
    m_function("M99", Kind::stop, Group::program, "end of a subprogram").needing("subprograms"),
    outside("M100", Group::once, "program of the user").to("M199"),
});

inline constexpr auto kEverywhere = std::to_array<CodeWord>({
    {"F", feed, "feed", Life::modal},
    {"M", number, "M function"},
    {"S", speed, "spindle speed", Life::modal},
    {"T", number, "tool", Life::modal},
});

inline constexpr auto kFeatures = std::to_array<DialectFeature>({
    {"basic", "G0, G1, G4, G80, units, G90 and G91"},
    {"arc", "G2 and G3 by their centre in G17"},
    {"arc-r", "G2 and G3 by their radius"},
    {"planes", "G2 and G3 in G18 and G19"},
    {"helix", "G2 and G3 with the third axis"},
    {"arc-distance", "G90.1 and G91.1"},
    {"turns", "G2 and G3 with P turns"},
    {"g81", "the drilling cycles G81 and G82, with G98 and G99"},
    {"g73", "drilling with chip breaking G73"},
    {"g83", "deep drilling G83"},
    {"g84", "right-hand tapping G84 with a floating chuck"},
    {"g74", "left-hand tapping G74 with a floating chuck"},
    {"g85", "the boring cycles G85 and G89, out at the feed"},
    {"g86", "boring G86 with a spindle stop"},
    {"cycle-modal", "canned cycles that are repeated by axis words alone"},
    {"cycle-steps", "canned cycles under G91, and L"},
    {"cycle-planes", "canned cycles in G18 and G19"},
    {"g33", "motion in step with the spindle G33"},
    {"g33.1", "rigid tapping G33.1"},
    {"g76", "the threading cycle G76"},
    {"offsets", "work offsets, G92, tool lengths, reference points and machine coordinates"},
    {"parameters", "parameters, their settings, expressions and functions", true},
    {"o-words", "subroutines, conditions and loops of the program's own", true},
    {"rotary", "the rotary axes A and C"},
    {"polar-words", "@ and ^, points by their distance and angle"},
    {"feed-modes", "G93 and G95, feed as inverse time and per revolution"},
    {"local-offsets", "G52, G43.2, tools that G10 describes, and turned coordinate systems"},
    {"subprograms", "M98 and M99"},
    {"linuxcnc",
     "what only LinuxCNC has: G7, G8, G61.1, G96, G97, G64 P Q, M50 to M53, M61 to M73, `;`, "
     "(abort,"},
    {"lines", "the form of lines, words that nothing uses, and the end of a program, as documented",
     true},
});

inline constexpr auto kHolding = std::to_array<HoldingRule>({
    {Holds::words, "", Group::motion, "NGC-CYC-03"_clause},
    {Holds::motion, "", Group::motion, "NGC-MOD-01"_clause},
    {Holds::mode, "", Group::distance, "NGC-DIS-01"_clause},
    {Holds::mode, "", Group::arc_distance, "NGC-DIS-01"_clause},
    {Holds::mode, "", Group::units, "NGC-UNI-01"_clause},
});

}  // namespace table

inline constexpr Descriptor kDescriptor = {table::kFeatures, table::kCodes, table::kEverywhere,
                                           table::kAnyBlock, table::kHolding};

}  // namespace gonogo::reference::rs274
