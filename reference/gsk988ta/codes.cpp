// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gsk988ta/codes.hpp"

#include <algorithm>
#include <array>

#include "reference/clause.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

using enum Treatment;
using Code = GCode<Group>;

// In ascending order. GSK-COM-05 for those that are read or have no effect; the others are codes
// that the control has and the gauge does not read.
constexpr auto kCodes = std::to_array<Code>({
    {0, Group::motion, read, "positioning"},
    {10, Group::motion, read, "straight feed"},
    {20, Group::motion, read, "arc clockwise"},
    {30, Group::motion, read, "arc counterclockwise"},
    {40, Group::once, read, "dwell"},
    {50, Group::motion, outside, "three-point arc"},
    {71, Group::once, outside, "cylindrical interpolation"},
    {100, Group::once, outside, "data input"},
    {121, Group::once, outside, "polar interpolation on"},
    {131, Group::once, outside, "polar interpolation off"},
    {170, Group::plane, read, "plane XY"},
    {180, Group::plane, read, "plane ZX"},
    {190, Group::plane, read, "plane YZ"},
    {200, Group::units, read, "inch"},
    {210, Group::units, read, "metric"},
    {220, Group::stroke, outside, "stroke check on"},
    {230, Group::stroke, outside, "stroke check off"},
    {280, Group::once, read, "return to the reference point"},
    {300, Group::once, outside, "return to another reference point"},
    {310, Group::once, outside, "skip function"},
    {320, Group::motion, outside, "thread cutting"},
    {330, Group::motion, outside, "tapping"},
    {340, Group::motion, outside, "thread cutting with variable lead"},
    {350, Group::once, outside, "thread cutting along an arc"},
    {360, Group::once, outside, "automatic tool offset X"},
    {370, Group::once, outside, "automatic tool offset Z"},
    {400, Group::compensation, without_effect, "radius compensation off"},
    {410, Group::compensation, outside, "radius compensation left"},
    {420, Group::compensation, outside, "radius compensation right"},
    {500, Group::once, read, "work coordinate system"},
    {520, Group::once, outside, "local coordinate system"},
    {530, Group::once, outside, "machine coordinates"},
    {540, Group::offset, without_effect, "work offset 1"},
    {550, Group::offset, outside, "work offset 2"},
    {560, Group::offset, outside, "work offset 3"},
    {570, Group::offset, outside, "work offset 4"},
    {580, Group::offset, outside, "work offset 5"},
    {590, Group::offset, outside, "work offset 6"},
    {610, Group::path_mode, without_effect, "exact stop"},
    {640, Group::path_mode, without_effect, "continuous path"},
    {650, Group::once, outside, "macro call"},
    {660, Group::macro, outside, "modal macro call"},
    {670, Group::macro, outside, "modal macro call off"},
    {700, Group::once, outside, "finishing"},
    {710, Group::once, outside, "axial roughing"},
    {720, Group::once, outside, "radial roughing"},
    {730, Group::once, outside, "closed roughing"},
    {740, Group::once, outside, "axial grooving"},
    {750, Group::once, outside, "radial grooving"},
    {760, Group::once, outside, "compound threading"},
    {800, Group::cycle, read, "cycle off"},
    {830, Group::cycle, outside, "face drilling"},
    {840, Group::cycle, outside, "face tapping"},
    {850, Group::cycle, outside, "face boring"},
    {870, Group::cycle, outside, "side drilling"},
    {880, Group::cycle, outside, "side tapping"},
    {890, Group::cycle, outside, "side boring"},
    {900, Group::motion, read, "axial cutting cycle"},
    {920, Group::motion, read, "thread cutting cycle"},
    {940, Group::motion, read, "radial cutting cycle"},
    {960, Group::speed, without_effect, "constant surface speed"},
    {970, Group::speed, without_effect, "constant spindle speed"},
    {980, Group::feed_mode, read, "feed per minute"},
    {990, Group::feed_mode, read, "feed per revolution"},
    {1100, Group::cycle, read, "circular pocket clockwise"},
    {1110, Group::cycle, read, "circular pocket counterclockwise"},
    {1120, Group::cycle, read, "helical pocket clockwise"},
    {1130, Group::cycle, read, "helical pocket counterclockwise"},
    {1140, Group::cycle, read, "external thread clockwise"},
    {1150, Group::cycle, read, "external thread counterclockwise"},
    {1160, Group::cycle, read, "internal thread clockwise"},
    {1170, Group::cycle, read, "internal thread counterclockwise"},
});
static_assert(std::ranges::is_sorted(kCodes, {}, &Code::tenths));

// GSK-COM-02, GSK-COM-08 (a code with decimals); GSK-COM-07.
constexpr GCodeTable<Group> kTable{kCodes, "GSK-COM-02"_clause, "GSK-COM-07"_clause};

}  // namespace

bool repeats_group(const grammar::Block& block) {
  return kTable.repeats_group(block);
}

void read_codes(const grammar::Block& block, bool last_wins, CodeReading& reading) {
  kTable.read(block, last_wins, reading);
  reading.codes = {.once = reading.of(Group::once),
                   .motion = reading.of(Group::motion),
                   .cycle = reading.of(Group::cycle),
                   .feed_mode = reading.of(Group::feed_mode),
                   .units = reading.of(Group::units),
                   .plane = reading.of(Group::plane)};
}

std::span<const OutsideCode> outside_codes() {
  static const std::vector<OutsideCode> kOutside = kTable.outside();
  return kOutside;
}

std::span<const std::string_view> codes_without_effect() {
  static constexpr auto kNames =
      std::to_array<std::string_view>({"G40", "G54", "G61", "G64", "G96", "G97", "M", "S", "T"});
  return kNames;
}

}  // namespace gonogo::reference::gsk988ta
