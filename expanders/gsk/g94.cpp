// SPDX-License-Identifier: GPL-3.0-or-later
// G94: face and taper cycle.
#include "expanders/gsk/plan.hpp"

namespace gonogo::expanders::gsk {
namespace {

// GSK-G94-06: the words of the block replace what was retained, as lengths in mm (GSK-MOD-07).
void take_words(Machine& machine, const Block& block) {
  FaceStore& store = machine.state.face;
  if (machine.has(Fault::kEndPointLost)) store.end = {};
  if (machine.has(Fault::kTaperLost)) store.taper = {};
  for (std::size_t axis = GONOGO_X; axis <= GONOGO_Z; ++axis) {
    const AxisWord word = axis_word(machine, block, axis);
    if (word.present) store.end[axis] = {true, word.incremental, word.value};
  }
  take(machine, block, 'R', store.taper);
}

// GSK-G94-08, GSK-G94-12: the address of a word for an axis outside the plane; 0: none.
char off_plane_word(const Machine& machine, const Block& block) {
  for (const std::size_t axis : {machine.state.plane->d, std::size_t{GONOGO_C}}) {
    const AxisWord word = axis_word(machine, block, axis);
    if (word.present) return word.address;
  }
  return 0;
}

// GSK-G94-09: a taper against the travel may not be longer than it.
bool taper_too_long(const Machine& machine, Fixed taper, Fixed travel) {
  if (machine.has(Fault::kTaperUnchecked)) return false;
  if (machine.has(Fault::kTaperZeroTravelRefused) && travel == 0 && taper != 0) return true;
  if (sign_of(taper) * sign_of(travel) >= 0) return false;
  if (machine.has(Fault::kTaperEqualityRefused)) return magnitude(taper) >= magnitude(travel);
  return magnitude(taper) > magnitude(travel);
}

Fixed end_of(const Retained& word, Fixed from) {
  if (!word.present) return from;  // GSK-G94-12: zero travel
  return word.incremental ? from + word.value : word.value;
}

bool runs(const Machine& machine, const Block& block) {
  if (block.has_any(kAxisAddresses) || block.has('R')) return true;
  // Reading gsk.g94.empty-block.
  return machine.configuration.g94_repeats_empty && !block.empty() && !machine.state.face.empty();
}

}  // namespace

Flow prepare_face_cycle(Machine& machine, const Block& block, Plan& plan) {
  const Flow ranges = check_ranges(machine, block);
  if (ranges != Flow::kContinue || !runs(machine, block)) return ranges;
  const char off_plane = off_plane_word(machine, block);
  if (off_plane != 0 && !machine.has(Fault::kOffPlaneUnchecked)) {
    return machine.raise(AlarmKind::kAxisNotInPlane, off_plane);
  }
  take_words(machine, block);
  const FaceStore& store = machine.state.face;
  const Point& start = machine.state.position;
  const std::size_t p = machine.state.plane->p;
  const std::size_t q = machine.state.plane->q;
  FaceCycle cycle;
  cycle.c_p = end_of(store.end[p], start[p]);
  cycle.c_q = end_of(store.end[q], start[q]);
  Fixed taper = store.taper.present ? store.taper.value : 0;
  if (taper_too_long(machine, taper, cycle.c_p - start[p])) {
    return machine.raise(AlarmKind::kTaperLimit, 'R');
  }
  if (machine.has(Fault::kTaperSign)) taper = -taper;
  if (machine.has(Fault::kTaperDiameter)) taper /= 2;
  cycle.b_p = cycle.c_p + taper;
  if (!fits(cycle.c_p) || !fits(cycle.c_q) || !fits(cycle.b_p)) {
    return machine.raise(AlarmKind::kValueOutOfRange, 0);
  }
  if (machine.state.feed == 0) return machine.raise(AlarmKind::kFeedMissing, 0);  // GSK-COM-04
  plan = cycle;
  return Flow::kContinue;
}

bool perform(Machine& machine, const FaceCycle& cycle) {
  Trace& trace = machine.trace;
  const std::size_t p = machine.state.plane->p;
  const std::size_t q = machine.state.plane->q;
  const Point start = machine.state.position;
  Point to = start;
  Axes axes = axis_bit(p);
  to[p] = cycle.b_p;
  if (machine.has(Fault::kApproachTakesEnd)) {
    to[q] = cycle.c_q;
    axes |= axis_bit(q);
  }
  if (!trace.rapid(to, axes)) return false;  // GSK-G94-02: A to B
  to[p] = cycle.c_p;
  to[q] = cycle.c_q;
  if (!trace.feed(to, axis_bit(p) | axis_bit(q))) return false;  // GSK-G94-03: B to C
  // GSK-G94-04: C to D.
  const bool left = machine.has(Fault::kRapidRetract) ? trace.rapid_axis(p, start[p])
                                                      : trace.feed_axis(p, start[p]);
  if (!left) return false;
  // GSK-G94-05: D to A.
  const bool back = machine.has(Fault::kFeedReturn) ? trace.feed_axis(q, start[q])
                                                    : trace.rapid_axis(q, start[q]);
  if (!back) return false;
  return !machine.has(Fault::kEndsAtB) || trace.rapid_axis(p, cycle.b_p);
}

}  // namespace gonogo::expanders::gsk
