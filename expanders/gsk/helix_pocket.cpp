// SPDX-License-Identifier: GPL-3.0-or-later
// G112 and G113: circular pocket by a helix.
#include <algorithm>

#include "expanders/gsk/site.hpp"

namespace gonogo::expanders::gsk {
namespace {

struct Helix {
  Site site;
  Fixed reach = 0;  ///< I - D: radius of the helix
  int turns = 0;
  int rot = 0;
};

// GSK-G112-01: I and D are modal; L is a number of turns and holds for its block, as R does, or is
// modal (readings gsk.helix.L, gsk.pocket.R).
void take_helix_words(Machine& machine, const Block& block) {
  PocketStore& store = machine.state.pocket;
  if (!machine.follows("gsk.pocket.R=modal"_reading)) store.r_plane = {};
  if (!machine.follows("gsk.helix.L=modal"_reading)) store.turns = {};
  take(machine, block, 'I', store.radius);
  take(machine, block, 'D', store.tool_radius);
  take(machine, block, 'R', store.r_plane);
  if (block.has('L')) store.turns = {true, false, block.number('L').value};
}

void check_words_of_helix(Machine& machine) {
  const PocketStore& store = machine.state.pocket;
  check_present(machine, {{'I', store.radius}, {'D', store.tool_radius}});
}

void prepare_milling(Machine& machine, const Block& block, Helix& helix) {
  const PocketStore& store = machine.state.pocket;
  check_words_of_helix(machine);
  // GSK-G110-16, GSK-G112-02.
  check_positive(machine, {{'I', store.radius}, {'D', store.tool_radius}});
  const Fixed room = store.radius.value - store.tool_radius.value;
  const bool fits = machine.has("helix-tool-equality-accepted"_fault) ? room >= 0 : room > 0;
  if (!fits) machine.raise(AlarmKind::kToolTooLarge, 'I');
  find_depth(machine, block, store.r_plane, {}, helix.site);
  if (helix.site.depth != 0) machine.check_feed();
  helix.reach = room;
  helix.turns = store.turns.present ? static_cast<int>(store.turns.value / kOne) : 1;
  helix.rot = machine.has("g113-as-g112"_fault) ? -1 : sense_of(machine.state.cycle);
  if (machine.has("helix-turn-short"_fault)) helix.turns = std::max(helix.turns - 1, 1);
}

// A semicircle between the centre and the circle of radius I - D: it turns the commanded way, so it
// touches that circle (GSK-G112-09). `axis`: the plane axis of its chord.
bool semicircle(Machine& machine, std::size_t axis, Fixed to, int rot) {
  const Plane& plane = machine.plane();
  Point end = machine.state.position;
  Point middle = end;
  middle[axis] += (to - end[axis]) / 2;
  end[axis] = to;
  return machine.arc(middle[plane.p], middle[plane.q], rot, end, 0);
}

// GSK-G112-05: all turns are one helix; reading gsk.helix.flat adds a circle at the bottom.
bool mill_turns(Machine& machine, const Helix& helix) {
  const Plane& plane = machine.plane();
  const Point& centre = helix.site.centre;
  Point end = machine.state.position;
  end[plane.d] = helix.site.r_plane + helix.site.depth;
  if (machine.has("helix-depth-from-initial"_fault)) {
    end[plane.d] += helix.site.r_plane - helix.site.initial_plane;
  }
  if (machine.has("helix-depth-per-turn"_fault)) {
    end[plane.d] = helix.site.r_plane + helix.site.depth / (helix.turns + 1) * helix.turns;
  }
  const int rot = helix.turns * helix.rot;
  if (!machine.arc(centre[plane.p], centre[plane.q], rot, end, axis_bit(plane.d))) {
    return false;
  }
  const bool flat =
      machine.follows("gsk.helix.flat=on"_reading) != machine.has("helix-flat-circle"_fault);
  return !flat || machine.arc(centre[plane.p], centre[plane.q], helix.rot, end, 0);
}

bool mill(Machine& machine, const Helix& helix) {
  const Plane& plane = machine.plane();
  // Reading gsk.helix.entry-side; where it is open this machine enters towards -q.
  const bool at_p = machine.follows("gsk.helix.entry-side=+p"_reading);
  const std::size_t axis = at_p ? plane.p : plane.q;
  const Fixed middle = helix.site.centre[axis];
  const Fixed circle = at_p ? middle + helix.reach : middle - helix.reach;
  // GSK-G112-04
  const int entry = machine.has("helix-entry-wrong-way"_fault) ? -helix.rot : helix.rot;
  if (!semicircle(machine, axis, circle, entry)) return false;
  if (!mill_turns(machine, helix)) return false;
  // GSK-G112-06
  Fixed back = middle;
  if (machine.has("helix-exit-radius"_fault)) {
    const Fixed beyond = machine.state.pocket.tool_radius.value;
    back += at_p ? -beyond : beyond;
  }
  return semicircle(machine, axis, back, helix.rot);
}

// GSK-G112-08: F is the speed along the path, as the records have it.
bool mill_helix(Machine& machine, const Helix& helix) {
  if (!approach(machine, helix.site)) return false;  // GSK-G112-03
  if (helix.site.depth != 0 && !mill(machine, helix)) return false;
  const bool stays = machine.has("helix-ends-at-r-plane"_fault);
  const Fixed plane = stays ? helix.site.r_plane : helix.site.initial_plane;  // GSK-G112-07
  return retract(machine, helix.site, plane, machine.follows("gsk.helix.return=feed"_reading));
}

}  // namespace

void prepare_helix(Machine& machine, const Block& block, bool entering, bool mills, Plan& plan) {
  check_ranges(machine, block);
  take_helix_words(machine, block);
  if (entering) check_words_of_helix(machine);
  Helix helix;
  if (machine.in_alarm() || !mills || !find_centre(machine, block, helix.site, plan)) return;
  prepare_milling(machine, block, helix);
  plan = [&machine, helix] { return mill_helix(machine, helix); };
}

}  // namespace gonogo::expanders::gsk
