// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/gsk988ta/codes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "grammar/parser.hpp"
#include "reference/clause.hpp"

namespace gonogo::reference::gsk988ta {
namespace {

using enum Treatment;

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

// 10 times the value, when that is a whole number below 10,000.
std::optional<int> tenths_of(const grammar::Decimal& value) {
  if (!value.long_digits.empty() || (value.negative && value.magnitude != 0)) return std::nullopt;
  std::uint64_t scaled = value.magnitude;
  if (value.scale == 0) {
    if (scaled > 1000) return std::nullopt;
    return static_cast<int>(scaled * 10);
  }
  for (std::uint32_t place = 1; place < value.scale; ++place) {
    if (scaled % 10 != 0) return std::nullopt;
    scaled /= 10;
  }
  return scaled > 10'000 ? std::nullopt : std::optional<int>(static_cast<int>(scaled));
}

int* slot_of(BlockCodes& codes, Group group) {
  switch (group) {
    case Group::once:
      return &codes.once;
    case Group::motion:
      return &codes.motion;
    case Group::cycle:
      return &codes.cycle;
    case Group::feed_mode:
      return &codes.feed_mode;
    case Group::units:
      return &codes.units;
    case Group::plane:
      return &codes.plane;
    default:
      return nullptr;
  }
}

}  // namespace

const Code* find_code(const grammar::Decimal& value) {
  std::optional<int> tenths = tenths_of(value);
  if (!tenths) return nullptr;
  auto found = std::ranges::lower_bound(kCodes, *tenths, {}, &Code::tenths);
  return found != kCodes.end() && found->tenths == *tenths ? &*found : nullptr;
}

std::string code_name(int tenths) {
  return tenths % 10 == 0 ? fmt::format("G{:02}", tenths / 10)
                          : fmt::format("G{}.{}", tenths / 10, tenths % 10);
}

bool repeats_group(const grammar::Block& block) {
  std::uint32_t seen = 0;
  for (const grammar::Word& word : block.words) {
    const Code* code = word.address == 'G' ? find_code(word.value) : nullptr;
    if (code == nullptr) continue;
    const std::uint32_t bit = std::uint32_t{1} << static_cast<unsigned>(code->group);
    if ((seen & bit) != 0) return true;
    seen |= bit;
  }
  return false;
}

void read_codes(const grammar::Block& block, bool last_wins, CodeReading& reading) {
  std::uint32_t groups_seen = 0;
  for (const grammar::Word& word : block.words) {
    if (word.address != 'G') continue;
    const Code* code = find_code(word.value);
    if (code == nullptr) {
      // GSK-COM-02; GSK-COM-08 for a code with decimals.
      std::string written = "G";
      grammar::print(word.value, written);
      reading.alarms.push_back({AlarmClass::undefined_code, "GSK-COM-02"_clause, 'G', word.where,
                                fmt::format("The control has no code {}.", written)});
      continue;
    }
    std::uint32_t group_bit = std::uint32_t{1} << static_cast<unsigned>(code->group);
    if ((groups_seen & group_bit) != 0 && !last_wins) {
      reading.alarms.push_back({AlarmClass::duplicate_word, "GSK-COM-07"_clause, 'G', word.where,
                                fmt::format("{} is the second code of its group in the block.",
                                            code_name(code->tenths))});
    }
    groups_seen |= group_bit;
    if (code->treatment == outside && !reading.not_covered) {
      reading.not_covered =
          NotCovered{0, code_name(code->tenths),
                     fmt::format("{} ({}) is a code of the control that the gauge does not read.",
                                 code_name(code->tenths), code->title),
                     word.where};
    }
    if (int* slot = slot_of(reading.codes, code->group)) *slot = code->tenths / 10;
  }
}

}  // namespace gonogo::reference::gsk988ta

namespace gonogo::reference {

std::span<const OutsideCode> outside_codes(std::string_view dialect) {
  static const std::vector<OutsideCode> kOutside = [] {
    static std::vector<std::string> names;
    std::vector<OutsideCode> codes;
    names.reserve(gsk988ta::kCodes.size());
    for (const gsk988ta::Code& code : gsk988ta::kCodes) {
      if (code.treatment != gsk988ta::Treatment::outside) continue;
      names.push_back(gsk988ta::code_name(code.tenths));
      codes.push_back({names.back(), code.title});
    }
    return codes;
  }();
  if (dialect != "gsk988ta") return {};
  return kOutside;
}

std::span<const std::string_view> codes_without_effect(std::string_view dialect) {
  static constexpr auto kNames =
      std::to_array<std::string_view>({"G40", "G54", "G61", "G64", "G96", "G97", "M", "S", "T"});
  if (dialect != "gsk988ta") return {};
  return kNames;
}

}  // namespace gonogo::reference
