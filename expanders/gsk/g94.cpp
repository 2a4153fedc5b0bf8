// SPDX-License-Identifier: GPL-3.0-or-later
// G94: face and taper cycle.
#include "expanders/gsk/turning.hpp"

namespace gonogo::expanders::gsk {

void prepare_face_cycle(Machine& machine, const Block& block, Plan& plan) {
  TurningWords words = take_turning_words(machine, block, machine.plane().p);
  if (!words.runs) return;
  Fixed taper = words.taper;
  if (machine.has("taper-sign"_fault)) taper = -taper;
  if (machine.has("taper-diameter"_fault)) taper /= 2;
  close_path(machine, words.path, taper);
  machine.check_feed();
  plan = [&machine, path = words.path] { return cut_face(machine, path); };
}

bool cut_face(Machine& machine, const TurningPath& path) {
  Tracer& tracer = machine.tracer;
  const std::size_t p = machine.plane().p;
  const std::size_t q = machine.plane().q;
  const Point start = machine.state.position;
  Point to = start;
  Axes axes = axis_bit(p);
  to[p] = path.b;
  if (machine.has("approach-takes-end"_fault)) {
    to[q] = path.c_q;
    axes |= axis_bit(q);
  }
  if (!tracer.rapid(to, axes)) return false;  // GSK-G94-02: A to B
  to[p] = path.c_p;
  to[q] = path.c_q;
  if (!machine.cut(to, axis_bit(p) | axis_bit(q))) return false;  // GSK-G94-03: B to C
  // GSK-G94-04: C to D.
  const bool left = machine.has("rapid-retract"_fault) ? tracer.rapid_axis(p, start[p])
                                                       : machine.cut_axis(p, start[p]);
  if (!left) return false;
  // GSK-G94-05: D to A.
  const bool back = machine.has("feed-return"_fault) ? machine.cut_axis(q, start[q])
                                                     : tracer.rapid_axis(q, start[q]);
  if (!back) return false;
  return !machine.has("ends-at-b"_fault) || tracer.rapid_axis(p, path.b);
}

}  // namespace gonogo::expanders::gsk
