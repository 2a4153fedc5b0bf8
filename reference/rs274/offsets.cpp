// SPDX-License-Identifier: GPL-3.0-or-later
//
// G10 L2 and L20, G28, G30, G52 to G59.3, G92 to G92.3.
#include "reference/rs274/offsets.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/reading_literal.hpp"
#include "reference/rs274/tool_lengths.hpp"

namespace gonogo::reference::rs274 {
namespace {

// NGC-OFS-02: which system a code selects; `tenths` of G54 to G59.3.
std::size_t system_of(int tenths) {
  return static_cast<std::size_t>(tenths <= 590 ? (tenths - 540) / 10 : tenths - 590 + 5);
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

// NGC-OFS-21: P0 of G10 L2, whose origin NIST's interpreter does not set.
bool refuses_system_in_force(BlockContext& block) {
  const bool is_in_force = block.words.has('P') && block.words.written('P').sign() == 0;
  if (!is_in_force || block.readings.is("ngc.g10-p0=in-force"_reading)) return false;
  block.alarm(AlarmClass::value_out_of_range, "NGC-OFS-21"_clause, 'P',
              "P of G10 L2 names a coordinate system by 1 to 9; it is 0.");
  return true;
}

// NGC-OFS-03: what G10 takes for a tool, L2 and L20 do not.
void refuse_word(BlockContext& block, ClauseId clause, char address) {
  if (!block.words.has(address) || block.readings.is("ngc.unused-words=ignored"_reading)) return;
  const std::string_view what = clause == "NGC-OFS-03"_clause ? "L2" : "L20";
  block.alarm(AlarmClass::unused_word, clause, address,
              fmt::format("G10 {} has no word {}.", what, address));
}

void refuse_tool_words(BlockContext& block, ClauseId clause) {
  for (const char address : {'I', 'J', 'Q'}) refuse_word(block, clause, address);
}

// NGC-OFS-03: G10 L2.
void set_system(BlockContext& block) {
  const ClauseId clause = "NGC-OFS-03"_clause;
  const std::optional<std::size_t> system = named_system(block, clause);
  refuse_tool_words(block, clause);
  if (!system || refuses_system_in_force(block)) return;
  change_offsets(block.machine, [&](Offsets& offsets) {
    each_axis_word(block,
                   [&](Axis axis, const Number& value) { offsets.systems[*system][axis] = value; });
    // NGC-OFS-16
    if (block.words.has('R')) offsets.angles[*system] = block.words.written('R');
  });
}

// NGC-OFS-04: G10 L20.
void set_system_here(BlockContext& block) {
  const ClauseId clause = "NGC-OFS-04"_clause;
  const std::optional<std::size_t> system = named_system(block, clause);
  refuse_word(block, clause, 'R');
  refuse_tool_words(block, clause);
  if (!system) return;
  const Offsets& now = block.machine.offsets;
  const Position origin =
      origin_by_words(block, sum(now.systems[*system], now.tool), now.angles[*system], now.shift);
  change_offsets(block.machine, [&](Offsets& offsets) {
    offsets.systems[*system] = difference(origin, offsets.tool);
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
  if (what == 1 || what == 10 || what == 11) return set_tool(block, what);
  if (what == 0) {
    return block.not_covered(10, 'L', "Only the machine knows what a reloaded tool table holds.");
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
  return matters && block.readings.is("ngc.g92-other-axes=kept"_reading);
}

// NGC-OFS-05
void run_g92(BlockContext& block) {
  if (!block.words.has_axis_word()) return block.missing("NGC-OFS-05"_clause, 'X');
  const bool keeps = keeps_other_axes(block);
  const Position here = block.machine.position;
  change_offsets(block.machine, [&](Offsets& offsets) {
    const Position before = offsets.shift;
    if (!keeps) offsets.shift = {};
    each_axis_word(block, [&](Axis axis, const Number& value) {
      offsets.shift[axis] = before[axis] + here[axis] - value;
    });
    offsets.kept_shift = offsets.shift;
  });
}

// NGC-OFS-18
void run_g52(BlockContext& block) {
  if (!block.words.has_axis_word()) return block.missing("NGC-OFS-18"_clause, 'X');
  change_offsets(block.machine, [&](Offsets& offsets) {
    each_axis_word(block, [&](Axis axis, const Number& value) { offsets.shift[axis] = value; });
    offsets.kept_shift = offsets.shift;
  });
}

// NGC-OFS-06: G92.1, G92.2, G92.3.
void run_g92_switch(BlockContext& block, int tenths) {
  change_offsets(block.machine, [&](Offsets& offsets) {
    if (tenths == 921) offsets.kept_shift = {};
    offsets.shift = tenths == 923 ? offsets.kept_shift : Position{};
  });
}

// NGC-OFS-22: the axes that go on to a reference point behind the place `to` that `named` say.
AxisSet axes_to_home(const BlockContext& block, const Position& to, AxisSet named,
                     std::size_t which) {
  const Offsets& offsets = block.machine.offsets;
  const Position here = offsets.frame.to_machine(to);
  // Turned axes that are named are not compared: equal enclosures would never be seen to be equal.
  const auto is_elsewhere = [&](Axis axis) {
    return !named.has(axis) && (here[axis] - offsets.homes[which][axis]).try_sign() != 0;
  };
  const bool matters = block.out.alarms.empty() && std::ranges::any_of(kAllAxes, is_elsewhere);
  return matters && block.readings.is("ngc.g28-axes=all"_reading) ? kEveryAxis : named;
}

// NGC-OFS-11: G28 and G30.
void run_home(BlockContext& block, std::size_t which) {
  const ClauseId clause = "NGC-OFS-11"_clause;
  Machine& machine = block.machine;
  Position to;
  AxisSet axes = commanded_end_point(block, to);
  // NGC-OFS-16: no text says whether the axis that goes there is the machine's or the program's.
  if (machine.offsets.frame.is_turned && axes.has(Axis::x) != axes.has(Axis::y)) {
    return block.not_covered(28, axes.has(Axis::x) ? 'X' : 'Y',
                             "The gauge does not read a way to a reference point along one of two "
                             "axes that are turned.");
  }
  if (axes.empty()) {
    axes = kEveryAxis;
  } else {
    block.put(block.motion_to(RecordKind::rapid, clause, axes, to));
    axes = axes_to_home(block, to, axes, which);
  }
  to = at_machine_places(machine.offsets.frame, to, axes, machine.offsets.homes[which]);
  block.put(block.motion_to(RecordKind::rapid, clause, axes, to));
}

// NGC-OFS-12: G28.1 and G30.1.
void set_home(Machine& machine, std::size_t which) {
  machine.offsets.homes[which] = machine.offsets.frame.to_machine(machine.position);
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

// NGC-OFS-01, NGC-OFS-16: the offset of G92 is along the axes of the program.
void Offsets::settle() {
  frame = Frame(angles[system]);
  frame.origin = sum(sum(systems[system], tool), frame.turned(shift));
  frame.is_moved = frame.is_turned || frame.origin != Position{};
}

// NGC-OFS-15: G10, G28, G30, G52, G92, G43.1 and G43.2 take the axis words of their block.
bool takes_axis_words(const BlockCodes& codes) {
  return codes.once == 100 || codes.once == 280 || codes.once == 300 || codes.once == 520 ||
         codes.once == 920 || codes.tool_length == 431 || codes.tool_length == 432;
}

// NGC-OFS-02: the tool length comes before the coordinate system.
void take_offsets(BlockContext& block) {
  if (block.codes.tool_length >= 0) take_tool_length(block);
  if (block.codes.offset < 0) return;
  change_offsets(block.machine,
                 [&](Offsets& offsets) { offsets.system = system_of(block.codes.offset); });
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
    case 520:
      return run_g52(block);
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

// NGC-OFS-13, NGC-OFS-14, NGC-OFS-15, NGC-OFS-20
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
    const bool is_alone = !block.words.has_axis_word() && block.codes.motion < 0;
    if (is_alone) block.out.accept("NGC-OFS-20"_clause);
  }
  if (takes_axis_words(block.codes) && !sets_tool_length(block.codes) && block.codes.motion >= 0 &&
      motion != kNoMotion) {
    block.alarm(AlarmClass::conflicting_words, "NGC-OFS-15"_clause, 'G',
                "Two codes of the block take its axis words.");
  }
}

}  // namespace gonogo::reference::rs274
