// SPDX-License-Identifier: GPL-3.0-or-later
// G00, G01, G04, G28 and G50.
#include "expanders/gsk/machine.hpp"

namespace gonogo::expanders::gsk {

// GSK-MOD-08: P milliseconds, X or U seconds; neither is a length.
void prepare_dwell(Machine& machine, const Block& block, Plan& plan) {
  char address = 0;
  for (const char candidate : {'P', 'X', 'U'}) {
    if (address == 0 && block.has(candidate)) address = candidate;
  }
  if (address == 0) {
    const bool may = machine.follows("gsk.dwell-without-word=none"_reading);
    return may ? void() : machine.raise(AlarmKind::kMissingWord, 'P');
  }
  Fixed seconds = block.number(address).value;
  if (seconds < 0) return machine.raise(AlarmKind::kValueSign, address);
  if (address == 'P') seconds = static_cast<Fixed>(scaled(seconds, 1, 1000));
  if (machine.has("dwell-halved"_fault) && address == 'X') seconds /= 2;
  plan = [&machine, seconds] { return machine.tracer.dwell(seconds); };
}

// GSK-MOD-08: by the point of the words to the reference point, in the axes of the words.
void prepare_home(Machine& machine, const Block& block, Plan& plan) {
  Axes axes = 0;
  const Point via = commanded_point(machine, block, axes);
  plan = [&machine, via, axes] {
    if (!machine.has("home-direct"_fault) && !machine.tracer.rapid(via, axes)) return false;
    Point to = machine.state.position;
    for (std::size_t axis = 0; axis < to.size(); ++axis) {
      if ((axes & axis_bit(axis)) != 0) to[axis] = machine.profile.reference_point[axis];
    }
    return machine.tracer.rapid(to, axes);
  };
}

// G50. The initial plane of a cycle in force is a place on the machine: it is renamed too (reading
// gsk.g50.initial-plane).
void prepare_rename(Machine& machine, const Block& block, Plan& plan) {
  Axes axes = 0;
  const Point position = commanded_point(machine, block, axes);
  const State& state = machine.state;
  Wide initial_plane = state.initial_plane;
  if (state.cycle != Cycle::kNone && !machine.follows("gsk.g50.initial-plane=kept"_reading)) {
    initial_plane += position[state.plane->d] - state.position[state.plane->d];
    if (!fits(initial_plane)) return machine.raise(AlarmKind::kValueOutOfRange);
  }
  plan = [&machine, position, plane = static_cast<Fixed>(initial_plane)] {
    machine.state.position = position;
    machine.state.initial_plane = plane;
    return true;
  };
}

void prepare_line(Machine& machine, const Block& block, Plan& plan) {
  Axes axes = 0;
  const Point to = commanded_point(machine, block, axes);
  if (axes == 0) return;
  const bool cut = machine.state.motion == Motion::kLine;
  if (cut) machine.check_feed();
  plan = [&machine, to, axes, cut] {
    return cut ? machine.cut(to, axes) : machine.tracer.rapid(to, axes);
  };
}

}  // namespace gonogo::expanders::gsk
