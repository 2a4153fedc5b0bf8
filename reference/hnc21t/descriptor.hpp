// SPDX-License-Identifier: GPL-3.0-or-later
//
// The codes and words of the HNC-21T lathe.
#pragma once

#include "reference/clause_literal.hpp"
#include "reference/descriptor.hpp"

namespace gonogo::reference::hnc21t {
namespace table {

using enum Role;

inline constexpr auto kEnds = std::to_array<CodeWord>({
    {"X", place, "end point, a diameter under G36"},
    {"Z", place, "end point"},
    {"U", way, "way along X"},
    {"W", way, "way along Z"},
});

inline constexpr auto kArc = std::to_array<CodeWord>({
    {"R", radius, "radius of the arc"},
    {"I", centre, "centre from the start along X"},
    {"K", centre, "centre from the start along Z"},
});
inline constexpr auto kDwell = std::to_array<CodeWord>({
    {"P", time, "dwell, ms"},
});

// HNC-MOD-01: the words of a cycle, but not its end point, are modal.
// The lead goes with every thread, the run-out and the starts with G82 alone.
inline constexpr auto kLead = std::to_array<CodeWord>({
    {"F", lead, "lead, mm", Life::modal},
    {"J", lead, "lead of an inch thread", Life::modal},
});
inline constexpr auto kOfThreads = std::to_array<CodeWord>({
    {"R", along_p, "run-out along Z", Life::modal},
    {"E", along_q, "run-out along X", Life::modal},
    {"P", angle, "start angle", Life::modal},
    {"C", count, "number of starts", Life::modal},
    {"Q", number, "constant of the run-out", Life::modal},
});
inline constexpr auto kPlainThread = std::to_array<CodeWord>({
    {"I", along_q, "taper"},
    {"K", along_p, "taper"},
});

inline constexpr auto kHole = std::to_array<CodeWord>({
    {"Z", place, "bottom of the hole"},
    {"W", way, "way to the bottom"},
});
inline constexpr auto kPecks = std::to_array<CodeWord>({
    {"R", size, "withdrawal of a peck", Life::modal},
    {"Q", step, "depth of a peck", Life::modal},
});
inline constexpr auto kGrooves = std::to_array<CodeWord>({
    {"I", count, "number of steps along Z", Life::modal},
    {"P", count, "number of steps along Z", Life::modal},
});
inline constexpr auto kTaperI = std::to_array<CodeWord>({
    {"I", along_q, "taper: radius of B less that of C", Life::modal},
});
inline constexpr auto kTaperK = std::to_array<CodeWord>({
    {"K", along_p, "taper: Z of B less that of C", Life::modal},
});

inline constexpr auto kAnyBlock = std::to_array<IgnoredWords>({
    {"", "S T", "HNC-COM-01"_clause, "the spindle and the tool do not shape the path"},
});
inline constexpr auto kBesideR = std::to_array<IgnoredWords>({
    {"beside R", "I K", "HNC-COM-01"_clause, "the radius goes before the centre"},
});
inline constexpr auto kNoRunOut = std::to_array<IgnoredWords>({
    {"of 0", "R E P C Q K I", "HNC-WRD-01"_clause,
     "a run-out, a start angle or a number of starts of zero asks for none"},
});
inline constexpr IgnoredWords kOfCycles = {
    "", "I K R E C A P J Q", "HNC-COM-07"_clause,
    "a word of the group of cycles that this cycle does not use is taken in without effect"};
inline constexpr IgnoredWords kUnwithdrawn = {
    "without R", "Q", "HNC-G74-01"_clause,
    "the depth of a peck is checked; without a withdrawal there are no pecks"};
inline constexpr std::array<IgnoredWords, 1> kCutting = {kOfCycles};
inline constexpr auto kDrilling = std::to_array<IgnoredWords>({
    kUnwithdrawn,
    {"", "X U", "HNC-G74-04"_clause, "drilling goes along Z alone, or as hnc.g74.x says"},
    kOfCycles,
});
inline constexpr auto kGrooving = std::to_array<IgnoredWords>({
    kUnwithdrawn,
    {"where it is not the count", "I P", kOfCycles.clause, kOfCycles.why},
    kOfCycles,
});
inline constexpr auto kThreading = std::to_array<IgnoredWords>({
    {"but for its sign", "Q", "HNC-G82-05"_clause, "it has no effect on the geometry"},
    kOfCycles,
});

inline constexpr ClauseId kBasic = "HNC-COM-01"_clause;
inline constexpr Code kTraverse = does(Kind::traverse, Group::motion, kBasic, "basic", {kEnds});
inline constexpr Code kFeed = does(Kind::line, Group::motion, kBasic, "basic", {kEnds});
inline constexpr Code kRound =
    does(Kind::arc, Group::motion, kBasic, "arc", {kEnds, kArc}).passing(kBesideR);
inline constexpr Code kPause = does(Kind::dwell, Group::once, kBasic, "basic", {kDwell});
inline constexpr Code kRename = does(Kind::rename, Group::once, kBasic, "basic", {kEnds});
inline constexpr Code kG32 =
    does(Kind::thread, Group::motion, kBasic, "g32", {kEnds, kLead, kOfThreads, kPlainThread})
        .passing(kNoRunOut);
inline constexpr Code kG74 =
    does(Kind::cycle, Group::motion, "HNC-G74-01"_clause, "g74", {kHole, kPecks})
        .passing(kDrilling);
inline constexpr Code kG75 =
    does(Kind::cycle, Group::motion, "HNC-G75-01"_clause, "g75", {kEnds, kPecks, kGrooves})
        .passing(kGrooving);
inline constexpr Code kG80 =
    does(Kind::cycle, Group::motion, "HNC-G80-01"_clause, "g80", {kEnds, kTaperI})
        .passing(kCutting);
inline constexpr Code kG81 =
    does(Kind::cycle, Group::motion, "HNC-G81-01"_clause, "g81", {kEnds, kTaperK})
        .passing(kCutting);
inline constexpr Code kG82 = does(Kind::cycle, Group::motion, "HNC-G82-01"_clause, "g82",
                                  {kEnds, kTaperI, kLead, kOfThreads})
                                 .passing(kThreading);

inline constexpr auto kCodes = std::to_array<Code>({
    kTraverse.named("G0", "positioning"),
    kFeed.named("G1", "straight feed"),
    kRound.named("G2", "arc clockwise", -1),
    kRound.named("G3", "arc counterclockwise", +1),
    kPause.named("G4", "dwell"),
    sets("G17", Group::plane, Setting::plane_xy, "plane XY"),
    no_effect("G18", Group::plane, "plane ZX").putting(Setting::plane_zx),
    sets("G19", Group::plane, Setting::plane_yz, "plane YZ"),
    sets("G20", Group::units, Setting::inch, "inch"),
    sets("G21", Group::units, Setting::metric, "metric"),
    outside("G28", Group::once, "return to the reference point"),
    outside("G29", Group::once, "return from the reference point"),
    kG32.named("G32", "thread cutting"),
    sets("G36", Group::diameter, Setting::diameter, "diameter programming"),
    sets("G37", Group::diameter, Setting::radius, "radius programming"),
    no_effect("G40", Group::compensation, "radius compensation off").initial(),
    outside("G41", Group::compensation, "radius compensation left"),
    outside("G42", Group::compensation, "radius compensation right"),
    outside("G46", Group::speed, "limits of the spindle speed"),
    outside("G52", Group::once, "local coordinate system"),
    outside("G53", Group::once, "machine coordinates"),
    sets("G54", Group::offset, Setting::none, "work offset 1"),
    sets("G55", Group::offset, Setting::none, "work offset 2"),
    sets("G56", Group::offset, Setting::none, "work offset 3"),
    sets("G57", Group::offset, Setting::none, "work offset 4"),
    sets("G58", Group::offset, Setting::none, "work offset 5"),
    sets("G59", Group::offset, Setting::none, "work offset 6"),
    no_effect("G61", Group::path_mode, "exact stop"),
    no_effect("G64", Group::path_mode, "continuous path"),
    outside("G65", Group::once, "macro call"),
    outside("G70", Group::motion, "finishing"),
    outside("G71", Group::motion, "compound turning"),
    outside("G72", Group::motion, "compound facing"),
    outside("G73", Group::motion, "closed compound turning"),
    kG74.named("G74", "deep drilling of the face"),
    kG75.named("G75", "grooving of the diameter"),
    outside("G76", Group::motion, "compound threading"),
    kG80.named("G80", "cutting cycle of the diameter"),
    kG81.named("G81", "cutting cycle of the face"),
    kG82.named("G82", "thread cutting cycle"),
    sets("G90", Group::distance, Setting::absolute, "absolute").initial(),
    sets("G91", Group::distance, Setting::incremental, "incremental"),
    kRename.named("G92", "work coordinate system"),
    sets("G94", Group::feed_mode, Setting::none, "feed per minute").initial(),
    sets("G95", Group::feed_mode, Setting::none, "feed per revolution"),
    no_effect("G96", Group::speed, "constant surface speed"),
    no_effect("G97", Group::speed, "constant spindle speed").initial(),
    outside("G98", Group::retract, "return to the initial plane"),
    outside("G99", Group::retract, "return to the R plane"),
    m_function("M0", Kind::stop, Group::program, "stop"),
    m_function("M1", Kind::stop, Group::program, "optional stop"),
    m_function("M2", Kind::program_end, Group::program, "end of the program"),
    m_function("M3", Kind::machine, Group::spindle, "spindle clockwise"),
    m_function("M4", Kind::machine, Group::spindle, "spindle counterclockwise"),
    m_function("M5", Kind::stop, Group::spindle, "spindle stop"),
    m_function("M9", Kind::stop, Group::coolant, "coolant off"),
    m_function("M17", Kind::program_end, Group::program, "end of the program"),
    m_function("M30", Kind::program_end, Group::program, "end of the program"),
    outside("M98", Group::program, "call of a subprogram"),
    outside("M99", Group::program, "end of a subprogram"),
});

inline constexpr auto kEverywhere = std::to_array<CodeWord>({
    {"F", feed, "feed", Life::modal},
    {"M", number, "M function"},
    {"S", speed, "spindle speed", Life::modal},
    {"T", number, "tool", Life::modal},
});

// The codes themselves stand beside them.
inline constexpr Letters kEverywhereLetters =
    letters_of("G") | letters_of(WordLists({kEverywhere}));

inline constexpr auto kFeatures = std::to_array<DialectFeature>({
    {"basic", "G00, G01, G04, units, diameters, work offsets, G90 to G95, M functions, S and T"},
    {"arc", "G02 and G03"},
    {"g32", "thread cutting G32"},
    {"g74", "deep drilling of the face G74"},
    {"g75", "grooving of the diameter G75"},
    {"g80", "the diameter cutting cycle G80"},
    {"g81", "the face cutting cycle G81"},
    {"g82", "the thread cutting cycle G82"},
});

inline constexpr auto kHolding = std::to_array<HoldingRule>({
    {Holds::words, "", Group::motion, "HNC-MOD-01"_clause},
    {Holds::motion, "", Group::motion, "HNC-MOD-02"_clause},
});

}  // namespace table

inline constexpr Descriptor kDescriptor = {table::kFeatures, table::kCodes, table::kEverywhere,
                                           table::kAnyBlock, table::kHolding};

}  // namespace gonogo::reference::hnc21t
