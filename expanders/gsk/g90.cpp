// SPDX-License-Identifier: GPL-3.0-or-later
// G90: axial turning and taper cycle, the mirror of G94.
#include "expanders/gsk/turning.hpp"

namespace gonogo::expanders::gsk {

Flow prepare_turn_cycle(Machine& machine, const Block& block, Plan& plan) {
  const Plane& plane = *machine.state.plane;
  TurningWords words;
  const bool mistaken = machine.has(Fault::kTurnAsFace);
  const Flow flow = take_turning_words(machine, block, mistaken ? plane.p : plane.q, words);
  if (flow != Flow::kContinue || !words.runs) return flow;
  Fixed taper = words.taper;
  if (machine.has(Fault::kTurnTaperSign)) taper = -taper;
  if (machine.has(Fault::kTurnTaperDiameter)) taper /= 2;
  if (!close_path(words.path, taper)) return machine.raise(AlarmKind::kValueOutOfRange, 0);
  if (machine.state.feed == 0) return machine.raise(AlarmKind::kFeedMissing, 0);  // GSK-COM-04
  if (mistaken) {
    plan = FaceCycle{words.path};
  } else {
    plan = TurnCycle{words.path};
  }
  return Flow::kContinue;
}

bool perform(Machine& machine, const TurnCycle& cycle) {
  Trace& trace = machine.trace;
  const Plane& plane = *machine.state.plane;
  const Point start = machine.state.position;
  if (!trace.rapid_axis(plane.q, cycle.path.b)) return false;  // A to B
  Point to = start;
  to[plane.p] = cycle.path.c_p;
  to[plane.q] = cycle.path.c_q;
  if (!trace.feed(to, axis_bit(plane.p) | axis_bit(plane.q))) return false;  // B to C
  // C to D.
  const bool left = machine.has(Fault::kTurnRapidRetract)
                        ? trace.rapid_axis(plane.q, start[plane.q])
                        : trace.feed_axis(plane.q, start[plane.q]);
  return left && trace.rapid_axis(plane.p, start[plane.p]);  // D to A
}

}  // namespace gonogo::expanders::gsk
