// SPDX-License-Identifier: GPL-3.0-or-later
// G114 to G117: words and rules. The motion stands in thread_path.cpp.
#include <algorithm>

#include "expanders/gsk/site.hpp"

namespace gonogo::expanders::gsk {
namespace {

// GSK-MOD-04: no word is modal, so they live as long as their block.
struct Words {
  Retained lead;      // I
  Retained diameter;  // E
  Retained height;    // P
  Retained tool;      // D
  Retained infeed;    // Q
  Retained run_out;   // J
  Retained r_plane;   // R
  Fixed angle = 0;    // K
};

Words read_words(const Machine& machine, const Block& block) {
  Words words;
  take(machine, block, 'I', words.lead);
  take(machine, block, 'E', words.diameter);
  take(machine, block, 'P', words.height);
  take(machine, block, 'D', words.tool);
  take(machine, block, 'Q', words.infeed);
  take(machine, block, 'R', words.r_plane);
  // GSK-G114-02: J and K default to parameters 5921 and 5920.
  const Configuration& configuration = machine.configuration;
  if (!machine.has(Fault::kRunOutParameterIgnored)) {
    words.run_out.value = configuration.run_out_distance;
  }
  if (!machine.has(Fault::kAngleParameterIgnored)) words.angle = configuration.run_out_angle;
  take(machine, block, 'J', words.run_out);
  if (block.has('K')) words.angle = angle_of(machine, block, 'K');
  return words;
}

// GSK-G114-02, GSK-G114-12.
Flow check_given(Machine& machine, const Words& words, Mode mode) {
  if (!words.lead.present) return machine.raise(AlarmKind::kMissingWord, 'I');
  if (!words.diameter.present) return machine.raise(AlarmKind::kMissingWord, 'E');
  if (!words.height.present) return machine.raise(AlarmKind::kMissingWord, 'P');
  if (!words.tool.present) return machine.raise(AlarmKind::kMissingWord, 'D');
  const bool r_required = machine.configuration.thread_r_required && mode == Mode::kInternalThread;
  if (r_required && !words.r_plane.present) return machine.raise(AlarmKind::kMissingWord, 'R');
  return Flow::kContinue;
}

// GSK-G114-02, GSK-G114-03. Whole counts: nothing here is rounded.
Flow check_sizes(Machine& machine, const Words& words, Mode mode) {
  const Fixed tool = words.tool.value;
  const Fixed height = words.height.value;
  if (words.lead.value <= 0) return machine.raise(AlarmKind::kValueOutOfRange, 'I');
  if (words.diameter.value <= 0) return machine.raise(AlarmKind::kValueOutOfRange, 'E');
  if (height <= 0) return machine.raise(AlarmKind::kValueOutOfRange, 'P');
  if (tool <= 0) return machine.raise(AlarmKind::kValueOutOfRange, 'D');
  if (height > tool || (height == tool && machine.has(Fault::kThreadHeightEqualityRefused))) {
    return machine.raise(AlarmKind::kDepthExceedsTool, 'P');
  }
  const bool equal_fits = machine.has(Fault::kBoreEqualityAccepted);
  const Fixed room = words.diameter.value - 2 * tool;
  if (mode == Mode::kInternalThread && (room < 0 || (room == 0 && !equal_fits))) {
    return machine.raise(AlarmKind::kToolTooLarge, 'D');
  }
  return Flow::kContinue;
}

void take_radii(const Machine& machine, const Words& words, Mode mode, ThreadMilling& thread) {
  thread.side = mode == Mode::kExternalThread ? 1 : -1;
  const int tool_side = machine.has(Fault::kThreadToolSide) ? -thread.side : thread.side;
  const Fixed share = machine.has(Fault::kThreadDiameterAsRadius) ? 1 : 2;
  thread.surface = words.diameter.value / share + tool_side * words.tool.value;
  thread.height = words.height.value;
  // GSK-G114-04, GSK-G114-12: Q omitted, 0, or not below P: one pass.
  const bool several = words.infeed.value > 0 && words.infeed.value < thread.height;
  thread.infeed = several ? words.infeed.value : thread.height;
  thread.lead = words.lead.value;
  if (machine.has(Fault::kThreadLeadOff)) {
    thread.lead = static_cast<Fixed>(scaled(thread.lead, 101, 100));
  }
  thread.run_out = words.run_out.value;
  thread.angle = words.angle % (360 * kOne);
}

// All of the path lies within this distance of the centre.
bool in_reach(const Machine& machine, const ThreadMilling& thread) {
  const Wide extent = static_cast<Wide>(magnitude(thread.surface)) + thread.height + thread.run_out;
  for (const std::size_t axis : {machine.state.plane->p, machine.state.plane->q}) {
    if (!fits(extent + magnitude(thread.site.centre[axis]))) return false;
  }
  return true;
}

Flow prepare_milling(Machine& machine, const Block& block, ThreadMilling& thread) {
  const Mode mode = mode_of(machine.state.cycle);
  const Configuration& configuration = machine.configuration;
  const Words words = read_words(machine, block);
  Flow flow = check_given(machine, words, mode);
  if (flow == Flow::kContinue) flow = check_sizes(machine, words, mode);
  const DepthRules rules{
      configuration.thread_direction_free,
      configuration.thread_depth_from_initial != machine.has(Fault::kThreadDepthFromInitial)};
  if (flow == Flow::kContinue) flow = find_depth(machine, block, words.r_plane, rules, thread.site);
  if (flow != Flow::kContinue) return flow;
  if (thread.site.depth != 0 && machine.state.feed == 0) {
    return machine.raise(AlarmKind::kFeedMissing, 0);  // GSK-COM-04
  }
  take_radii(machine, words, mode, thread);
  if (!in_reach(machine, thread)) return machine.raise(AlarmKind::kValueOutOfRange, 0);
  const bool mistaken = machine.has(Fault::kG115AsG114);
  thread.rot = mistaken ? -1 : sense_of(machine.state.cycle);  // GSK-G114-09
  return Flow::kContinue;
}

}  // namespace

// GSK-MOD-04: what a block lacks matters only where it mills.
Flow prepare_thread_milling(Machine& machine, const Block& block, bool mills, Plan& plan) {
  const Flow ranges = check_ranges(machine, block);
  if (ranges != Flow::kContinue || !mills) return ranges;
  ThreadMilling thread;
  Placing placing = Placing::kNothing;
  const Flow centre = find_centre(machine, block, thread.site, placing);
  if (centre != Flow::kContinue) return centre;
  if (placing == Placing::kPosition) plan = positioning(thread.site);
  if (placing != Placing::kMill) return Flow::kContinue;
  const Flow milling = prepare_milling(machine, block, thread);
  if (milling == Flow::kContinue) plan = thread;
  return milling;
}

}  // namespace gonogo::expanders::gsk
