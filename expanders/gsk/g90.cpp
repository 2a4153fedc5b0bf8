// SPDX-License-Identifier: GPL-3.0-or-later
// G90: axial turning and taper cycle, the mirror of G94.
#include "expanders/gsk/turning.hpp"

namespace gonogo::expanders::gsk {

namespace {

bool cut_along(Machine& machine, const TurningPath& path) {
  Tracer& tracer = machine.tracer;
  const Plane& plane = machine.plane();
  const Point start = machine.state.position;
  if (!tracer.rapid_axis(plane.q, path.b)) return false;  // A to B
  Point to = start;
  to[plane.p] = path.c_p;
  to[plane.q] = path.c_q;
  if (!machine.cut(to, axis_bit(plane.p) | axis_bit(plane.q))) return false;  // B to C
  // C to D.
  const bool left = machine.has("g90-rapid-retract"_fault)
                        ? tracer.rapid_axis(plane.q, start[plane.q])
                        : machine.cut_axis(plane.q, start[plane.q]);
  return left && tracer.rapid_axis(plane.p, start[plane.p]);  // D to A
}

}  // namespace

void prepare_turn_cycle(Machine& machine, const Block& block, Plan& plan) {
  const Plane& plane = machine.plane();
  const bool mistaken = machine.has("g90-as-g94"_fault);
  TurningWords words = take_turning_words(machine, block, mistaken ? plane.p : plane.q);
  if (!words.runs) return;
  Fixed taper = words.taper;
  if (machine.has("g90-taper-sign"_fault)) taper = -taper;
  if (machine.has("g90-taper-diameter"_fault)) taper /= 2;
  close_path(machine, words.path, taper);
  machine.check_feed();
  plan = [&machine, path = words.path, mistaken] {
    return mistaken ? cut_face(machine, path) : cut_along(machine, path);
  };
}

}  // namespace gonogo::expanders::gsk
