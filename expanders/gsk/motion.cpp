// SPDX-License-Identifier: GPL-3.0-or-later
// G00, G01, G04, G28 and G50.
#include "expanders/gsk/plan.hpp"

namespace gonogo::expanders::gsk {

// GSK-MOD-08: P milliseconds, X or U seconds; neither is a length.
Flow prepare_dwell(Machine& machine, const Block& block, Plan& plan) {
  Dwell dwell;
  char address = 0;
  for (const char candidate : {'P', 'X', 'U'}) {
    if (address == 0 && block.has(candidate)) address = candidate;
  }
  if (address != 0) {
    dwell.seconds = block.number(address).value;
    if (dwell.seconds < 0) return machine.raise(AlarmKind::kValueSign, address);
    if (address == 'P') dwell.seconds = static_cast<Fixed>(scaled(dwell.seconds, 1, 1000));
    if (machine.has(Fault::kDwellHalved) && address == 'X') dwell.seconds /= 2;
  } else if (!machine.configuration.dwell_may_be_empty) {
    return machine.raise(AlarmKind::kMissingWord, 'P');  // reading gsk.dwell-without-word
  }
  plan = dwell;
  return Flow::kContinue;
}

// GSK-MOD-08: by the point of the words to the reference point, in the axes of the words.
Flow prepare_home(Machine& machine, const Block& block, Plan& plan) {
  Home home;
  const Flow flow = commanded_point(machine, block, home.via, home.axes);
  plan = home;
  return flow;
}

Flow prepare_rename(Machine& machine, const Block& block, Plan& plan) {
  Rename rename;
  Axes axes = 0;
  const Flow flow = commanded_point(machine, block, rename.position, axes);
  if (flow != Flow::kContinue) return flow;
  const State& state = machine.state;
  rename.initial_plane = state.initial_plane;
  if (state.cycle != Cycle::kNone && !machine.configuration.initial_plane_kept) {
    // The initial plane of a cycle in force is a place on the machine: it is renamed too (reading
    // gsk.g50.initial-plane).
    const std::size_t d = state.plane->d;
    const Fixed shift = rename.position[d] - state.position[d];
    const Wide plane = static_cast<Wide>(state.initial_plane) + shift;
    if (!fits(plane)) return machine.raise(AlarmKind::kValueOutOfRange, 0);
    rename.initial_plane = static_cast<Fixed>(plane);
  }
  plan = rename;
  return Flow::kContinue;
}

Flow prepare_line(Machine& machine, const Block& block, Plan& plan) {
  Line line;
  const Flow flow = commanded_point(machine, block, line.to, line.axes);
  if (flow != Flow::kContinue || line.axes == 0) return flow;
  line.cut = machine.state.motion == Motion::kLine;
  if (line.cut && machine.state.feed == 0) {
    return machine.raise(AlarmKind::kFeedMissing, 0);  // GSK-COM-04
  }
  plan = line;
  return Flow::kContinue;
}

bool perform(Machine&, const Idle&) {
  return true;
}

bool perform(Machine& machine, const Dwell& dwell) {
  return machine.trace.dwell(dwell.seconds);
}

bool perform(Machine& machine, const Home& home) {
  if (!machine.has(Fault::kHomeDirect) && !machine.trace.rapid(home.via, home.axes)) return false;
  Point to = machine.state.position;
  for (std::size_t axis = 0; axis < to.size(); ++axis) {
    if ((home.axes & axis_bit(axis)) != 0) to[axis] = machine.configuration.reference_point[axis];
  }
  return machine.trace.rapid(to, home.axes);
}

bool perform(Machine& machine, const Rename& rename) {
  machine.state.position = rename.position;
  machine.state.initial_plane = rename.initial_plane;
  return true;
}

bool perform(Machine& machine, const Line& line) {
  return line.cut ? machine.trace.feed(line.to, line.axes)
                  : machine.trace.rapid(line.to, line.axes);
}

}  // namespace gonogo::expanders::gsk
