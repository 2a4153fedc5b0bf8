// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sinumerik/codes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "reference/sinumerik/names.hpp"
#include "reference/sinumerik/words.hpp"

namespace gonogo::reference::sinumerik {
namespace {

using enum Treatment;
using Code = GCode<Group>;

// SIE-MOD-02. In ascending order.
constexpr auto kLowCodes = std::to_array<Code>({
    {0, Group::motion, read, "traverse"},
    {10, Group::motion, read, "straight feed"},
    {20, Group::motion, read, "arc clockwise"},
    {30, Group::motion, read, "arc counterclockwise"},
    {40, Group::once, read, "dwell"},
    {90, Group::exact_stop, without_effect, "exact stop"},
    {170, Group::plane, read, "plane XY"},
    {180, Group::plane, read, "plane ZX"},
    {190, Group::plane, read, "plane YZ"},
    {250, Group::once, outside, "lower limit of the working area"},
    {260, Group::once, outside, "upper limit of the working area"},
    {330, Group::motion, outside, "thread cutting of constant lead"},
    {340, Group::motion, outside, "thread cutting of growing lead"},
    {350, Group::motion, outside, "thread cutting of falling lead"},
    {400, Group::compensation, without_effect, "radius compensation off"},
    {410, Group::compensation, outside, "radius compensation left"},
    {420, Group::compensation, outside, "radius compensation right"},
    {530, Group::frame, without_effect, "work offset off in the block"},
    {540, Group::offset, without_effect, "work offset 1"},
    {550, Group::offset, without_effect, "work offset 2"},
    {560, Group::offset, without_effect, "work offset 3"},
    {570, Group::offset, without_effect, "work offset 4"},
    {600, Group::path_mode, without_effect, "exact stop, modal"},
    {620, Group::path_mode, outside, "corner deceleration"},
    {630, Group::once, outside, "tapping with a compensating chuck"},
    {640, Group::path_mode, without_effect, "continuous path"},
    {700, Group::units, read, "inch"},
    {710, Group::units, read, "metric"},
    {740, Group::once, outside, "reference point approach"},
    {750, Group::once, outside, "fixed point approach"},
    {900, Group::dimension, read, "absolute"},
    {910, Group::dimension, read, "incremental"},
    {930, Group::feed_mode, outside, "inverse time feed"},
    {940, Group::feed_mode, read, "feed per minute"},
    {950, Group::feed_mode, read, "feed per revolution"},
    {960, Group::feed_mode, outside, "constant cutting speed"},
    {970, Group::feed_mode, outside, "constant cutting speed off"},
    {1100, Group::once, read, "pole from the last position"},
    {1110, Group::once, read, "pole from the workpiece zero"},
    {1120, Group::once, read, "pole from the last pole"},
    {1470, Group::approach, outside, "soft approach along a straight line"},
    {1480, Group::approach, outside, "soft retraction along a straight line"},
    {1530, Group::frame, outside, "all frames off in the block"},
    {1580, Group::once, read, "translation"},
    {2470, Group::approach, outside, "soft approach along a quadrant"},
    {2480, Group::approach, outside, "soft retraction along a quadrant"},
    {2580, Group::once, read, "rotation"},
    {2590, Group::once, read, "rotation, added"},
    {2900, Group::language, outside, "SINUMERIK language"},
    {2910, Group::language, outside, "ISO language"},
    {3310, Group::motion, outside, "rigid tapping"},
    {3320, Group::motion, outside, "retraction of rigid tapping"},
    {3400, Group::approach, outside, "approach in space"},
    {3410, Group::approach, outside, "approach in the plane"},
    {3470, Group::approach, outside, "soft approach along a semicircle"},
    {3480, Group::approach, outside, "soft retraction along a semicircle"},
    {4500, Group::corner, outside, "transition circle at corners"},
    {4510, Group::corner, outside, "intersection at corners"},
    {5000, Group::offset, without_effect, "work offset off"},
});
// G505 to G599 stand between.
constexpr int kFirstOffset = 505;
constexpr int kLastOffset = 599;
constexpr auto kHighCodes = std::to_array<Code>({
    {6010, Group::exact_window, without_effect, "fine exact stop window"},
    {6020, Group::exact_window, without_effect, "coarse exact stop window"},
    {6030, Group::exact_window, outside, "exact stop at the set point"},
    {6410, Group::path_mode, outside, "smoothing by distance"},
    {6420, Group::path_mode, outside, "smoothing by axis tolerances"},
    {7000, Group::units, outside, "inch for feeds too"},
    {7100, Group::units, outside, "metric for feeds too"},
    {9610, Group::feed_mode, outside, "constant cutting speed, feed per minute"},
    {9620, Group::feed_mode, outside, "feed mode of the last speed code"},
    {9710, Group::feed_mode, outside, "constant cutting speed off, feed per minute"},
});

consteval auto all_codes() {
  constexpr std::size_t kOffsets = kLastOffset - kFirstOffset + 1;
  std::array<Code, kLowCodes.size() + kOffsets + kHighCodes.size()> all{};
  auto place = std::copy(kLowCodes.begin(), kLowCodes.end(), all.begin());
  for (int code = kFirstOffset; code <= kLastOffset; ++code) {
    *place++ = {code * 10, Group::offset, outside, "further work offset"};
  }
  std::copy(kHighCodes.begin(), kHighCodes.end(), place);
  return all;
}

constexpr auto kCodes = all_codes();
static_assert(std::ranges::is_sorted(kCodes, {}, &Code::tenths));

constexpr ClauseId kKnown = "SIE-MOD-02"_clause;
constexpr ClauseId kRepeated = "SIE-MOD-05"_clause;
constexpr GCodeTable<Group> kTable{kCodes, kKnown, kRepeated};

// SIE-MOD-02: the codes of frames are the 802S's.
bool is_frame_code(const grammar::Decimal& value) {
  const std::optional<int> tenths = tenths_of(value);
  return tenths == 1580 || tenths == 2580 || tenths == 2590;
}

void read_g_code(Control control, const grammar::Block& block, const grammar::NamedWord& word,
                 CodeReading& reading) {
  const grammar::Word code{'G', block.terms[word.first_term].number, word.where};
  if (control == Control::sinumerik840d && is_frame_code(code.value)) {
    reading.alarms.push_back(undefined_code(code, kKnown));
    return;
  }
  const Code* const known = kTable.find(code.value);
  if (known != nullptr && known->group == Group::once && reading.codes.once >= 0) {
    reading.codes.several_once = true;
  }
  kTable.read_word(code, false, reading);
  reading.codes.once = reading.of(Group::once);
}

// SIE-MOD-01
void read_motion_name(Motion motion, const grammar::NamedWord& word, CodeReading& reading) {
  if (!reading.is_first_of(Group::motion)) {
    reading.alarms.push_back(
        {AlarmClass::duplicate_word, kRepeated, WordName(word.name), word.where,
         fmt::format("{} is the second code of its group in the block.", word.name)});
  }
  reading.codes.motion = motion;
}

// A code that stands by itself, whatever follows it.
bool is_bare_code(Control control, std::string_view name) {
  const bool is_cycle = name == "LCYC75" || name == "LCYC82";
  return name == "CIP" || name == "CT" || (is_cycle && control == Control::sinumerik802s);
}

void read_name(Control control, const grammar::NamedWord& word, CodeReading& reading) {
  if (is_bare_code(control, word.name)) {
    reading.alarms.push_back({AlarmClass::syntax, "SIE-LEX-02"_clause, WordName(word.name),
                              word.where, fmt::format("{} takes no value.", word.name)});
    return;
  }
  const Name* const name = find_name(word);
  if (name == nullptr) {
    reading.alarms.push_back({AlarmClass::undefined_code, kKnown, WordName(word.name), word.where,
                              fmt::format("The control has no code {}.", word.name)});
  } else if (name->treatment == without_effect) {
    reading.warnings.push_back(
        {fmt::format("{} ({}) is passed over: the gauge reads it as without effect on the path.",
                     word.name, name->title),
         word.where});
  } else if (!reading.not_covered) {
    reading.not_covered = NotCovered{
        0, written_name(word),
        fmt::format("{} ({}) is not read by the gauge.", written_name(word), name->title),
        word.where};
  }
}

}  // namespace

std::optional<int> once_code_of(const grammar::Block& block, const grammar::NamedWord& word) {
  if (address_of(word) != Address::g) return std::nullopt;
  const Code* const code = kTable.find(block.terms[word.first_term].number);
  if (code == nullptr || code->group != Group::once) return std::nullopt;
  return code->tenths / 10;
}

Cycle cycle_of(const grammar::NamedWord& word) {
  if (word.terms != 0 || word.is_call) return Cycle::none;
  if (word.name == "LCYC75") return Cycle::lcyc75;
  if (word.name == "LCYC82") return Cycle::lcyc82;
  return Cycle::none;
}

void read_codes(Control control, const grammar::Block& block, CodeReading& reading) {
  reading.clear();
  reading.warnings.clear();
  reading.codes = {};
  for (const grammar::NamedWord& word : block.named) {
    const bool is_bare = word.terms == 0 && !word.is_call;
    const std::optional<Address> address = address_of(word);
    if (address == Address::g) {
      read_g_code(control, block, word, reading);
    } else if (is_bare && word.name == "CIP") {
      read_motion_name(Motion::intermediate, word, reading);
    } else if (is_bare && word.name == "CT") {
      read_motion_name(Motion::tangent, word, reading);
    } else if (control == Control::sinumerik802s && cycle_of(word) != Cycle::none) {
      reading.codes.cycle = cycle_of(word);
    } else if (!address || (address == Address::rpl && control == Control::sinumerik840d)) {
      read_name(control, word, reading);
    }
  }
  BlockCodes& codes = reading.codes;
  if (const int motion = reading.of(Group::motion); motion >= 0 && !codes.motion) {
    codes.motion = static_cast<Motion>(motion);
  }
  codes.plane = reading.of(Group::plane);
  codes.units = reading.of(Group::units);
  codes.dimension = reading.of(Group::dimension);
  codes.feed_mode = reading.of(Group::feed_mode);
}

std::span<const OutsideCode> outside_codes() {
  static const std::vector<OutsideCode> kOutside = [] {
    std::vector<OutsideCode> all = kTable.outside();
    for (const Name& name : names()) {
      if (name.treatment == outside) all.push_back({name.name, name.title});
    }
    return all;
  }();
  return kOutside;
}

std::span<const std::string_view> codes_without_effect() {
  static const std::vector<std::string_view> kNames = [] {
    std::vector<std::string_view> all = {"G9",  "G40", "G53", "G54",  "G55",  "G56",
                                         "G57", "G60", "G64", "G500", "G601", "G602",
                                         "D",   "H",   "M",   "S",    "T"};
    for (const Name& name : names()) {
      if (name.treatment == without_effect) all.push_back(name.name);
    }
    return all;
  }();
  return kNames;
}

}  // namespace gonogo::reference::sinumerik
