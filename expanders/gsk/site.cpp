// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/site.hpp"

namespace gonogo::expanders::gsk {

Flow find_centre(Machine& machine, const Block& block, Site& site, Placing& placing) {
  const Flow flow = commanded_point(machine, block, site.centre, site.axes);
  if (flow != Flow::kContinue) return flow;
  // GSK-G110-14: the axis words are not modal; without all three nothing is milled.
  constexpr Axes kLinear = 1u << GONOGO_X | 1u << GONOGO_Y | 1u << GONOGO_Z;
  const bool complete = (site.axes & kLinear) == kLinear;
  const bool positions = machine.configuration.incomplete_positions;
  placing = complete ? Placing::kMill : positions ? Placing::kPosition : Placing::kNothing;
  const Plane& plane = *machine.state.plane;
  site.centre[plane.d] = machine.state.position[plane.d];
  site.axes &= ~axis_bit(plane.d);
  if (machine.has(Fault::kRoundedCentre)) {
    for (const std::size_t axis : {plane.p, plane.q}) {
      Fixed& place = site.centre[axis];
      place = static_cast<Fixed>(scaled(place, 1, kOne / 100)) * (kOne / 100);
    }
  }
  return Flow::kContinue;
}

// GSK-G110-01, GSK-G110-04, GSK-G110-17, GSK-G110-18.
Flow find_depth(Machine& machine, const Block& block, const Retained& to_r_plane,
                const DepthRules& rules, Site& site) {
  const std::size_t d = machine.state.plane->d;
  const AxisWord word = axis_word(machine, block, d, !machine.configuration.x_depth_radius);
  Fixed distance = to_r_plane.present ? to_r_plane.value : 0;
  if (machine.has(Fault::kRPlaneIgnored)) distance = 0;
  site.initial_plane = machine.state.initial_plane;
  site.r_plane = site.initial_plane + distance;
  const Fixed bottom = target_of(word, rules.from_initial ? site.initial_plane : site.r_plane);
  if (!fits(site.r_plane) || !fits(bottom)) {
    return machine.raise(AlarmKind::kValueOutOfRange, word.address);
  }
  site.depth = bottom - site.r_plane;
  const bool conflict = sign_of(distance) * sign_of(site.depth) < 0;
  if (conflict && !rules.direction_free && !machine.has(Fault::kDirectionUnchecked)) {
    return machine.raise(AlarmKind::kDirectionConflict, 'R');
  }
  if (site.depth == 0 && machine.configuration.zero_depth_alarms) {
    return machine.raise(AlarmKind::kValueOutOfRange, word.address);
  }
  return Flow::kContinue;
}

bool approach(Machine& machine, const Site& site) {
  return machine.trace.rapid(site.centre, site.axes) &&
         machine.trace.rapid_axis(machine.state.plane->d, site.r_plane);
}

}  // namespace gonogo::expanders::gsk
