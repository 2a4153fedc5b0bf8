// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/turning.hpp"

namespace gonogo::expanders::gsk {
namespace {

// GSK-G94-06: the words of the block replace what was retained, as lengths in mm (GSK-MOD-07).
void retain_words(Machine& machine, const Block& block) {
  TurningStore& store = machine.state.turning;
  if (machine.has("end-point-lost"_fault)) store.end = {};
  if (machine.has("taper-lost"_fault)) store.taper = {};
  for (std::size_t axis = GONOGO_X; axis <= GONOGO_Z; ++axis) {
    const AxisWord word = axis_word(machine, block, axis);
    const bool in_plane = axis != machine.plane().d;
    if (word.present && in_plane) store.end[axis] = {true, word.incremental, word.value};
  }
  take(machine, block, 'R', store.taper);
}

// GSK-G94-08, GSK-G94-12: the address of a word for an axis outside the plane; 0: none.
char off_plane_word(const Machine& machine, const Block& block) {
  for (const std::size_t axis : {machine.plane().d, std::size_t{GONOGO_C}}) {
    const AxisWord word = axis_word(machine, block, axis);
    if (!word.present) continue;
    // Reading gsk.g94.still-axis.
    const Fixed here = machine.state.position[axis];
    const bool still = target_of(word, here) == here;
    if (still && machine.follows("gsk.g94.still-axis=ignored"_reading)) continue;
    return word.address;
  }
  return 0;
}

// GSK-G94-09: a reading says whether G94 looks at the length of its taper.
bool checks_taper(const Machine& machine) {
  const bool checks = machine.state.motion != Motion::kFaceCycle ||
                      machine.follows("gsk.g94.taper-limit=alarm"_reading);
  return checks != machine.has("taper-unchecked"_fault);
}

// GSK-G90-09: a taper against the travel may not be longer than it.
bool taper_too_long(const Machine& machine, Fixed taper, Fixed travel) {
  if (machine.has("taper-zero-travel-refused"_fault) && travel == 0 && taper != 0) return true;
  if (sign_of(taper) * sign_of(travel) >= 0) return false;
  if (machine.has("taper-equality-refused"_fault) && taper == -travel) return true;
  return checks_taper(machine) && magnitude(taper) > magnitude(travel);
}

bool runs(const Machine& machine, const Block& block) {
  const Plane& plane = machine.plane();
  if (axis_word(machine, block, plane.p).present || axis_word(machine, block, plane.q).present ||
      block.has('R')) {
    return true;
  }
  // Reading gsk.g94.empty-block: S, T and M are no words of the cycle.
  const bool is_thread = machine.state.motion == Motion::kThreadCycle;
  const AddressSet own = is_thread ? AddressSet{"FIJKLPQ"} : AddressSet{"F"};
  return machine.follows("gsk.g94.empty-block=repeat"_reading) &&
         (machine.motion_coded || block.has_any(own)) && !machine.state.turning.empty();
}

}  // namespace

TurningWords take_turning_words(Machine& machine, const Block& block, std::size_t positioning) {
  TurningWords words;
  check_ranges(machine, block);
  if (machine.in_alarm()) return words;
  const char off_plane = off_plane_word(machine, block);
  if (off_plane != 0 && !machine.has("off-plane-unchecked"_fault)) {
    machine.raise(AlarmKind::kAxisNotInPlane, off_plane);
    return words;
  }
  words.runs = runs(machine, block);
  if (!words.runs) return words;
  retain_words(machine, block);
  const TurningStore& store = machine.state.turning;
  const Point& start = machine.state.position;
  const Plane& plane = machine.plane();
  // GSK-G94-12: without a word zero travel.
  words.path.c_p = target_of(store.end[plane.p], start[plane.p]);
  words.path.c_q = target_of(store.end[plane.q], start[plane.q]);
  words.path.b = positioning == plane.p ? words.path.c_p : words.path.c_q;
  words.taper = store.taper.present ? store.taper.value : 0;
  if (taper_too_long(machine, words.taper, words.path.b - start[positioning])) {
    machine.raise(AlarmKind::kTaperLimit, 'R');
  }
  return words;
}

void close_path(Machine& machine, TurningPath& path, Fixed taper) {
  path.b += taper;
  if (!fits(path.c_p) || !fits(path.c_q) || !fits(path.b)) {
    machine.raise(AlarmKind::kValueOutOfRange);
  }
}

}  // namespace gonogo::expanders::gsk
