// SPDX-License-Identifier: GPL-3.0-or-later
// G00, G01, G04 and G92.
#include "expanders/hnc/motion.hpp"

namespace gonogo::expanders::hnc {

Point commanded_point(Machine& machine, const Block& block, Axes& axes) {
  Point to = machine.state.position;
  axes = 0;
  for (const std::size_t axis : {GONOGO_X, GONOGO_Z}) {
    if (!axis_word(machine, block, axis).present) continue;
    to[axis] = target(machine, block, axis);
    axes |= axis_bit(axis);
  }
  return to;
}

Feed feed_in_force(const Machine& machine) {
  const State& state = machine.state;
  return {state.feed, state.per_revolution && !machine.has(Fault::kRevolutionIgnored)};
}

// P milliseconds; nothing else of the block counts.
void prepare_dwell(Machine& machine, const Block& block, Plan& plan) {
  if (!block.has('P')) return machine.complain(AlarmKind::kMissingWord, 'P', kNowhere);
  const Fixed written = block.number('P').value;
  if (written < 0) return machine.complain(AlarmKind::kValueSign, 'P', block);
  const Fixed parts = machine.has(Fault::kDwellInSeconds) ? 1 : 1000;
  plan = Dwell{static_cast<Fixed>(scaled(written, 1, parts))};
}

// The position gets new work coordinates: X and Z are absolute under G91 too, U and W change those
// in force.
void prepare_rename(Machine& machine, const Block& block, Plan& plan) {
  const State& state = machine.state;
  Rename rename{state.position};
  for (const std::size_t axis : {GONOGO_X, GONOGO_Z}) {
    const AxisWord word = axis_word(machine, block, axis);
    if (!word.present) continue;
    const bool absolute = word.address == 'X' || word.address == 'Z';
    Wide place = word.value;
    if (!absolute) {
      place += state.position[axis];
    } else if (state.frame != nullptr && !machine.has(Fault::kRenameIgnoresOffset)) {
      place += (*state.frame)[axis];
    }
    if (!fits(place)) {
      machine.complain(AlarmKind::kValueOutOfRange, word.address, block);
      continue;
    }
    rename.position[axis] = static_cast<Fixed>(place);
  }
  plan = rename;
}

void prepare_line(Machine& machine, const Block& block, Plan& plan) {
  Line line;
  line.to = commanded_point(machine, block, line.axes);
  if (line.axes == 0) return;
  line.cut = machine.state.motion == Motion::kLine;
  if (line.cut && machine.state.feed == 0) machine.complain(AlarmKind::kFeedMissing);
  plan = line;
}

bool perform(Machine&, const Idle&) {
  return true;
}

bool perform(Machine& machine, const Dwell& dwell) {
  return machine.tracer.dwell(dwell.seconds);
}

bool perform(Machine& machine, const Rename& rename) {
  machine.state.position = rename.position;
  return true;
}

bool perform(Machine& machine, const Line& line) {
  return line.cut ? machine.tracer.feed(line.to, line.axes, feed_in_force(machine))
                  : machine.tracer.rapid(line.to, line.axes);
}

}  // namespace gonogo::expanders::hnc
