// SPDX-License-Identifier: GPL-3.0-or-later
// LCYC82, and what it has in common with LCYC75.
#include <algorithm>
#include <array>

#include "expanders/sinumerik/cycles.hpp"

namespace gonogo::expanders::sinumerik {

namespace {

// Positions, sizes and allowances; feeds, a dwell and the ways are none.
bool is_measured(int number) {
  constexpr std::array kMeasured{101, 102, 103, 104, 116, 117, 118, 119, 120, 121, 124, 125};
  return std::find(kMeasured.begin(), kMeasured.end(), number) != kMeasured.end();
}

}  // namespace

Fixed CycleParameters::operator()(int number) {
  const Decimal value = to_counts(machine_.state.parameters[static_cast<std::size_t>(number)]);
  if (value.overflow || !in_reach(value.value)) {
    complain(AlarmKind::kValueOutOfRange, number);
    return 0;
  }
  rounded_ = rounded_ || value.finer;
  const bool inches = machine_.configuration.cycles_in_inches && machine_.state.inch;
  if (!inches || !is_measured(number)) return value.value;
  const Wide length = scaled(value.value, 254, 10);
  if (!in_reach(length)) {
    complain(AlarmKind::kValueOutOfRange, number);
    return 0;
  }
  rounded_ = rounded_ || value.value % 5 != 0;  // of 127/5
  return static_cast<Fixed>(length);
}

void CycleParameters::complain(AlarmKind kind, int number) {
  machine_.complain(kind, 'R', static_cast<Position>(number));
}

void CycleParameters::check_planes() {
  CycleParameters& r = *this;
  const Fixed start = r(103) + r(102);
  const bool strict = machine_.has(Fault::kPlaneEqualityRefused);
  if (r(101) < start || (strict && r(101) == start)) complain(AlarmKind::kReferencePlane, 101);
  if (r(104) >= r(103)) complain(AlarmKind::kReferencePlane, 104);
  check_not_negative(102);
}

void CycleParameters::check_not_negative(int number) {
  if ((*this)(number) < 0) complain(AlarmKind::kValueSign, number);
}

// SIE-LC82-03
bool stands_alone(Machine& machine, const Block& block) {
  if (block.items() == 1) return true;
  machine.complain(AlarmKind::kConflictingWords);
  return false;
}

Heading heading_along_depth(const Plane& plane) {
  Heading heading;
  heading.along[plane.d] = 1;
  heading.exact = true;
  return heading;
}

// SIE-LC82-01
void prepare_drilling(Machine& machine, const Block& block, Plan& plan) {
  if (!stands_alone(machine, block)) return;
  const State& state = machine.state;
  const Plane& plane = plane_of(state.plane);
  CycleParameters r(machine);
  r.check_planes();
  r.check_not_negative(105);
  Drilling drilling;
  drilling.axis = plane.d;
  drilling.start = r(103) + r(102);
  drilling.depth = r(104);
  drilling.seconds = r(105);
  if (machine.has(Fault::kDrillDwellMilliseconds)) drilling.seconds /= 1000;
  if (machine.has(Fault::kDrillDwellForgotten)) drilling.seconds = 0;
  Target& target = drilling.target;
  const Axes others = ~axis_bit(plane.d);
  target = {state.position, axis_bit(plane.d), state.rounded & others, state.remainder,
            state.coarse & others};
  target.remainder[plane.d] = 0;
  target.to[plane.d] = machine.has(Fault::kDrillRetractToClearance) ? drilling.start : r(101);
  if (r.rounded()) {
    target.rounded |= axis_bit(plane.d);
    target.coarse |= axis_bit(plane.d);
  }
  Point bottom = target.to;
  bottom[plane.d] = drilling.depth;
  drilling.feed = cutting_feed(machine, bottom, true);
  plan.heading = heading_along_depth(plane);
  plan.motion = drilling;
}

bool perform(Machine& machine, const Drilling& drilling) {
  Tracer& tracer = machine.tracer;
  const Axes axes = axis_bit(drilling.axis);
  Point place = machine.state.position;
  place[drilling.axis] = drilling.start;
  if (!tracer.rapid(machine.frame.to_machine(place), axes)) return false;
  place[drilling.axis] = drilling.depth;
  if (!tracer.feed(machine.frame.to_machine(place), axes, drilling.feed)) return false;
  if (!tracer.dwell(drilling.seconds)) return false;
  return tracer.rapid(machine.frame.to_machine(drilling.target.to), axes);
}

}  // namespace gonogo::expanders::sinumerik
