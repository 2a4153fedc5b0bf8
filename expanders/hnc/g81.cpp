// SPDX-License-Identifier: GPL-3.0-or-later
// G81: faces, straight and tapered.
#include "expanders/hnc/machine.hpp"

namespace gonogo::expanders::hnc {

void prepare_face_cycle(Machine& machine, const Block& block, Plan& plan) {
  Retained& taper = machine.state.store.taper;
  const bool ignored = machine.has("g81-taper-ignored"_fault) && !machine.state.incremental;
  if (!ignored) take_length(machine, block, 'K', taper);
  if (is_idle(machine, block, true, true)) return;
  const CycleEnd end = cycle_end(machine, block, true, true);
  // HNC-G81-02
  const Fixed by = machine.has("g81-taper-sign"_fault) ? -taper.value : taper.value;
  const Fixed b = moved(machine, end.z, by);
  const Feed feed = cycle_feed(machine);
  if (machine.in_alarm()) return;
  keep_end(machine, end);
  plan = [&machine, b, end, feed] {
    return cut_around(machine, GONOGO_Z, b, end, feed, false);  // HNC-G81-01
  };
}

}  // namespace gonogo::expanders::hnc
