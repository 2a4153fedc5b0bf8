// SPDX-License-Identifier: GPL-3.0-or-later
// LCYC75: its rules, and what the parameters ask for.
#include <algorithm>
#include <cmath>

#include "expanders/sinumerik/cycles.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

constexpr int kRoughing = 1;
constexpr int kFinishing = 2;

// A radius of the tool in force; 0: none.
Fixed tool_radius(const Machine& machine) {
  const State& state = machine.state;
  const auto& tools = machine.profile.tools;
  const auto tool = state.has_edge ? tools.find(state.tool) : tools.end();
  return tool == tools.end() || state.tool == 0 ? 0 : tool->second;
}

// R`number` as one of two whole numbers, or 0.
int selected(CycleParameters& r, int number, int first, int second) {
  const Fixed value = r(number);
  if (value == first * kOne) return first;
  return value == second * kOne ? second : 0;
}

// 2 or 3 as G2 and G3; 0: neither.
int direction_code(const Machine& machine, CycleParameters& r) {
  if (r(126) != 0) return selected(r, 126, 2, 3);
  if (machine.follows("sie.lc75.no-sense=g2"_reading)) return 2;
  return machine.follows("sie.lc75.no-sense=g3"_reading) ? 3 : 0;
}

struct Sides {
  Fixed length;
  Fixed width;
};

Sides sides_of(const Machine& machine, CycleParameters& r) {
  const bool swapped = machine.has("pocket-sides-swapped"_fault) && machine.state.plane != 17;
  return swapped ? Sides{r(119), r(118)} : Sides{r(118), r(119)};
}

// SIE-LC75-09: of each number alone.
void check_numbers(const Machine& machine, CycleParameters& r) {
  for (const int number : {118, 119}) {
    if (r(number) <= 0) r.complain(AlarmKind::kPocketSize, number);
  }
  for (const int number : {120, 124, 125}) r.check_not_negative(number);
  if (r(121) <= 0) r.complain(AlarmKind::kValueSign, 121);
  for (const int number : {122, 123}) {
    if (r(number) <= 0) r.complain(AlarmKind::kFeedMissing, number);
  }
  if (direction_code(machine, r) == 0) r.complain(AlarmKind::kDirectionParameter, 126);
  if (selected(r, 127, kRoughing, kFinishing) == 0) r.complain(AlarmKind::kMachiningType, 127);
}

// SIE-LC75-03, SIE-LC75-08
void check_tool(Machine& machine, CycleParameters& r, int type) {
  constexpr Position kBehindParameters = 1000;
  const Fixed radius = tool_radius(machine);
  if (radius == 0) return machine.complain(AlarmKind::kNoTool, 'T', kBehindParameters);
  const bool any_rest = type == kFinishing && machine.follows("sie.lc75.finish-limit=none"_reading);
  if (!any_rest && r(124) >= 2 * radius) r.complain(AlarmKind::kAllowanceTooLarge, 124);
  const bool limited = machine.follows("sie.lc75.r125-limit=alarm"_reading);
  if (limited && r(125) >= 2 * radius) r.complain(AlarmKind::kAllowanceTooLarge, 125);
  if (type == 0 || machine.has("pocket-tool-unchecked"_fault)) return;
  const Fixed reach = radius + (type == kRoughing ? r(124) : 0);
  const Fixed room = machine.has("pocket-tool-equality-refused"_fault) ? 2 * reach + 1 : 2 * reach;
  for (const int number : {118, 119}) {
    if (room > r(number)) r.complain(AlarmKind::kToolTooLarge, number);
  }
}

// SIE-LC75-09
void check_pocket(Machine& machine, CycleParameters& r, int type) {
  r.check_planes();
  check_numbers(machine, r);
  check_tool(machine, r, type);
  const State& state = machine.state;
  if (!state.spindle_turns || !state.speed_given) {
    machine.complain(AlarmKind::kSpindleStopped);
  }
  if (type == kRoughing && r(125) >= r(103) - r(104)) {
    r.complain(AlarmKind::kAllowanceTooLarge, 125);
  }
  const bool refused = machine.follows("sie.corner=reject"_reading);
  if (refused && 2 * r(120) > std::min(r(118), r(119))) {
    r.complain(AlarmKind::kPocketSize, 120);
  }
}

// SIE-LC75-08, SIE-LC75-10
void take_area(const Machine& machine, CycleParameters& r, int type, Pocket& pocket) {
  const Sides sides = sides_of(machine, r);
  const bool rough = type == kRoughing;
  const bool keeps_off = (rough && !machine.has("pocket-plane-allowance-forgotten"_fault)) ||
                         machine.has("pocket-strip-left"_fault);
  const auto allowance = static_cast<double>(keeps_off ? r(124) : 0);
  const double off = allowance + pocket.radius;
  const auto length = static_cast<double>(sides.length);
  const auto width = static_cast<double>(sides.width);
  const double corner = std::min({static_cast<double>(r(120)), length / 2, width / 2});
  Area& area = pocket.area;
  area.half_length = std::max(length / 2 - off, 0.);
  area.half_width = std::max(width / 2 - off, 0.);
  double less = off;
  if (machine.has("pocket-corner-gouged"_fault)) less += pocket.radius;
  if (machine.has("pocket-corner-left"_fault)) less -= pocket.radius;
  const double most = std::min(area.half_length, area.half_width);
  area.corner = std::clamp(corner - less, 0., most);
  if (area.corner < static_cast<double>(kOne) * 1e-6) area.corner = 0;
  // What roughing has left reaches farthest into sharp corners, where it has left an arc.
  const auto left = static_cast<double>(r(124));
  const bool sharp = corner - left < pocket.radius;
  const bool all = 2 * (left + pocket.radius) > std::min(length, width);
  const double beyond = all ? std::min(area.half_length, area.half_width) - 0.7 * pocket.radius
                            : left - (sharp ? 1.7 : 2.) * pocket.radius;
  const double passes = std::ceil(beyond / (kBetweenPasses * pocket.radius));
  pocket.inner_passes = static_cast<int>(std::max(passes, all ? 1. : 0.));
}

// SIE-LC75-05, SIE-LC75-06, SIE-LC75-11
void take_levels(const Machine& machine, CycleParameters& r, int type, Levels& levels) {
  const bool from_clearance = machine.follows("sie.infeed-from=clearance"_reading) ||
                              machine.has("pocket-depth-from-clearance"_fault);
  const bool rough = type == kRoughing && !machine.has("pocket-depth-allowance-forgotten"_fault);
  levels.from = r(103) + (from_clearance ? r(102) : 0);
  levels.floor = r(104) + (rough ? r(125) : 0);
  levels.most = r(121);
  levels.equal = !machine.follows("sie.infeed=max-rest"_reading);
  // Thirds and the like are a little too large or too small.
  constexpr Fixed kRest = 10;
  levels.count = (levels.from - levels.floor - kRest + levels.most - 1) / levels.most;
  if (machine.has("pocket-infeeds-rounded-down"_fault)) {
    levels.count = std::max<Fixed>(1, (levels.from - levels.floor) / levels.most);
  }
}

// SIE-LC75-12
int sense_of(const Machine& machine, CycleParameters& r, int type) {
  const int sense = direction_code(machine, r) == 2 ? -1 : 1;
  if (type == kFinishing && machine.has("pocket-finishing-sense-ignored"_fault)) return 1;
  return machine.has("pocket-sense-flipped"_fault) ? -sense : sense;
}

void take_centre(const Machine& machine, CycleParameters& r, Pocket& pocket) {
  const Plane& plane = plane_of(pocket.plane);
  pocket.centre_p = static_cast<Real>(r(116));
  pocket.centre_q = static_cast<Real>(r(117));
  if (!machine.has("pocket-centre-in-base"_fault)) return;
  Place place = machine.frame.to_machine(machine.state.position);
  place[plane.p] = pocket.centre_p;
  place[plane.q] = pocket.centre_q;
  place = machine.frame.to_workpiece(place);
  pocket.centre_p = place[plane.p];
  pocket.centre_q = place[plane.q];
}

Target end_of(const Machine& machine, const Pocket& pocket) {
  const Plane& plane = plane_of(pocket.plane);
  Target target{machine.state.position, plane_axes(plane) | axis_bit(plane.d)};
  target.to[plane.p] = pocket.centre_p;
  target.to[plane.q] = pocket.centre_q;
  const bool short_way = machine.has("pocket-retract-to-clearance"_fault);
  target.to[plane.d] = static_cast<Real>(short_way ? pocket.start : pocket.retract);
  if (machine.has("pocket-ends-off-centre"_fault)) {
    target.to[plane.q] += pocket.area.half_width;
  }
  return target;
}

}  // namespace

// SIE-LC75-01
void prepare_pocket(Machine& machine, const Block& block, Plan& plan) {
  if (!stands_alone(machine, block)) return;
  CycleParameters r(machine);
  const int type = selected(r, 127, kRoughing, kFinishing);
  check_pocket(machine, r, type);
  Pocket pocket;
  pocket.plane = machine.state.plane;
  pocket.retract = r(101);
  pocket.start = r(103) + r(102);
  take_centre(machine, r, pocket);
  if (machine.in_alarm()) return;
  pocket.radius = static_cast<double>(tool_radius(machine));
  take_area(machine, r, type, pocket);
  take_levels(machine, r, type, pocket.levels);
  pocket.strip_only = type == kFinishing;
  // SIE-LC75-07
  const bool walls = r(124) > 0 || machine.has("pocket-contour-only-by-r125"_fault);
  pocket.contour_only = type == kFinishing && walls && r(125) == 0;
  pocket.sense = sense_of(machine, r, type);
  const bool per_revolution = machine.state.feed_per_revolution;
  pocket.depth_feed = {r(122), per_revolution};
  pocket.plane_feed = {r(123), per_revolution};
  if (machine.has("pocket-feeds-swapped"_fault)) std::swap(pocket.depth_feed, pocket.plane_feed);
  plan = [&machine, pocket, target = end_of(machine, pocket)] {
    const bool goes_on = mill_pocket(machine, pocket, target);
    arrive(machine, target, heading_along_depth(plane_of(pocket.plane)));
    return goes_on;
  };
}

}  // namespace gonogo::expanders::sinumerik
