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

// Under G70: lengths, and with the last alternative the feeds of the pocket.
bool CycleParameters::counts_inches(int number) const {
  const bool all = machine_.follows("sie.lcyc.unit=inch-with-feeds"_reading);
  if (number == 122 || number == 123) return all;
  return is_measured(number) && (all || machine_.follows("sie.lcyc.unit=inch"_reading));
}

Fixed CycleParameters::operator()(int number) {
  const Decimal value = to_counts(machine_.state.parameters[static_cast<std::size_t>(number)]);
  const bool inches = machine_.state.inch && counts_inches(number);
  const Wide length = inches ? scaled(value.value, 254, 10) : value.value;
  if (!value.overflow && in_reach(static_cast<Real>(length))) return static_cast<Fixed>(length);
  complain(AlarmKind::kValueOutOfRange, number);
  return 0;
}

void CycleParameters::complain(AlarmKind kind, int number) {
  machine_.complain(kind, 'R', static_cast<Position>(number));
}

void CycleParameters::check_planes() {
  CycleParameters& r = *this;
  const Fixed start = r(103) + r(102);
  const bool strict = machine_.has("cycle-plane-equality-refused"_fault);
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

Direction heading_along_depth(const Plane& plane) {
  Direction heading{};
  heading[plane.d] = 1;
  return heading;
}

// SIE-LC82-01
void prepare_drilling(Machine& machine, const Block& block, Plan& plan) {
  if (!stands_alone(machine, block)) return;
  const Plane& plane = machine.plane();
  CycleParameters r(machine);
  r.check_planes();
  r.check_not_negative(105);
  const Fixed clearance = r(103) + r(102);
  Fixed seconds = r(105);
  if (machine.has("drill-dwell-ms"_fault)) seconds /= 1000;
  if (machine.has("drill-dwell-forgotten"_fault)) seconds = 0;
  Place start = machine.state.position;
  Place bottom = start;
  Target target{start, axis_bit(plane.d)};
  start[plane.d] = static_cast<Real>(clearance);
  bottom[plane.d] = static_cast<Real>(r(104));
  const bool short_way = machine.has("drill-retract-to-clearance"_fault);
  target.to[plane.d] = static_cast<Real>(short_way ? clearance : r(101));
  const Feed feed = cutting_feed(machine, bottom, true);
  plan = [&machine, &plane, target, start, bottom, seconds, feed] {
    Tracer& tracer = machine.tracer;
    arrive(machine, target, heading_along_depth(plane));
    return tracer.rapid(machine.output(start), target.axes) &&
           tracer.feed(machine.output(bottom), target.axes, feed) && tracer.dwell(seconds) &&
           tracer.rapid(machine.output(target.to), target.axes);
  };
}

}  // namespace gonogo::expanders::sinumerik
