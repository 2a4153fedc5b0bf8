// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/modes.hpp"

#include <fmt/format.h>

#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"
#include "reference/rs274/m_functions.hpp"
#include "reference/rs274/tool_lengths.hpp"

namespace gonogo::reference::rs274 {

void leave_out(BlockContext& block, char address, std::string message) {
  if (!block.out.not_covered) {
    block.not_covered(std::string(1, address), address, std::move(message));
  }
}

namespace {

constexpr bool cuts_by_feed(int motion) {
  return motion >= 1 && motion <= 3;
}

bool takes_x_for_an_offset(const BlockCodes& codes) {
  return codes.once == 100 || codes.once == 520 || codes.once == 920 || codes.tool_length >= 431;
}

// NGC-DIA-02: what no text says of diameters.
void leave_out_diameters(BlockContext& block) {
  const WordModes& modes = block.machine.modes;
  if (block.words.has('X') && block.turns_diameters) {
    leave_out(block, 'X', "No text says whether X in the block of G7 or G8 is a diameter.");
  }
  if (!modes.diameter) return;
  if (block.words.has('X') && takes_x_for_an_offset(block.codes)) {
    leave_out(block, 'X', "No text says whether X of an offset is a diameter.");
  }
  if (block.words.has('I') && modes.absolute_centre) {
    leave_out(block, 'I', "No text says whether I of a centre under G90.1 is a diameter.");
  }
  if (is_hole_cycle(block.machine.motion) && block.machine.plane == Plane::g19) {
    leave_out(block, 'X', "No text says which levels of a cycle along X are diameters.");
  }
}

// What M98 calls, and how often.
void check_count(BlockContext& block, char address) {
  if (!block.words.has(address)) return;
  const Number value = block.words.written(address);
  if (value != value.floor()) {
    block.alarm(AlarmClass::not_an_integer, "NGC-OWD-13"_clause, address,
                with_values(fmt::format("{} of M98 is {{}} and not whole.", address), {value}));
  } else if (value.sign() < 0) {
    block.alarm(AlarmClass::value_sign, "NGC-OWD-13"_clause, address,
                with_values(fmt::format("{} of M98 is {{}}, below zero.", address), {value}));
  }
}

// NGC-OWD-13
void leave_out_other_words(BlockContext& block) {
  for (const grammar::Word& word : block.words.block().words) {
    if (word.address == 'P' || word.address == 'L') continue;
    if (word.address == 'M' && m_number(word, block.readings).value_or(0) >= 98) continue;
    return leave_out(block, 'M', "No text says what M98 and M99 do beside other words.");
  }
}

}  // namespace

void take_overrides(BlockContext& block) {
  const MFunctions& functions = block.functions;
  if (functions.none()) return;
  Overrides& overrides = block.machine.overrides;
  const bool is_on = !block.words.has('P') || block.words.written('P').sign() != 0;
  if (functions[48] || functions[49]) overrides.feed = overrides.speed = functions[48];
  if (functions[50]) overrides.feed = is_on;
  if (functions[51]) overrides.speed = is_on;
  if (functions[52]) overrides.adaptive_feed = is_on;
  if (functions[53]) overrides.feed_hold = is_on;
}

void check_modes(BlockContext& block) {
  if (block.words.has('S')) block.machine.has_speed = block.words.written('S').sign() > 0;
  // NGC-SPD-01
  if (block.codes.speed == 96 && !block.words.has('S')) block.missing("NGC-SPD-01"_clause, 'S');
  if (block.functions[98]) {
    if (!block.words.has('P')) block.missing("NGC-OWD-13"_clause, 'P');
    check_count(block, 'P');
    check_count(block, 'L');
  }
  if (block.functions[98] || block.functions[99]) leave_out_other_words(block);
  leave_out_diameters(block);
}

bool fits_modes(BlockContext& block) {
  const Machine& machine = block.machine;
  const bool cuts = cuts_by_feed(machine.motion) || is_hole_cycle(machine.motion);
  // NGC-SPD-02
  if (cuts && machine.has_surface_speed && !machine.spindle_turns()) {
    block.alarm(AlarmClass::spindle_stopped, "NGC-SPD-02"_clause, 'M',
                "A feed under G96 needs a spindle that turns.");
  }
  const bool revolves = machine.spindle_turns() && machine.has_speed;
  if (cuts && machine.feed_mode == FeedMode::per_revolution && !revolves) {
    block.out.accept("NGC-FED-03"_clause);
  }
  if (!machine.is_inverse_time) return true;
  // NGC-CYC-21
  if (is_hole_cycle(machine.motion)) {
    block.alarm(AlarmClass::conflicting_words, "NGC-CYC-21"_clause, 'G',
                "A cycle does not run in inverse time.");
    return true;  // what else is wrong with its words may be reported in its place
  }
  if (!cuts_by_feed(machine.motion)) return true;
  // NGC-FED-01
  if (!block.words.has('F')) {
    block.alarm(AlarmClass::feed_missing, "NGC-FED-01"_clause, 'F',
                "In inverse time each block that cuts needs an F.");
    return true;  // what else is wrong with its words may be reported in its place
  }
  if (block.words.written('F').sign() != 0) return true;
  leave_out(block, 'F', "No text says how a block takes endless time, as F0 has it.");
  return false;
}

bool SavedModes::restore(const Saved& saved, Machine& machine) const {
  const Machine& from = saved.machine;
  const bool is_alike = from.spindle == machine.spindle && from.has_mist == machine.has_mist &&
                        from.has_flood == machine.has_flood &&
                        from.overrides == machine.overrides &&
                        from.offsets.tool == machine.offsets.tool;
  if (!is_alike) return false;
  if (from.plane != machine.plane) machine.cycle.leave_plane();
  machine.modes = from.modes;
  machine.plane = from.plane;
  machine.feed_mode = from.feed_mode;
  machine.is_inverse_time = from.is_inverse_time;
  // The number that was saved, in the units that are restored.
  machine.feed = from.is_feed_written ? from.modes.length_of(from.rotary_feed) : from.feed;
  machine.rotary_feed = from.rotary_feed;
  machine.is_feed_written = from.is_feed_written;
  machine.has_surface_speed = from.has_surface_speed;
  machine.retract = from.retract;
  change_offsets(machine, [&](Offsets& offsets) { offsets.system = from.offsets.system; });
  return true;
}

void SavedModes::take(BlockContext& block) {
  std::optional<Saved>& saved = by_call_.back();
  if (block.functions[70]) saved = Saved{block.machine};
  if (block.functions[73]) saved = Saved{block.machine, by_call_.size() > 1};
  if (block.functions[71]) saved.reset();
  if (!block.functions[72]) return;
  if (!saved) {
    block.alarm(AlarmClass::missing_word, "NGC-SAV-01"_clause, 'M',
                "M72 has no modes to restore: no M70 saved any here.");
  } else if (!restore(*saved, block.machine)) {
    leave_out(block, 'M',
              "The gauge restores no spindle, coolant, override or tool length that has changed.");
  }
}

bool SavedModes::follow(std::size_t calls, Machine& machine) {
  bool is_restored = true;
  while (by_call_.size() > calls) {
    const std::optional<Saved>& saved = by_call_.back();
    if (saved && saved->returns) is_restored = restore(*saved, machine) && is_restored;
    by_call_.pop_back();
  }
  by_call_.resize(calls);
  return is_restored;
}

}  // namespace gonogo::reference::rs274
