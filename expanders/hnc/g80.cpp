// SPDX-License-Identifier: GPL-3.0-or-later
// G80: inside and outside diameters, straight and tapered.
#include "expanders/hnc/machine.hpp"

namespace gonogo::expanders::hnc {

void prepare_turn_cycle(Machine& machine, const Block& block, Plan& plan) {
  Retained& taper = machine.state.store.taper;
  if (machine.has("g80-taper-lost"_fault)) taper = {};
  take_length(machine, block, 'I', taper);
  if (is_idle(machine, block, true, true)) return;
  const CycleEnd end = cycle_end(machine, block, true, true);
  // HNC-G80-02: I is a difference of radii; G36 and G91 do not change that.
  Fixed by = taper.value;
  if (machine.has("g80-taper-diameter"_fault)) by /= 2;
  if (machine.has("g80-taper-sign"_fault)) by = -by;
  const Feed feed = cycle_feed(machine);
  const bool mistaken = machine.has("g80-as-g81"_fault);
  const Fixed b = moved(machine, mistaken ? end.z : end.x, by);
  if (machine.in_alarm()) return;
  keep_end(machine, end);
  const bool rapid_out = !mistaken && machine.has("g80-rapid-retract"_fault);
  plan = [&machine, mistaken, b, end, feed, rapid_out] {
    const std::size_t first = mistaken ? GONOGO_Z : GONOGO_X;
    return cut_around(machine, first, b, end, feed, rapid_out);  // HNC-G80-01
  };
}

}  // namespace gonogo::expanders::hnc
