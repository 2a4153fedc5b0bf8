// SPDX-License-Identifier: GPL-3.0-or-later
// G94: face and taper cycle.
#include "expanders/gsk/turning.hpp"

namespace gonogo::expanders::gsk {

Flow prepare_face_cycle(Machine& machine, const Block& block, Plan& plan) {
  TurningWords words;
  const Flow flow = take_turning_words(machine, block, machine.state.plane->p, words);
  if (flow != Flow::kContinue || !words.runs) return flow;
  Fixed taper = words.taper;
  if (machine.has(Fault::kTaperSign)) taper = -taper;
  if (machine.has(Fault::kTaperDiameter)) taper /= 2;
  if (!close_path(words.path, taper)) return machine.raise(AlarmKind::kValueOutOfRange, 0);
  if (machine.state.feed == 0) return machine.raise(AlarmKind::kFeedMissing, 0);  // GSK-COM-04
  plan = FaceCycle{words.path};
  return Flow::kContinue;
}

bool perform(Machine& machine, const FaceCycle& cycle) {
  Trace& trace = machine.trace;
  const std::size_t p = machine.state.plane->p;
  const std::size_t q = machine.state.plane->q;
  const Point start = machine.state.position;
  Point to = start;
  Axes axes = axis_bit(p);
  to[p] = cycle.path.b;
  if (machine.has(Fault::kApproachTakesEnd)) {
    to[q] = cycle.path.c_q;
    axes |= axis_bit(q);
  }
  if (!trace.rapid(to, axes)) return false;  // GSK-G94-02: A to B
  to[p] = cycle.path.c_p;
  to[q] = cycle.path.c_q;
  if (!trace.feed(to, axis_bit(p) | axis_bit(q))) return false;  // GSK-G94-03: B to C
  // GSK-G94-04: C to D.
  const bool left = machine.has(Fault::kRapidRetract) ? trace.rapid_axis(p, start[p])
                                                      : trace.feed_axis(p, start[p]);
  if (!left) return false;
  // GSK-G94-05: D to A.
  const bool back = machine.has(Fault::kFeedReturn) ? trace.feed_axis(q, start[q])
                                                    : trace.rapid_axis(q, start[q]);
  if (!back) return false;
  return !machine.has(Fault::kEndsAtB) || trace.rapid_axis(p, cycle.path.b);
}

}  // namespace gonogo::expanders::gsk
