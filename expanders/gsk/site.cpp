// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/site.hpp"

namespace gonogo::expanders::gsk {

void check_present(Machine& machine, std::initializer_list<GivenWord> words) {
  for (const GivenWord& word : words) {
    if (!word.value.present) machine.raise(AlarmKind::kMissingWord, word.address);
  }
}

void check_positive(Machine& machine, std::initializer_list<GivenWord> words) {
  for (const GivenWord& word : words) {
    const bool wrong = word.value.present && word.value.value <= 0;
    if (wrong) machine.raise(AlarmKind::kValueOutOfRange, word.address);
  }
}

bool find_centre(Machine& machine, const Block& block, Site& site, Plan& plan) {
  site.centre = commanded_point(machine, block, site.axes);
  if (machine.in_alarm()) return false;
  // GSK-G110-14: the axis words are not modal; without all three nothing is milled, or by the
  // reading without that of the depth.
  constexpr Axes kLinear = 1u << GONOGO_X | 1u << GONOGO_Y | 1u << GONOGO_Z;
  const Plane& plane = machine.plane();
  const bool mills_here = machine.follows("gsk.missing-axis=current"_reading);
  const Axes needed = mills_here ? axis_bit(plane.d) : kLinear;
  const bool complete = (site.axes & needed) == needed;
  site.centre[plane.d] = machine.state.position[plane.d];
  site.axes &= ~axis_bit(plane.d);
  if (machine.has("rounded-centre"_fault)) {
    for (const std::size_t axis : {plane.p, plane.q}) {
      Fixed& place = site.centre[axis];
      place = static_cast<Fixed>(scaled(place, 1, kOne / 100)) * (kOne / 100);
    }
  }
  if (!complete && machine.follows("gsk.missing-axis=position"_reading)) {
    plan = [&machine, to = site.centre, axes = site.axes] {
      return machine.tracer.rapid(to, axes);
    };
  }
  return complete;
}

// GSK-G110-01, GSK-G110-04, GSK-G110-17, GSK-G110-18.
void find_depth(Machine& machine, const Block& block, const Retained& to_r_plane,
                const DepthRules& rules, Site& site) {
  const std::size_t d = machine.plane().d;
  const AxisWord word =
      axis_word(machine, block, d, !machine.follows("gsk.x-depth=radius"_reading));
  Fixed distance = to_r_plane.present ? to_r_plane.value : 0;
  if (machine.has("r-plane-ignored"_fault)) distance = 0;
  site.initial_plane = machine.state.initial_plane;
  site.r_plane = site.initial_plane + distance;
  const Fixed bottom = target_of(word, rules.from_initial ? site.initial_plane : site.r_plane);
  if (!fits(site.r_plane) || !fits(bottom)) {
    return machine.raise(AlarmKind::kValueOutOfRange, word.address);
  }
  site.depth = bottom - site.r_plane;
  const bool conflict = sign_of(distance) * sign_of(site.depth) < 0;
  if (conflict && !rules.direction_free && !machine.has("direction-unchecked"_fault)) {
    return machine.raise(AlarmKind::kDirectionConflict, 'R');
  }
  if (site.depth == 0 && machine.follows("gsk.zero-depth=alarm"_reading)) {
    machine.raise(AlarmKind::kValueOutOfRange, word.address);
  }
}

bool approach(Machine& machine, const Site& site) {
  return machine.tracer.rapid(site.centre, site.axes) &&
         machine.tracer.rapid_axis(machine.plane().d, site.r_plane);
}

bool retract(Machine& machine, const Site& site, Fixed plane, bool at_feed) {
  const std::size_t d = machine.plane().d;
  return at_feed && site.depth != 0 ? machine.cut_axis(d, plane)
                                    : machine.tracer.rapid_axis(d, plane);
}

}  // namespace gonogo::expanders::gsk
