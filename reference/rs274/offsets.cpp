// SPDX-License-Identifier: GPL-3.0-or-later
//
// G10, G28, G30, G43, G43.1, G49, G53 to G59.3, G92 to G92.3.
#include "reference/rs274/offsets.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reference/compared.hpp"
#include "reference/rs274/machine.hpp"
#include "reference/rs274/whole.hpp"

namespace gonogo::reference::rs274 {
namespace {

// NGC-OFS-02: which system a code selects; `tenths` of G54 to G59.3.
std::size_t system_of(int tenths) {
  return static_cast<std::size_t>(tenths <= 590 ? (tenths - 540) / 10 : tenths - 590 + 5);
}

// The words of the block along its axes: mm, or degrees.
template <typename Take>
void each_axis_word(const BlockContext& block, Take take) {
  for (const AxisLetter& letter : kAxisLetters) {
    if (const std::optional<Number> value = block.words.along(letter)) take(letter.axis, *value);
  }
}

// A word that has to be whole; nothing after an alarm.
std::optional<Number> whole_word(BlockContext& block, ClauseId clause, char address) {
  const NearWhole value(block.words.written(address));
  if (value.counts_as_whole(Whole::repeats, block.readings)) return value.nearest();
  block.alarm(AlarmClass::not_an_integer, clause, address,
              with_values(fmt::format("{} is {{}} and not whole.", address),
                          {block.words.written(address)}));
  return std::nullopt;
}

// Puts other offsets in force; nothing moves, so that the program has other coordinates.
template <typename Change>
void change(Machine& machine, Change change_offsets) {
  const Position before = machine.offsets.origin;
  change_offsets(machine.offsets);
  machine.offsets.settle();
  const Position after = machine.offsets.origin;
  for (const Axis axis : kAllAxes) {
    machine.position[axis] = machine.position[axis] + before[axis] - after[axis];
  }
  // NGC-CYC-09: the initial level of a series is a place.
  const Axis depth = axes_of(machine.plane).d;
  std::optional<Series>& series = machine.cycle.series;
  if (series && series->place) *series->place += before[depth] - after[depth];
}

// NGC-OFS-03, NGC-OFS-04: which system P names; nothing after an alarm.
std::optional<std::size_t> named_system(BlockContext& block, ClauseId clause) {
  if (!block.words.has('P')) {
    block.missing(clause, 'P');
    return std::nullopt;
  }
  const std::optional<Number> number = whole_word(block, clause, 'P');
  if (!number) return std::nullopt;
  if (number->sign() < 0 || *number > Number(static_cast<int>(kSystems.size()))) {
    block.alarm(
        AlarmClass::value_out_of_range, clause, 'P',
        with_values("P names the coordinate system in force by 0, or one by 1 to 9; it is {}.",
                    {*number}));
    return std::nullopt;
  }
  const auto place = static_cast<std::size_t>(number->to_int64().value());
  return place == 0 ? block.machine.offsets.system : place - 1;
}

// NGC-OFS-03: G10 L2.
void set_system(BlockContext& block) {
  const std::optional<std::size_t> system = named_system(block, "NGC-OFS-03"_clause);
  if (block.words.has('R') && block.words.written('R').sign() != 0) {
    return block.not_covered(10, 'R', "The gauge does not read the word R of G10, a rotation.");
  }
  if (!system) return;
  change(block.machine, [&](Offsets& offsets) {
    each_axis_word(block,
                   [&](Axis axis, const Number& value) { offsets.systems[*system][axis] = value; });
  });
}

// NGC-OFS-04: G10 L20.
void set_system_here(BlockContext& block) {
  const ClauseId clause = "NGC-OFS-04"_clause;
  const std::optional<std::size_t> system = named_system(block, clause);
  if (block.words.has('R')) {
    block.alarm(AlarmClass::unused_word, clause, 'R', "G10 L20 has no word R.");
  }
  if (!system) return;
  const Position here = block.machine.position;
  change(block.machine, [&](Offsets& offsets) {
    const Position in_force = offsets.systems[offsets.system];
    each_axis_word(block, [&](Axis axis, const Number& value) {
      offsets.systems[*system][axis] = here[axis] + in_force[axis] - value;
    });
  });
}

void run_setting(BlockContext& block) {
  const ClauseId clause = "NGC-OFS-03"_clause;
  if (!block.words.has('L')) return block.missing(clause, 'L');
  const std::optional<Number> number = whole_word(block, clause, 'L');
  if (!number) return;
  const std::int64_t what = number->to_int64().value_or(-1);
  if (what == 2) return set_system(block);
  if (what == 20) return set_system_here(block);
  constexpr std::array<std::int64_t, 4> kToolTable = {0, 1, 10, 11};
  if (std::ranges::find(kToolTable, what) != kToolTable.end()) {
    return block.not_covered(10, 'L',
                             "The gauge does not read the word L of G10 for the tool table.");
  }
  block.alarm(AlarmClass::value_out_of_range, clause, 'L',
              with_values("L of G10 is 0, 1, 2, 10, 11 or 20, and not {}.", {*number}));
}

// NGC-OFS-07: an axis that G92 does not name.
bool keeps_other_axes(const BlockContext& block) {
  const Position& shift = block.machine.offsets.shift;
  const bool matters = std::ranges::any_of(kAxisLetters, [&](const AxisLetter& letter) {
    return !block.words.has(letter.address) && shift[letter.axis].sign() != 0;
  });
  return matters && block.readings.is(ReadingKey::ngc_g92_other_axes, "kept");
}

// NGC-OFS-05
void run_g92(BlockContext& block) {
  if (!block.words.has_axis_word()) return block.missing("NGC-OFS-05"_clause, 'X');
  const bool keeps = keeps_other_axes(block);
  const Position here = block.machine.position;
  change(block.machine, [&](Offsets& offsets) {
    const Position before = offsets.shift;
    if (!keeps) offsets.shift = {};
    each_axis_word(block, [&](Axis axis, const Number& value) {
      offsets.shift[axis] = before[axis] + here[axis] - value;
    });
    offsets.kept_shift = offsets.shift;
  });
}

// NGC-OFS-06: G92.1, G92.2, G92.3.
void run_g92_switch(BlockContext& block, int tenths) {
  change(block.machine, [&](Offsets& offsets) {
    if (tenths == 921) offsets.kept_shift = {};
    offsets.shift = tenths == 923 ? offsets.kept_shift : Position{};
  });
}

// NGC-OFS-11: G28 and G30.
void run_home(BlockContext& block, std::size_t which) {
  const ClauseId clause = "NGC-OFS-11"_clause;
  Machine& machine = block.machine;
  Position to;
  AxisSet axes = commanded_end_point(block, to);
  if (axes.empty()) {
    axes = kEveryAxis;
  } else {
    block.put(block.motion_to(RecordKind::rapid, clause, axes, to));
  }
  const Position origin = machine.offsets.origin;
  for (const Axis axis : kAllAxes) {
    if (axes.has(axis)) to[axis] = machine.offsets.homes[which][axis] - origin[axis];
  }
  block.put(block.motion_to(RecordKind::rapid, clause, axes, to));
}

// NGC-OFS-12: G28.1 and G30.1.
void set_home(Machine& machine, std::size_t which) {
  const Position origin = machine.offsets.origin;
  for (const Axis axis : kAllAxes) {
    machine.offsets.homes[which][axis] = machine.position[axis] + origin[axis];
  }
}

// NGC-OFS-08: the length of the tool that H names, or of the one in the spindle. Nothing where it
// is not known.
std::optional<Number> length_of_tool(BlockContext& block) {
  const ClauseId clause = "NGC-OFS-08"_clause;
  std::optional<Number> tool = block.machine.tool.loaded;
  if (block.words.has('H')) {
    tool = whole_word(block, clause, 'H');
    if (!tool) return std::nullopt;
    if (tool->sign() < 0) {
      block.alarm(AlarmClass::value_sign, clause, 'H',
                  with_values("The number of the tool, {}, is below zero.", {*tool}));
      return std::nullopt;
    }
  }
  if (!tool || tool->sign() == 0) {
    block.not_covered(43, 'H', "Which tool G43 means here depends on the tool changer.");
    return std::nullopt;
  }
  const std::string number = tool->text();
  const auto found = block.profile.tools.find(number);
  if (found != block.profile.tools.end()) return found->second.length;
  block.out.not_covered = lacking_in_profile(
      fmt::format("The length of tool {}", number),
      fmt::format("tools = {{ \"{}\" = {{ length = \"50\" }} }}", number),
      block.places.place_of(block.words.has('H') ? 'H' : 'G').value_or(grammar::Span{}),
      block.line);
  return std::nullopt;
}

// NGC-OFS-08, NGC-OFS-09, NGC-OFS-10
void take_tool_length(BlockContext& block) {
  Position tool = block.machine.offsets.tool;
  switch (block.codes.tool_length) {
    case 490:
      tool = {};
      break;
    case 431:
      if (block.codes.motion >= 0 && block.machine.motion != kNoMotion) {
        block.alarm(AlarmClass::conflicting_words, "NGC-OFS-09"_clause, 'G',
                    "No motion stands beside G43.1.");
      }
      each_axis_word(block, [&](Axis axis, const Number& value) { tool[axis] = value; });
      break;
    case 430: {
      const std::optional<Number> length = length_of_tool(block);
      if (!length) return;
      tool = {};
      tool[Axis::z] = *length;
      break;
    }
    default:
      return;
  }
  change(block.machine, [&](Offsets& offsets) { offsets.tool = tool; });
}

}  // namespace

Offsets::Offsets(const Profile& profile) {
  for (std::size_t i = 0; i < kSystems.size(); ++i) {
    const auto found = profile.offsets.find(std::string(kSystems[i]));
    if (found != profile.offsets.end()) systems[i] = found->second;
  }
  homes[0] = profile.reference_point;
  for (const HomeParameter& parameter : kSecondHome) {
    const Number place = profile.parameter(parameter.name).value_or(0);
    const bool inch = profile.units == Units::inch && is_linear(parameter.axis);
    homes[1][parameter.axis] = inch ? inches(place) : place;
  }
  settle();
}

// NGC-OFS-01
void Offsets::settle() {
  for (const Axis axis : kAllAxes) origin[axis] = systems[system][axis] + shift[axis] + tool[axis];
  is_moved = origin != Position{};
}

void move(Record& record, const Position& by) {
  for (const Axis axis : kAllAxes) {
    if (record.axes.has(axis)) record.to[axis] += by[axis];
  }
  if (record.kind != RecordKind::arc) return;
  const PlaneAxes axes = axes_of(record.plane);
  record.centre[0] += by[axes.p];
  record.centre[1] += by[axes.q];
}

Generator<Item> moved(Generator<Item> items, Position by) {
  while (const Item* item = items.next()) {
    Item other = *item;
    if (auto* const record = std::get_if<Record>(&other)) move(*record, by);
    co_yield other;
  }
}

// NGC-OFS-15: G10, G28, G30, G92 and G43.1 take the axis words of their block.
bool takes_axis_words(const BlockCodes& codes) {
  return codes.once == 100 || codes.once == 280 || codes.once == 300 || codes.once == 920 ||
         codes.tool_length == 431;
}

// NGC-OFS-02: the tool length comes before the coordinate system.
void take_offsets(BlockContext& block) {
  if (block.codes.tool_length >= 0) take_tool_length(block);
  if (block.codes.offset < 0) return;
  change(block.machine, [&](Offsets& offsets) { offsets.system = system_of(block.codes.offset); });
}

void run_once(BlockContext& block) {
  const int once = block.codes.once;
  switch (once) {
    case 40:
      return run_dwell(block);
    case 100:
      return run_setting(block);
    case 280:
    case 300:
      return run_home(block, once == 280 ? 0 : 1);
    case 281:
    case 301:
      return set_home(block.machine, once == 281 ? 0 : 1);
    case 920:
      return run_g92(block);
    case 921:
    case 922:
    case 923:
      return run_g92_switch(block, once);
    default:
      return;
  }
}

// NGC-OFS-13, NGC-OFS-14, NGC-OFS-15
void check_once(BlockContext& block) {
  const int motion = block.machine.motion;
  if (block.codes.once == 530) {
    if (motion != 0 && motion != 1) {
      block.alarm(AlarmClass::conflicting_words, "NGC-OFS-13"_clause, 'G',
                  "G53 needs G0 or G1 in force.");
    }
    if (block.machine.modes.incremental) {
      block.alarm(AlarmClass::conflicting_words, "NGC-OFS-14"_clause, 'G',
                  "G53 has no increments.");
    }
  }
  if (takes_axis_words(block.codes) && block.codes.tool_length != 431 && block.codes.motion >= 0 &&
      motion != kNoMotion) {
    block.alarm(AlarmClass::conflicting_words, "NGC-OFS-15"_clause, 'G',
                "Two codes of the block take its axis words.");
  }
}

}  // namespace gonogo::reference::rs274
