// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/polar.hpp"

#include <array>
#include <cmath>

namespace gonogo::expanders::ngc {
namespace {

const long double kRadian = std::acos(-1.0L) / 180;

long double degrees_of(const Machine& machine, const Block& block) {
  const long double angle = static_cast<long double>(block.number('^').value) / kOne;
  return machine.adds("polar-clockwise"_fault, angle != 0) ? -angle : angle;
}

long double distance_of(const Machine& machine, const Block& block) {
  const Fixed length = length_of(machine, block, '@');
  const Fixed written = block.number('@').value;
  return static_cast<long double>(machine.alters("polar-inch-unscaled"_fault, length, written));
}

// X and Y of an end.
std::array<Wide, 2> place_of(const PolarWay& way, Fixed number) {
  const auto count = static_cast<long double>(number);
  const long double distance = way.distance + count * way.further;
  const long double angle = (way.angle + count * way.turn) * kRadian;
  return {static_cast<Wide>(std::roundl(distance * std::cos(angle))),
          static_cast<Wide>(std::roundl(distance * std::sin(angle)))};
}

// NGC-POL-03
void check(Machine& machine, const Block& block, bool has_direction) {
  for (const char address : {'X', 'Y'}) {
    if (machine.spares("polar-beside-x-passed"_fault, block.has(address))) {
      machine.complain(AlarmKind::kConflictingWords, address, block);
    }
  }
  const bool lacks_angle = !has_direction && machine.state.incremental;
  if (machine.spares("polar-origin-passed"_fault, lacks_angle)) {
    machine.complain(AlarmKind::kMissingWord, 'X', kNowhere);
  }
}

// NGC-POL-02: what is left out stays.
void take_places(const Machine& machine, const Block& block, PolarWay& way) {
  if (block.has('@')) way.distance = distance_of(machine, block);
  if (block.has('^')) {
    way.angle = degrees_of(machine, block);
  } else if (machine.adds("polar-angle-needed"_fault, way.angle != 0)) {
    way.angle = 0;
  }
}

void take_increments(const Machine& machine, const Block& block, PolarWay& way) {
  if (block.has('@')) way.further = distance_of(machine, block);
  if (block.has('^')) way.turn = degrees_of(machine, block);
  way.distance += way.further;
  way.angle += way.turn;
}

}  // namespace

PolarWay polar_way(Machine& machine, const Block& block) {
  const auto x = static_cast<long double>(machine.state.position[GONOGO_X]);
  const auto y = static_cast<long double>(machine.state.position[GONOGO_Y]);
  check(machine, block, x != 0 || y != 0);
  PolarWay way{.distance = std::hypot(x, y), .angle = std::atan2(y, x) / kRadian};
  if (machine.spares("polar-absolute"_fault, machine.state.incremental)) {
    take_increments(machine, block, way);
  } else {
    take_places(machine, block, way);
  }
  return way;
}

void lead_to(Machine& machine, const Block& block, const PolarWay& way, Fixed number,
             Point& place) {
  const char address = block.has('@') ? '@' : '^';
  const auto [x, y] = place_of(way, number);
  place[GONOGO_X] = reached(machine, block, x, address);
  place[GONOGO_Y] = reached(machine, block, y, address);
}

void lead_to(const PolarWay& way, Fixed number, Point& place) {
  const auto [x, y] = place_of(way, number);
  place[GONOGO_X] = static_cast<Fixed>(x);
  place[GONOGO_Y] = static_cast<Fixed>(y);
}

}  // namespace gonogo::expanders::ngc
