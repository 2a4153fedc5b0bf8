// SPDX-License-Identifier: GPL-3.0-or-later
// G114 to G117: words and rules. The motion stands in thread_path.cpp.
#include <algorithm>

#include "expanders/gsk/site.hpp"

namespace gonogo::expanders::gsk {
namespace {

// GSK-MOD-04: they live as long as their block, or as the mode.
void take_words(Machine& machine, const Block& block) {
  ThreadWords& words = machine.state.thread;
  if (!machine.follows("gsk.thread.modal=words"_reading)) words = {};
  take(machine, block, 'I', words.lead);
  take(machine, block, 'E', words.diameter);
  take(machine, block, 'P', words.height);
  take(machine, block, 'D', words.tool);
  take(machine, block, 'Q', words.infeed);
  take(machine, block, 'J', words.run_out);
  if (block.has('K')) words.angle = {true, false, angle_of(machine, block, 'K')};
}

// GSK-G114-02: J and K default to parameters 5921 and 5920.
ThreadWords words_in_force(const Machine& machine) {
  ThreadWords words = machine.state.thread;
  if (!words.run_out.present && !machine.has("run-out-parameter-ignored"_fault)) {
    words.run_out.value = machine.profile.parameters[kRunOutDistance];
  }
  if (!words.angle.present && !machine.has("angle-parameter-ignored"_fault)) {
    words.angle.value = machine.profile.parameters[kRunOutAngle];
  }
  return words;
}

// GSK-G114-02, GSK-G114-03, GSK-G114-12. Whole counts: nothing here is rounded.
void check(Machine& machine, const ThreadWords& words, const Retained& r_plane, Mode mode) {
  const bool internal = mode == Mode::kInternalThread;
  const std::initializer_list<GivenWord> needed = {
      {'I', words.lead}, {'E', words.diameter}, {'P', words.height}, {'D', words.tool}};
  check_present(machine, needed);
  if (internal && machine.follows("gsk.thread.r=required"_reading)) {
    check_present(machine, {{'R', r_plane}});
  }
  check_positive(machine, needed);
  const Fixed tool = words.tool.value;
  const Fixed height = words.height.value;
  if (height > tool || (height == tool && machine.has("thread-height-equality-refused"_fault))) {
    machine.raise(AlarmKind::kDepthExceedsTool, 'P');
  }
  const Fixed room = words.diameter.value - 2 * tool;
  const bool fits = room > 0 || machine.has("bore-unchecked"_fault);
  if (internal && !fits) machine.raise(AlarmKind::kToolTooLarge, 'D');
}

void take_radii(const Machine& machine, const ThreadWords& words, Mode mode,
                ThreadMilling& thread) {
  thread.side = mode == Mode::kExternalThread ? 1 : -1;
  const int tool_side = machine.has("thread-tool-side"_fault) ? -thread.side : thread.side;
  const Fixed share = machine.has("thread-diameter-as-radius"_fault) ? 1 : 2;
  thread.surface = words.diameter.value / share + tool_side * words.tool.value;
  thread.height = words.height.value;
  // GSK-G114-04, GSK-G114-12: Q omitted, 0, or not below P: one pass.
  const bool several = words.infeed.value > 0 && words.infeed.value < thread.height;
  thread.infeed = several ? words.infeed.value : thread.height;
  thread.lead = words.lead.value;
  if (machine.has("thread-lead-off"_fault)) {
    thread.lead = static_cast<Fixed>(scaled(thread.lead, 101, 100));
  }
  thread.run_out = words.run_out.value;
  thread.angle = words.angle.value % (360 * kOne);
}

// All of the path lies within this distance of the centre, and a record counts its turns.
bool in_reach(const Machine& machine, const ThreadMilling& thread) {
  constexpr Fixed kMostTurns = 1'000'000'000;
  if (magnitude(thread.site.depth) / std::max<Fixed>(thread.lead, 1) > kMostTurns) return false;
  const Wide extent = static_cast<Wide>(magnitude(thread.surface)) + thread.height + thread.run_out;
  for (const std::size_t axis : {machine.plane().p, machine.plane().q}) {
    if (!fits(extent + magnitude(thread.site.centre[axis]))) return false;
  }
  return true;
}

void prepare_milling(Machine& machine, const Block& block, ThreadMilling& thread) {
  const Mode mode = mode_of(machine.state.cycle);
  const ThreadWords words = words_in_force(machine);
  Retained r_plane;
  take(machine, block, 'R', r_plane);
  check(machine, words, r_plane, mode);
  const DepthRules rules{machine.follows("gsk.thread.direction=free"_reading),
                         machine.follows("gsk.thread.v-from=initial"_reading) !=
                             machine.has("thread-depth-from-initial"_fault)};
  find_depth(machine, block, r_plane, rules, thread.site);
  if (thread.site.depth != 0) machine.check_feed();
  take_radii(machine, words, mode, thread);
  if (!in_reach(machine, thread)) machine.raise(AlarmKind::kValueOutOfRange);
  const bool mistaken = machine.has("g115-as-g114"_fault);
  thread.rot = mistaken ? -1 : sense_of(machine.state.cycle);  // GSK-G114-09
}

}  // namespace

void prepare_thread_milling(Machine& machine, const Block& block, bool mills, Plan& plan) {
  check_ranges(machine, block);
  take_words(machine, block);
  ThreadMilling thread;  // GSK-MOD-04: what a block lacks matters only where it mills
  if (machine.in_alarm() || !mills || !find_centre(machine, block, thread.site, plan)) return;
  prepare_milling(machine, block, thread);
  plan = [&machine, thread] { return mill_thread(machine, thread); };
}

}  // namespace gonogo::expanders::gsk
