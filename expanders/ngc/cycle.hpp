// SPDX-License-Identifier: GPL-3.0-or-later
// What the hole cycles do in a hole, a family a file.
#pragma once

#include "expanders/ngc/plan.hpp"

namespace gonogo::expanders::ngc {

/// The tool in a hole, along the third axis of the plane. Each step is false when the sink has
/// asked to stop.
struct Hole {
  Machine& machine;
  const Cycle& cycle;

  Fixed level() const { return machine.state.position[cycle.plane->d]; }
  bool rapid(Fixed to) const { return machine.tracer.rapid_axis(cycle.plane->d, to); }
  bool feed(Fixed to) const { return machine.tracer.feed_axis(cycle.plane->d, to, cycle.feed); }
  bool dwell() const { return machine.tracer.dwell(cycle.dwell); }
  bool turn(int m) const { return machine.tracer.function(m); }
};

// From R to the level where the cycle ends.
bool drill(const Hole& hole);  // G81, G82
bool peck(const Hole& hole);   // G83, G73
bool bore(const Hole& hole);   // G85, G86, G89
bool tap(const Hole& hole);    // G84, G74

/// 3 for G84, 4 for G74: how the spindle has to turn.
int sense_of_tap(const Machine& machine, Motion code);

}  // namespace gonogo::expanders::ngc
