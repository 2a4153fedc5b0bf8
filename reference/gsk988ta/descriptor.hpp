// SPDX-License-Identifier: GPL-3.0-or-later
//
// The codes and words of the GSK 988TA.
#pragma once

#include "reference/clause_literal.hpp"
#include "reference/descriptor.hpp"

namespace gonogo::reference::gsk988ta {
namespace table {

using enum Role;

// X and U are diameters where the machine counts so.
inline constexpr auto kEnds = std::to_array<CodeWord>({
    {"X", place, "end point"},
    {"Y", place, "end point"},
    {"Z", place, "end point"},
    {"U", way, "way along X"},
    {"V", way, "way along Y"},
    {"W", way, "way along Z"},
    {"C", place, "end point, degrees"},
    {"H", way, "way about C, degrees"},
});

inline constexpr auto kKeptEnds = kept(kEnds);

inline constexpr auto kArc = std::to_array<CodeWord>({
    {"R", radius, "radius of the arc"},
    {"I", centre, "centre from the start along X"},
    {"J", centre, "centre from the start along Y"},
    {"K", centre, "centre from the start along Z"},
});

// P goes before X, X before U.
inline constexpr auto kDwell = std::to_array<CodeWord>({
    {"P", time, "dwell, ms"},
    {"X", time, "dwell, s"},
    {"U", time, "dwell, s"},
});

inline constexpr auto kTaperAlongQ = std::to_array<CodeWord>({
    {"R", along_q, "taper: how far B lies beyond C", Life::modal},
});
inline constexpr auto kTaperAlongP = std::to_array<CodeWord>({
    {"R", along_p, "taper: how far B lies beyond C", Life::modal},
});
inline constexpr auto kThread = std::to_array<CodeWord>({
    {"F", lead, "lead", Life::modal},
    {"J", size, "run-out along the short axis", Life::modal},
    {"K", size, "run-out along the long axis", Life::modal},
    {"I", lead, "threads to the inch"},
    {"L", count, "number of starts"},
    {"P", size, "depth of a face thread"},
    {"Q", angle, "shift of the start angle"},
});

// The milling cycles: beside the centre and the bottom the R plane (GSK-G110-01).
inline constexpr auto kPocket = std::to_array<CodeWord>({
    {"R", along_d, "way from the initial plane to the R plane"},
    {"I", radius, "radius of the pocket", Life::modal},
    {"L", step, "width of cut", Life::modal},
    {"Q", step, "depth of a layer", Life::modal},
    {"D", radius, "radius of the tool", Life::modal},
    {"P", size, "clearance above the last depth"},
});
inline constexpr auto kHelix = std::to_array<CodeWord>({
    {"R", along_d, "way from the initial plane to the R plane"},
    {"I", radius, "radius of the pocket", Life::modal},
    {"D", radius, "radius of the tool", Life::modal},
    {"L", turns, "number of turns"},
});
inline constexpr auto kThreadMilling = std::to_array<CodeWord>({
    {"R", along_d, "way from the initial plane to the R plane"},
    {"I", lead, "lead of the thread"},
    {"P", size, "height of the thread"},
    {"Q", step, "depth of a pass"},
    {"D", radius, "radius of the tool"},
    {"E", size, "diameter before threading"},
    {"J", size, "run-out"},
    {"K", angle, "angle of the run-out"},
});

inline constexpr auto kAnyBlock = std::to_array<IgnoredWords>({
    {"", "S T", "GSK-COM-05"_clause, "the spindle and the tool do not shape the path"},
});
inline constexpr auto kBesideR = std::to_array<IgnoredWords>({
    {"beside R", "I J K", "GSK-COM-05"_clause, "the radius goes before the centre"},
});
// GSK-COM-06, GSK-COM-10: the words that the tables of the cycles give a range.
inline constexpr std::string_view kOfTables = "R I L Q D E J K P";
inline constexpr IgnoredWords kInRange = {
    "", kOfTables, "GSK-COM-10"_clause,
    "a word of the tables of the cycles that this one does not use is held to its range only"};
inline constexpr std::array<IgnoredWords, 1> kTables = {kInRange};
inline constexpr std::string_view kSaidAnyway = "they say what goes without saying";
inline constexpr auto kG92Passed = std::to_array<IgnoredWords>({
    kInRange,
    {"of 1", "L", "GSK-G92-13"_clause, kSaidAnyway},
    {"of 0", "P Q", "GSK-G92-13"_clause, kSaidAnyway},
});
inline constexpr auto kEntry = std::to_array<IgnoredWords>({
    {"in the entry block of G110 to G117", kOfTables, "GSK-MOD-02"_clause,
     "I L Q D are taken in; the others hold for a block that mills"},
});

inline constexpr ClauseId kBasic = "GSK-COM-05"_clause;
inline constexpr Code kTraverse = does(Kind::traverse, Group::motion, kBasic, "basic", {kEnds});
inline constexpr Code kFeed = does(Kind::line, Group::motion, kBasic, "basic", {kEnds});
inline constexpr Code kRound =
    does(Kind::arc, Group::motion, kBasic, "arc", {kEnds, kArc}).passing(kBesideR);
inline constexpr Code kPause =
    does(Kind::dwell, Group::once, kBasic, "basic", {kDwell}).passing(kEntry);
inline constexpr Code kReturn =
    does(Kind::reference_point, Group::once, kBasic, "basic", {kEnds}).passing(kEntry);
inline constexpr Code kRename =
    does(Kind::rename, Group::once, kBasic, "basic", {kEnds}).passing(kEntry);
inline constexpr Code kOff =
    does(Kind::off, Group::cycle, "GSK-MOD-06"_clause, "basic", {kEnds}).initial();

inline constexpr Code kG90 =
    does(Kind::cycle, Group::motion, "GSK-G90-01"_clause, "g90", {kKeptEnds, kTaperAlongQ})
        .passing(kTables);
inline constexpr Code kG92 =
    does(Kind::cycle, Group::motion, "GSK-G92-01"_clause, "g92", {kKeptEnds, kTaperAlongQ, kThread})
        .passing(kG92Passed);
inline constexpr Code kG94 =
    does(Kind::cycle, Group::motion, "GSK-G94-01"_clause, "g94", {kKeptEnds, kTaperAlongP})
        .passing(kTables);
inline constexpr Code kG110 =
    does(Kind::cycle, Group::cycle, "GSK-G110-01"_clause, "g110", {kEnds, kPocket})
        .passing(kTables)
        .open();
inline constexpr Code kG112 =
    does(Kind::cycle, Group::cycle, "GSK-G112-01"_clause, "g112", {kEnds, kHelix})
        .passing(kTables)
        .open();
inline constexpr Code kG114 =
    does(Kind::cycle, Group::cycle, "GSK-G114-01"_clause, "g114", {kEnds, kThreadMilling})
        .passing(kTables)
        .open();
inline constexpr Code kG116 = kG114.needing("g116");

inline constexpr auto kCodes = std::to_array<Code>({
    kTraverse.named("G0", "positioning"),
    kFeed.named("G1", "straight feed"),
    kRound.named("G2", "arc clockwise", -1),
    outside("G2.1", Group::motion, "ellipse clockwise"),
    outside("G2.2", Group::motion, "parabola clockwise"),
    kRound.named("G3", "arc counterclockwise", +1),
    outside("G3.1", Group::motion, "ellipse counterclockwise"),
    outside("G3.2", Group::motion, "parabola counterclockwise"),
    kPause.named("G4", "dwell"),
    outside("G5", Group::motion, "three-point arc"),
    outside("G6.4", Group::once, "eccentric circle"),
    outside("G6.5", Group::once, "eccentric ellipse"),
    outside("G6.6", Group::once, "polygon"),
    outside("G7.1", Group::once, "cylindrical interpolation"),
    outside("G7.9", Group::once, "chip breaking"),
    outside("G10", Group::once, "data input"),
    outside("G10.9", Group::once, "diameter or radius programming"),
    outside("G12.1", Group::once, "polar interpolation on"),
    outside("G13.1", Group::once, "polar interpolation off"),
    sets("G17", Group::plane, Setting::plane_xy, "plane XY"),
    sets("G18", Group::plane, Setting::plane_zx, "plane ZX"),
    sets("G19", Group::plane, Setting::plane_yz, "plane YZ"),
    sets("G20", Group::units, Setting::inch, "inch"),
    sets("G21", Group::units, Setting::metric, "metric"),
    outside("G22", Group::stroke, "stroke check on"),
    outside("G23", Group::stroke, "stroke check off"),
    outside("G25", Group::once, "watch of the spindle speed"),
    outside("G26", Group::once, "watch of the spindle speed"),
    kReturn.named("G28", "return to the reference point"),
    outside("G30", Group::once, "return to another reference point"),
    outside("G31", Group::once, "skip function"),
    outside("G32", Group::motion, "thread cutting"),
    outside("G32.1", Group::motion, "rigid thread cutting"),
    outside("G32.2", Group::motion, "thread along an arc"),
    outside("G32.3", Group::motion, "thread along an arc"),
    outside("G33", Group::motion, "tapping"),
    outside("G34", Group::motion, "thread cutting with variable lead"),
    outside("G35", Group::once, "thread cutting along an arc"),
    outside("G36", Group::once, "automatic tool offset X"),
    outside("G37", Group::once, "automatic tool offset Z"),
    no_effect("G40", Group::compensation, "radius compensation off").initial(),
    outside("G41", Group::compensation, "radius compensation left"),
    outside("G42", Group::compensation, "radius compensation right"),
    kRename.named("G50", "work coordinate system"),
    outside("G51.2", Group::once, "polygon turning"),
    outside("G51.3", Group::once, "gear hobbing"),
    outside("G52", Group::once, "local coordinate system"),
    outside("G53", Group::once, "machine coordinates"),
    outside("G53.3", Group::once, "named in the parameters"),
    no_effect("G54", Group::offset, "work offset 1"),
    outside("G55", Group::offset, "work offset 2"),
    outside("G56", Group::offset, "work offset 3"),
    outside("G57", Group::offset, "work offset 4"),
    outside("G58", Group::offset, "work offset 5"),
    outside("G59", Group::offset, "work offset 6"),
    no_effect("G61", Group::path_mode, "exact stop"),
    no_effect("G64", Group::path_mode, "continuous path"),
    outside("G65", Group::once, "macro call"),
    outside("G66", Group::macro, "modal macro call"),
    outside("G67", Group::macro, "modal macro call off"),
    outside("G68.1", Group::once, "rotation of coordinates"),
    outside("G70", Group::once, "finishing"),
    outside("G71", Group::once, "axial roughing"),
    outside("G72", Group::once, "radial roughing"),
    outside("G73", Group::once, "closed roughing"),
    outside("G74", Group::once, "axial grooving"),
    outside("G75", Group::once, "radial grooving"),
    outside("G76", Group::once, "compound threading"),
    outside("G78", Group::once, "enhanced compound threading"),
    kOff.named("G80", "cycle off"),
    outside("G83", Group::cycle, "face drilling"),
    outside("G84", Group::cycle, "face tapping"),
    outside("G85", Group::cycle, "face boring"),
    outside("G87", Group::cycle, "side drilling"),
    outside("G88", Group::cycle, "side tapping"),
    outside("G89", Group::cycle, "side boring"),
    kG90.named("G90", "axial cutting cycle"),
    kG92.named("G92", "thread cutting cycle"),
    outside("G92.1", Group::motion, "rigid thread cutting cycle"),
    outside("G92.2", Group::motion, "thread whirling cycle"),
    kG94.named("G94", "radial cutting cycle"),
    no_effect("G96", Group::speed, "constant surface speed"),
    no_effect("G97", Group::speed, "constant spindle speed").initial(),
    sets("G98", Group::feed_mode, Setting::none, "feed per minute").initial(),
    sets("G99", Group::feed_mode, Setting::none, "feed per revolution"),
    kG110.named("G110", "circular pocket clockwise", -1),
    kG110.named("G111", "circular pocket counterclockwise", +1),
    kG112.named("G112", "helical pocket clockwise", -1),
    kG112.named("G113", "helical pocket counterclockwise", +1),
    kG114.named("G114", "external thread clockwise", -1),
    kG114.named("G115", "external thread counterclockwise", +1),
    kG116.named("G116", "internal thread clockwise", -1),
    kG116.named("G117", "internal thread counterclockwise", +1),
    outside("G165", Group::once, "chip breaking"),
    outside("G166", Group::once, "named in the parameters"),
    outside("G211", Group::once, "named in the parameters"),
    m_function("M0", Kind::stop, Group::program, "stop"),
    m_function("M1", Kind::stop, Group::program, "optional stop"),
    m_function("M2", Kind::program_end, Group::program, "end of the program"),
    m_function("M3", Kind::machine, Group::spindle, "spindle clockwise"),
    m_function("M4", Kind::machine, Group::spindle, "spindle counterclockwise"),
    m_function("M5", Kind::stop, Group::spindle, "spindle stop"),
    m_function("M9", Kind::stop, Group::coolant, "coolant off"),
    m_function("M17", Kind::program_end, Group::program, "end of the program"),
    m_function("M30", Kind::program_end, Group::program, "end of the program"),
    m_function("M35", Kind::machine, Group::once, "clamping of C"),
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
inline constexpr Letters kAxisLetters = letters_of(WordLists({kEnds}));

inline constexpr auto kFeatures = std::to_array<DialectFeature>({
    {"basic", "G00, G01, G04, planes, units, G28, G50, G80, G98 and G99, M functions"},
    {"arc", "G02 and G03"},
    {"g90", "the axial cutting cycle G90"},
    {"g92", "the thread cutting cycle G92"},
    {"g94", "the radial cutting cycle G94"},
    {"g110", "the circular pocket G110 and G111"},
    {"g112", "the helical circular pocket G112 and G113"},
    {"g114", "external thread milling G114 and G115"},
    {"g116", "internal thread milling G116 and G117"},
});

inline constexpr auto kHolding = std::to_array<HoldingRule>({
    {Holds::words, "G90", Group::motion, "GSK-G90-06"_clause},
    {Holds::words, "G92", Group::motion, "GSK-G92-06"_clause},
    {Holds::words, "G94", Group::motion, "GSK-G94-06"_clause},
    {Holds::words, "G11", Group::motion, "GSK-G110-02"_clause},
    {Holds::motion, "G90", Group::motion, "GSK-G90-06"_clause},
    {Holds::motion, "G92", Group::motion, "GSK-G92-06"_clause},
    {Holds::motion, "G94", Group::motion, "GSK-G94-06"_clause},
});

}  // namespace table

inline constexpr Descriptor kDescriptor = {table::kFeatures, table::kCodes, table::kEverywhere,
                                           table::kAnyBlock, table::kHolding};

}  // namespace gonogo::reference::gsk988ta
