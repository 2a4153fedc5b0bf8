// SPDX-License-Identifier: GPL-3.0-or-later
// G112 and G113: circular pocket by a helix.
#include <algorithm>

#include "expanders/gsk/site.hpp"

namespace gonogo::expanders::gsk {
namespace {

// GSK-G112-01: I and D are modal; L is a number of turns and holds for its block, as R does, or is
// modal (readings gsk.helix.L, gsk.pocket.R).
void take_helix_words(Machine& machine, const Block& block) {
  PocketStore& store = machine.state.pocket;
  const Configuration& configuration = machine.configuration;
  if (!configuration.pocket_r_modal) store.r_plane = {};
  if (!configuration.helix_turns_modal && !machine.has(Fault::kTurnsLeak)) store.turns = {};
  take(machine, block, 'I', store.radius);
  take(machine, block, 'D', store.tool_radius);
  take(machine, block, 'R', store.r_plane);
  if (block.has('L')) store.turns = {true, false, block.number('L').value};
}

Flow check_helix_modal_words(Machine& machine) {
  const PocketStore& store = machine.state.pocket;
  if (!store.radius.present) return machine.raise(AlarmKind::kMissingWord, 'I');
  if (!store.tool_radius.present) return machine.raise(AlarmKind::kMissingWord, 'D');
  return Flow::kContinue;
}

// GSK-G110-16, GSK-G112-02.
Flow check_helix_sizes(Machine& machine) {
  const Fixed radius = machine.state.pocket.radius.value;
  const Fixed tool = machine.state.pocket.tool_radius.value;
  if (radius <= 0) return machine.raise(AlarmKind::kValueOutOfRange, 'I');
  if (tool <= 0) return machine.raise(AlarmKind::kValueOutOfRange, 'D');
  if (radius < tool || (radius == tool && !machine.has(Fault::kHelixToolEqualityAccepted))) {
    return machine.raise(AlarmKind::kToolTooLarge, 'I');
  }
  return Flow::kContinue;
}

Flow prepare_milling(Machine& machine, const Block& block, Helix& helix) {
  const PocketStore& store = machine.state.pocket;
  Flow flow = check_helix_modal_words(machine);
  if (flow == Flow::kContinue) flow = check_helix_sizes(machine);
  if (flow == Flow::kContinue) flow = find_depth(machine, block, store.r_plane, {}, helix.site);
  if (flow != Flow::kContinue) return flow;
  if (helix.site.depth != 0 && machine.state.feed == 0) {
    return machine.raise(AlarmKind::kFeedMissing, 0);  // GSK-COM-04
  }
  helix.reach = store.radius.value - store.tool_radius.value;
  helix.turns = store.turns.present ? static_cast<int>(store.turns.value / kOne) : 1;
  helix.rot = machine.has(Fault::kG113AsG112) ? -1 : sense_of(machine.state.cycle);
  if (machine.has(Fault::kHelixTurnShort)) helix.turns = std::max(helix.turns - 1, 1);
  return Flow::kContinue;
}

// A semicircle between the centre and the circle of radius I - D: it turns the commanded way, so it
// touches that circle (GSK-G112-09). `axis`: the plane axis of its chord.
bool semicircle(Machine& machine, std::size_t axis, Fixed to, int rot) {
  const Plane& plane = *machine.state.plane;
  Point end = machine.state.position;
  Point middle = end;
  middle[axis] += (to - end[axis]) / 2;
  end[axis] = to;
  return machine.trace.arc(middle[plane.p], middle[plane.q], rot, end, 0);
}

// GSK-G112-05: all turns are one helix; reading gsk.helix.flat adds a circle at the bottom.
bool mill_turns(Machine& machine, const Helix& helix) {
  const Plane& plane = *machine.state.plane;
  const Point& centre = helix.site.centre;
  Point end = machine.state.position;
  end[plane.d] = helix.site.r_plane + helix.site.depth;
  if (machine.has(Fault::kHelixDepthFromInitial)) {
    end[plane.d] += helix.site.r_plane - helix.site.initial_plane;
  }
  if (machine.has(Fault::kHelixDepthPerTurn)) {
    end[plane.d] = helix.site.r_plane + helix.site.depth / (helix.turns + 1) * helix.turns;
  }
  const int rot = helix.turns * helix.rot;
  if (!machine.trace.arc(centre[plane.p], centre[plane.q], rot, end, axis_bit(plane.d))) {
    return false;
  }
  const bool flat = machine.configuration.helix_ends_flat != machine.has(Fault::kHelixFlatCircle);
  return !flat || machine.trace.arc(centre[plane.p], centre[plane.q], helix.rot, end, 0);
}

bool mill(Machine& machine, const Helix& helix) {
  const Plane& plane = *machine.state.plane;
  // Reading gsk.helix.entry-side; where it is open this machine enters towards -q.
  const bool at_p = machine.configuration.helix_enters_at_p;
  const std::size_t axis = at_p ? plane.p : plane.q;
  const Fixed middle = helix.site.centre[axis];
  const Fixed circle = at_p ? middle + helix.reach : middle - helix.reach;
  // GSK-G112-04
  const int entry = machine.has(Fault::kHelixEntryWrongWay) ? -helix.rot : helix.rot;
  if (!semicircle(machine, axis, circle, entry)) return false;
  if (!mill_turns(machine, helix)) return false;
  // GSK-G112-06
  Fixed back = middle;
  if (machine.has(Fault::kHelixExitRadius)) {
    const Fixed beyond = machine.state.pocket.tool_radius.value;
    back += at_p ? -beyond : beyond;
  }
  return semicircle(machine, axis, back, helix.rot);
}

}  // namespace

Flow prepare_helix(Machine& machine, const Block& block, bool entering, bool mills, Plan& plan) {
  const Flow ranges = check_ranges(machine, block);
  if (ranges != Flow::kContinue) return ranges;
  take_helix_words(machine, block);
  if (entering) {
    const Flow missing = check_helix_modal_words(machine);
    if (missing != Flow::kContinue) return missing;
  }
  if (!mills) return Flow::kContinue;
  Helix helix;
  Placing placing = Placing::kNothing;
  const Flow centre = find_centre(machine, block, helix.site, placing);
  if (centre != Flow::kContinue) return centre;
  if (placing == Placing::kPosition) plan = positioning(helix.site);
  if (placing != Placing::kMill) return Flow::kContinue;
  const Flow milling = prepare_milling(machine, block, helix);
  if (milling == Flow::kContinue) plan = helix;
  return milling;
}

// GSK-G112-08: F is the speed along the path, as the records have it.
bool perform(Machine& machine, const Helix& helix) {
  if (!approach(machine, helix.site)) return false;  // GSK-G112-03
  if (helix.site.depth != 0 && !mill(machine, helix)) return false;
  if (machine.has(Fault::kHelixEndsAtRPlane)) {
    return machine.trace.rapid_axis(machine.state.plane->d, helix.site.r_plane);
  }
  return machine.trace.rapid_axis(machine.state.plane->d, helix.site.initial_plane);  // GSK-G112-07
}

}  // namespace gonogo::expanders::gsk
