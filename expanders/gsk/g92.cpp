// SPDX-License-Identifier: GPL-3.0-or-later
// G92: thread cutting cycle. The path of G90 with the cut synchronous to the spindle; the tool
// leaves the thread at rapid.
#include "expanders/gsk/turning.hpp"

namespace gonogo::expanders::gsk {
namespace {

// Words that change the thread (run-out, axial or face, inch threads, starts): only the values that
// change nothing are read.
bool changes_thread(const Block& block) {
  if (block.has('I')) return true;
  for (const char address : {'J', 'K', 'P', 'Q'}) {
    if (block.has(address) && block.number(address).value != 0) return true;
  }
  return block.has('L') && block.number('L').value != kOne;
}

}  // namespace

Flow prepare_thread_cycle(Machine& machine, const Block& block, Plan& plan) {
  TurningWords words;
  const Flow flow = take_turning_words(machine, block, machine.state.plane->q, words);
  if (flow != Flow::kContinue) return flow;
  if (changes_thread(block)) {
    machine.trace.note(GONOGO_NOTE_ERROR, "G92 with this J, K, P, Q, I or L is not implemented.");
    return Flow::kUnsupported;
  }
  if (!words.runs) return Flow::kContinue;
  if (!close_path(words.path, words.taper)) {
    return machine.raise(AlarmKind::kValueOutOfRange, 0);
  }
  // F is the lead in mm a revolution, whatever the feed mode.
  const Fixed lead = machine.configuration.lead_is_feed ? machine.state.feed : machine.state.lead;
  if (lead == 0) return machine.raise(AlarmKind::kLeadMissing, 0);
  ThreadCycle cycle{words.path, lead};
  if (machine.has(Fault::kLeadInInches) && machine.state.inch) {
    cycle.lead = static_cast<Fixed>(scaled(cycle.lead, 10, 254));
  }
  plan = cycle;
  return Flow::kContinue;
}

bool perform(Machine& machine, const ThreadCycle& cycle) {
  Trace& trace = machine.trace;
  const Plane& plane = *machine.state.plane;
  const Point start = machine.state.position;
  if (!trace.rapid_axis(plane.q, cycle.path.b)) return false;  // A to B
  Point to = start;
  to[plane.p] = cycle.path.c_p;
  to[plane.q] = cycle.path.c_q;
  const Axes axes = axis_bit(plane.p) | axis_bit(plane.q);
  const bool cut =
      machine.has(Fault::kThreadAtFeed) ? trace.feed(to, axes) : trace.thread(to, axes, cycle.lead);
  if (!cut) return false;  // B to C
  // C to D.
  const bool left = machine.has(Fault::kThreadFeedRetract)
                        ? trace.thread_axis(plane.q, start[plane.q], cycle.lead)
                        : trace.rapid_axis(plane.q, start[plane.q]);
  return left && trace.rapid_axis(plane.p, start[plane.p]);  // D to A
}

}  // namespace gonogo::expanders::gsk
