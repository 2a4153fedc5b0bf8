// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hnc21t/codes.hpp"

#include <algorithm>
#include <array>

namespace gonogo::reference::hnc21t {
namespace {

using enum Treatment;
using Code = GCode<Group>;

// In ascending order. HNC-COM-01 for those that are read or have no effect; the others are codes
// that the control has and the gauge does not read.
constexpr auto kCodes = std::to_array<Code>({
    {0, Group::motion, read, "positioning"},
    {10, Group::motion, read, "straight feed"},
    {20, Group::motion, read, "arc clockwise"},
    {30, Group::motion, read, "arc counterclockwise"},
    {40, Group::once, read, "dwell"},
    {170, Group::plane, read, "plane XY"},
    {180, Group::plane, read, "plane ZX"},
    {190, Group::plane, read, "plane YZ"},
    {200, Group::units, read, "inch"},
    {210, Group::units, read, "metric"},
    {280, Group::once, outside, "return to the reference point"},
    {290, Group::once, outside, "return from the reference point"},
    {320, Group::motion, read, "thread cutting"},
    {360, Group::diameter, read, "diameter programming"},
    {370, Group::diameter, read, "radius programming"},
    {400, Group::compensation, without_effect, "radius compensation off"},
    {410, Group::compensation, outside, "radius compensation left"},
    {420, Group::compensation, outside, "radius compensation right"},
    {520, Group::once, outside, "local coordinate system"},
    {530, Group::once, outside, "machine coordinates"},
    {540, Group::offset, read, "work offset 1"},
    {550, Group::offset, read, "work offset 2"},
    {560, Group::offset, read, "work offset 3"},
    {570, Group::offset, read, "work offset 4"},
    {580, Group::offset, read, "work offset 5"},
    {590, Group::offset, read, "work offset 6"},
    {610, Group::path_mode, without_effect, "exact stop"},
    {640, Group::path_mode, without_effect, "continuous path"},
    {650, Group::once, outside, "macro call"},
    {700, Group::motion, outside, "finishing"},
    {710, Group::motion, outside, "compound turning"},
    {720, Group::motion, outside, "compound facing"},
    {730, Group::motion, outside, "closed compound turning"},
    {740, Group::motion, read, "deep drilling of the face"},
    {750, Group::motion, read, "grooving of the diameter"},
    {760, Group::motion, outside, "compound threading"},
    {800, Group::motion, read, "cutting cycle of the diameter"},
    {810, Group::motion, read, "cutting cycle of the face"},
    {820, Group::motion, read, "thread cutting cycle"},
    {900, Group::distance, read, "absolute"},
    {910, Group::distance, read, "incremental"},
    {920, Group::once, read, "work coordinate system"},
    {940, Group::feed_mode, read, "feed per minute"},
    {950, Group::feed_mode, read, "feed per revolution"},
    {960, Group::speed, without_effect, "constant surface speed"},
    {970, Group::speed, without_effect, "constant spindle speed"},
    {980, Group::retract, outside, "return to the initial plane"},
    {990, Group::retract, outside, "return to the R plane"},
});
static_assert(std::ranges::is_sorted(kCodes, {}, &Code::tenths));

constexpr GCodeTable<Group> kTable{kCodes, "HNC-COM-01"_clause, "HNC-COM-02"_clause};

}  // namespace

void read_codes(const grammar::Block& block, CodeReading& reading) {
  kTable.read(block, false, reading);
  reading.codes = {.once = reading.of(Group::once),
                   .motion = reading.of(Group::motion),
                   .plane = reading.of(Group::plane),
                   .units = reading.of(Group::units),
                   .diameter = reading.of(Group::diameter),
                   .offset = reading.of(Group::offset),
                   .distance = reading.of(Group::distance),
                   .feed_mode = reading.of(Group::feed_mode)};
}

std::span<const OutsideCode> outside_codes() {
  static const std::vector<OutsideCode> kOutside = kTable.outside();
  return kOutside;
}

std::span<const std::string_view> codes_without_effect() {
  static constexpr auto kNames =
      std::to_array<std::string_view>({"G18", "G40", "G61", "G64", "G96", "G97", "M", "S", "T"});
  return kNames;
}

}  // namespace gonogo::reference::hnc21t
