// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/codes.hpp"

#include <algorithm>
#include <array>

#include "reference/rs274/whole.hpp"
#include "reference/words.hpp"

namespace gonogo::reference::rs274 {
namespace {

using enum Treatment;
using Code = GCode<Group>;

// In ascending order. NGC-COM-01 for those that are read or have no effect; the others are codes
// that the language has and the gauge does not read. NGC-CYC-30: one code of a group in a block.
// NGC-CYC-21: what forbids a cycle is among the codes that are not read. NGC-G87-01, NGC-G88-01: so
// are two cycles whose path the documents leave undefined.
constexpr auto kCodes = std::to_array<Code>({
    {0, Group::motion, read, "traverse"},
    {10, Group::motion, read, "straight feed"},
    {20, Group::motion, read, "arc clockwise"},
    {30, Group::motion, read, "arc counterclockwise"},
    {40, Group::once, read, "dwell"},
    {50, Group::motion, outside, "cubic spline"},
    {51, Group::motion, outside, "quadratic spline"},
    {52, Group::motion, outside, "spline of control points"},
    {53, Group::motion, outside, "end of the spline"},
    {70, Group::diameter, outside, "diameter programming"},
    {80, Group::diameter, outside, "radius programming"},
    {100, Group::once, outside, "setting of offsets and tools"},
    {170, Group::plane, read, "plane XY"},
    {171, Group::plane, outside, "plane UV"},
    {180, Group::plane, read, "plane ZX"},
    {181, Group::plane, outside, "plane WU"},
    {190, Group::plane, read, "plane YZ"},
    {191, Group::plane, outside, "plane VW"},
    {200, Group::units, read, "inch"},
    {210, Group::units, read, "metric"},
    {280, Group::once, outside, "return to the first reference point"},
    {281, Group::once, outside, "setting of the first reference point"},
    {300, Group::once, outside, "return to the second reference point"},
    {301, Group::once, outside, "setting of the second reference point"},
    {330, Group::motion, read, "spindle-synchronous motion"},
    {331, Group::motion, read, "rigid tapping"},
    {382, Group::motion, outside, "probing towards the part, with an error"},
    {383, Group::motion, outside, "probing towards the part"},
    {384, Group::motion, outside, "probing away from the part, with an error"},
    {385, Group::motion, outside, "probing away from the part"},
    {400, Group::compensation, without_effect, "radius compensation off"},
    {410, Group::compensation, outside, "radius compensation left"},
    {411, Group::compensation, outside, "dynamic radius compensation left"},
    {420, Group::compensation, outside, "radius compensation right"},
    {421, Group::compensation, outside, "dynamic radius compensation right"},
    {430, Group::tool_length, outside, "tool length offset"},
    {431, Group::tool_length, outside, "dynamic tool length offset"},
    {432, Group::tool_length, outside, "additional tool length offset"},
    {490, Group::tool_length, without_effect, "tool length offset off"},
    {500, Group::scaling, outside, "scaling off"},
    {510, Group::scaling, outside, "scaling"},
    {520, Group::once, outside, "local coordinate system"},
    {530, Group::once, outside, "machine coordinates"},
    {540, Group::offset, without_effect, "coordinate system 1"},
    {550, Group::offset, outside, "coordinate system 2"},
    {560, Group::offset, outside, "coordinate system 3"},
    {570, Group::offset, outside, "coordinate system 4"},
    {580, Group::offset, outside, "coordinate system 5"},
    {590, Group::offset, outside, "coordinate system 6"},
    {591, Group::offset, outside, "coordinate system 7"},
    {592, Group::offset, outside, "coordinate system 8"},
    {593, Group::offset, outside, "coordinate system 9"},
    {610, Group::path_mode, without_effect, "exact path"},
    {611, Group::path_mode, without_effect, "exact stop"},
    {640, Group::path_mode, without_effect, "continuous path"},
    {730, Group::motion, read, "drilling with chip breaking"},
    {740, Group::motion, read, "left-hand tapping"},
    {760, Group::motion, read, "compound threading"},
    {800, Group::motion, read, "no motion"},
    {810, Group::motion, read, "drilling"},
    {820, Group::motion, read, "drilling with a dwell"},
    {830, Group::motion, read, "deep drilling"},
    {840, Group::motion, read, "right-hand tapping"},
    {850, Group::motion, read, "boring, feed out"},
    {860, Group::motion, read, "boring, spindle stop, traverse out"},
    {870, Group::motion, outside, "back boring"},
    {880, Group::motion, outside, "boring, spindle stop, out by hand"},
    {890, Group::motion, read, "boring with a dwell, feed out"},
    {900, Group::distance, read, "absolute"},
    {901, Group::arc_distance, read, "absolute centres"},
    {910, Group::distance, read, "incremental"},
    {911, Group::arc_distance, read, "incremental centres"},
    {920, Group::once, outside, "offset of the coordinate system"},
    {921, Group::once, outside, "offset cancelled and cleared"},
    {922, Group::once, outside, "offset cancelled"},
    {923, Group::once, outside, "offset restored"},
    {930, Group::feed_mode, outside, "inverse time feed"},
    {940, Group::feed_mode, without_effect, "feed per minute"},
    {950, Group::feed_mode, outside, "feed per revolution"},
    {960, Group::speed, outside, "constant surface speed"},
    {970, Group::speed, without_effect, "constant spindle speed"},
    {980, Group::retract, read, "return to the initial level"},
    {990, Group::retract, read, "return to the R level"},
});
static_assert(std::ranges::is_sorted(kCodes, {}, &Code::tenths));

constexpr GCodeTable<Group> kTable{kCodes, "NGC-COM-01"_clause, "NGC-COM-01"_clause};

// NGC-COM-01: the code whose number the word has, or is near enough to. Null: the language has
// none.
const Code* code_of(const grammar::Word& word, const ReadingsInUse& readings) {
  if (const Code* code = kTable.find(word.value)) return code;
  const NearWhole tenths(to_number(word.value) * 10);
  if (tenths.is_whole()) return nullptr;
  const std::optional<std::int64_t> nearest = tenths.nearest().to_int64();
  if (!nearest || *nearest < 0 || *nearest > kCodes.back().tenths) return nullptr;
  const Code* code = kTable.find_tenths(static_cast<int>(*nearest));
  return code != nullptr && tenths.counts_as_whole(Whole::g_tenths, readings) ? code : nullptr;
}

// As BlockCodes has it.
int motion_of(const Code& code) {
  return code.tenths == kG33Point1 ? kG33Point1 : code.tenths / 10;
}

constexpr int kG80 = 800;  // tenths

// NGC-COM-03: how the G80 of a block stand beside the other codes of the motion group.
struct BesideG80 {
  int others = 0;
  int g80 = 0;
  bool decides = true;  // nothing else of the block is not read, or no code

  void add(const Code* code) {
    decides = decides && code != nullptr && code->treatment != outside;
    if (code == nullptr || code->group != Group::motion) return;
    ++(code->tenths == kG80 ? g80 : others);
  }
  // Whether but for a G80 the group would have one code, and nothing else is wrong with the codes.
  bool matters() const { return decides && others <= 1 && g80 >= 1 && others + g80 >= 2; }
};

Alarm g80_beside(const grammar::Word& word) {
  return {AlarmClass::duplicate_word, "NGC-COM-03"_clause, 'G', word.where,
          "G80 and another code of its group stand in the block; under ngc.g80-beside = ignored "
          "the other one holds."};
}

}  // namespace

void read_codes(const grammar::Block& block, const ReadingsInUse& readings, CodeReading& reading) {
  reading.clear();
  BesideG80 beside;
  for (const grammar::Word& word : block.words) {
    if (word.address == 'G') beside.add(code_of(word, readings));
  }
  const bool is_beside = beside.matters();
  const bool alarms = is_beside && !readings.is(ReadingKey::ngc_g80_beside, "ignored");
  int motions = 0;
  int acting = 0;  // of them
  for (const grammar::Word& word : block.words) {
    if (word.address != 'G') continue;
    const Code* const code = code_of(word, readings);
    if (is_beside && code->group == Group::motion) {
      if (++motions > 1 && alarms) reading.alarms.push_back(g80_beside(word));
      // Of two G80 one is left.
      if (code->tenths == kG80 && (beside.others > 0 || motions > 1)) continue;
    }
    if (code != nullptr && code->group == Group::motion) ++acting;
    kTable.take(word, code, false, reading);
    if (code != nullptr && code->group == Group::motion) {
      reading.by_group[static_cast<std::size_t>(Group::motion)] = motion_of(*code);
    }
  }
  reading.codes = {.once = reading.of(Group::once),
                   .motion = reading.of(Group::motion),
                   .plane = reading.of(Group::plane),
                   .units = reading.of(Group::units),
                   .path_mode = reading.of(Group::path_mode),
                   .distance = reading.of(Group::distance),
                   .arc_distance = reading.of(Group::arc_distance),
                   .retract = reading.of(Group::retract),
                   .repeats_motion = acting > 1};
}

std::span<const OutsideCode> outside_codes() {
  static const std::vector<OutsideCode> kOutside = kTable.outside();
  return kOutside;
}

std::span<const std::string_view> codes_without_effect() {
  static constexpr auto kNames = std::to_array<std::string_view>(
      {"G40", "G49", "G54", "G61", "G61.1", "G64", "G94", "G97", "M", "S", "T"});
  return kNames;
}

bool is_hole_cycle(int motion) {
  return motion == 73 || motion == 74 || (motion >= 81 && motion <= 89);
}

std::string_view words_of_motion(int motion) {
  switch (motion) {
    case 2:
    case 3:
      return "IJKPR";
    case 33:
      return "K";
    case kG33Point1:
      return "IK";
    case 73:
    case 83:
      return "DLQR";
    case 76:
      return "EHIJKLPQR";
    case 81:
    case 85:
      return "LR";
    case 74:
    case 82:
    case 84:
    case 86:
    case 89:
      return "LPR";
    default:
      return "";
  }
}

bool has_motion_with(const grammar::Block& block, const ReadingsInUse& readings, char address) {
  return std::ranges::any_of(block.words, [&](const grammar::Word& word) {
    const Code* const code = word.address == 'G' ? code_of(word, readings) : nullptr;
    return code != nullptr && code->group == Group::motion &&
           words_of_motion(motion_of(*code)).find(address) != std::string_view::npos;
  });
}

MFunction m_function(std::int64_t number) {
  using enum MFunction;
  if (number == 2 || number == 30) return ends_program;
  if (number == 0 || number == 1 || number == 60) return after_motion;
  const bool is_subprogram = number == 98 || number == 99;
  if (is_subprogram || (number >= 100 && number <= 199)) return outside;
  const bool is_known = (number >= 3 && number <= 9) || number == 48 || number == 49 ||
                        (number >= 50 && number <= 53) ||
                        (number >= 60 && number <= 73 && number != 69);
  return is_known ? before_motion : undefined;
}

// As the language numbers them: stopping, tool change, spindle, coolant, overrides; above those the
// outputs and inputs, and the saving of modes.
int m_group(std::int64_t number) {
  if (number <= 2 || number == 30 || number == 60) return 4;
  if (number == 6 || number == 61) return 6;
  if (number <= 5) return 7;
  if (number <= 9) return 8;
  if (number <= 53) return 9;
  return number <= 68 ? 5 : 10;
}

// NGC-COM-02
bool takes(std::int64_t m_number, char address) {
  switch (address) {
    case 'P':
      return (m_number >= 50 && m_number <= 53) || (m_number >= 62 && m_number <= 66);
    case 'E':
      return m_number >= 66 && m_number <= 68;
    case 'L':
      return m_number == 66;
    case 'Q':
      return m_number == 61 || (m_number >= 66 && m_number <= 68);
    default:
      return false;
  }
}

}  // namespace gonogo::reference::rs274
