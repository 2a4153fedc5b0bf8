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

bool cut_thread(Machine& machine, const TurningPath& path, Fixed lead) {
  Tracer& tracer = machine.tracer;
  const Plane& plane = machine.plane();
  const Point start = machine.state.position;
  if (!tracer.rapid_axis(plane.q, path.b)) return false;  // A to B
  Point to = start;
  to[plane.p] = path.c_p;
  to[plane.q] = path.c_q;
  const Axes axes = axis_bit(plane.p) | axis_bit(plane.q);
  const bool cut =
      machine.has("g92-cuts-at-feed"_fault) ? machine.cut(to, axes) : tracer.thread(to, axes, lead);
  if (!cut) return false;  // B to C
  // C to D.
  const bool left = machine.has("g92-threads-retract"_fault)
                        ? tracer.thread_axis(plane.q, start[plane.q], lead)
                        : tracer.rapid_axis(plane.q, start[plane.q]);
  return left && tracer.rapid_axis(plane.p, start[plane.p]);  // D to A
}

}  // namespace

void prepare_thread_cycle(Machine& machine, const Block& block, Plan& plan) {
  TurningWords words = take_turning_words(machine, block, machine.plane().q);
  if (changes_thread(block)) machine.lacking = "G92 with this J, K, P, Q, I or L";
  if (!words.runs) return;
  close_path(machine, words.path, words.taper);
  // F is the lead in mm a revolution in either feed mode.
  const bool is_feed = machine.follows("gsk.g92.lead=feed"_reading);
  Fixed lead = is_feed ? machine.state.feed : machine.state.lead;
  if (lead == 0) return machine.raise(AlarmKind::kLeadMissing);
  if (machine.has("g92-lead-in-inches"_fault) && machine.state.inch) {
    lead = static_cast<Fixed>(scaled(lead, 10, 254));
  }
  plan = [&machine, path = words.path, lead] { return cut_thread(machine, path, lead); };
}

}  // namespace gonogo::expanders::gsk
