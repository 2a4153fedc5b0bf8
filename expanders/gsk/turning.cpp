// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/turning.hpp"

namespace gonogo::expanders::gsk {
namespace {

// GSK-G94-06: the words of the block replace what was retained, as lengths in mm (GSK-MOD-07).
void retain_words(Machine& machine, const Block& block) {
  TurningStore& store = machine.state.turning;
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
  return machine.configuration.g94_repeats_empty && !block.empty() &&
         !machine.state.turning.empty();
}

}  // namespace

Flow take_turning_words(Machine& machine, const Block& block, std::size_t positioning,
                        TurningWords& words) {
  const Flow ranges = check_ranges(machine, block);
  words.runs = runs(machine, block);
  if (ranges != Flow::kContinue || !words.runs) return ranges;
  const char off_plane = off_plane_word(machine, block);
  if (off_plane != 0 && !machine.has(Fault::kOffPlaneUnchecked)) {
    return machine.raise(AlarmKind::kAxisNotInPlane, off_plane);
  }
  retain_words(machine, block);
  const TurningStore& store = machine.state.turning;
  const Point& start = machine.state.position;
  const Plane& plane = *machine.state.plane;
  words.path.c_p = end_of(store.end[plane.p], start[plane.p]);
  words.path.c_q = end_of(store.end[plane.q], start[plane.q]);
  words.path.b = positioning == plane.p ? words.path.c_p : words.path.c_q;
  words.taper = store.taper.present ? store.taper.value : 0;
  if (taper_too_long(machine, words.taper, words.path.b - start[positioning])) {
    return machine.raise(AlarmKind::kTaperLimit, 'R');
  }
  return Flow::kContinue;
}

bool close_path(TurningPath& path, Fixed taper) {
  path.b += taper;
  return fits(path.c_p) && fits(path.c_q) && fits(path.b);
}

}  // namespace gonogo::expanders::gsk
