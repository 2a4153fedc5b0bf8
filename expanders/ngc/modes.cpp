// SPDX-License-Identifier: GPL-3.0-or-later
// What the words of a block put in force, and the motion that they ask for.
#include "expanders/ngc/interpreter.hpp"

namespace gonogo::expanders::ngc {
namespace {

constexpr AddressSet kCentreWords{"IJK"};

// NGC-G4-01
void prepare_dwell(Machine& machine, const Block& block, Plan& plan) {
  if (!block.has('P')) return machine.complain(AlarmKind::kMissingWord, 'P', kNowhere);
  const Fixed seconds = block.number('P').value;
  if (seconds < 0) return machine.complain(AlarmKind::kValueSign, 'P', block);
  const auto parts = machine.alters<Fixed>("dwell-in-milliseconds"_fault, 1, 1000);
  plan.dwell = static_cast<Fixed>(scaled(seconds, 1, parts));
}

}  // namespace

// NGC-MOD-01, NGC-CYC-01: in a fixed order, not in that of the line.
void Interpreter::prepare(Plan& plan) {
  State& state = machine_.state;
  const int plane = state.plane;
  const FeedRate feed = state.feed;
  take_feed_mode();
  const bool feed_last = machine_.adds("feed-after-motion"_fault, block_.has('F'));
  if (!feed_last) take_feed();
  take_spindle();
  take_saved(plan);
  if (block_.has_dwell()) prepare_dwell(machine_, block_, plan);
  take_modes();
  const int coming = state.plane;
  if (machine_.adds("plane-after-motion"_fault, coming != plane)) state.plane = plane;
  take_distance();
  take_motion();
  take_retract();
  prepare_motion(plan);
  remember_steps();
  state.plane = coming;
  if (feed_last) take_feed();
  if (is_cycle(state.motion) && machine_.adds("cycle-feed-lost"_fault, state.feed != feed)) {
    state.feed = feed;
  }
  if (block_.has_dwell() &&
      machine_.adds("motion-lost-after-dwell"_fault, state.motion != Motion::kNone)) {
    state.motion = Motion::kNone;
  }
}

// NGC-FED-02
void Interpreter::take_feed_mode() {
  const Code* code = block_.code(Group::kFeedMode);
  if (code == nullptr) return;
  State& state = machine_.state;
  const auto mode = static_cast<FeedMode>(code->tenths);
  const bool changes = mode != state.feed_mode;
  state.feed_mode = mode;
  if (changes ? machine_.spares("feed-survives-its-mode"_fault)
              : machine_.follows("ngc.g94-feed=none"_reading) && !block_.has('F')) {
    state.feed = {};
  }
}

// F counts in the units of the block before: G20 and G21 act later.
void Interpreter::take_feed() {
  if (!block_.has('F')) return;
  const Fixed written = block_.number('F').value;
  if (written < 0) return machine_.complain(AlarmKind::kValueSign, 'F', block_);
  if (machine_.state.feed_mode == FeedMode::kInverseTime) return;
  const Code* units = block_.code(Group::kUnits);
  if (machine_.follows("ngc.feed-units=after"_reading) && units != nullptr) {
    machine_.state.inch = units->tenths == 200;
  }
  machine_.state.feed = {
      machine_.alters("inch-feed-unscaled"_fault, length_of(machine_, written), written), written,
      true};
}

void Interpreter::take_spindle() {
  State& state = machine_.state;
  // NGC-SPD-03: a tool change comes before the spindle's own functions.
  if (block_.has_function(6)) {
    state.spindle = machine_.alters("spindle-turns-after-change"_fault, 5, state.spindle);
  }
  for (const FunctionWord& word : block_.functions()) {
    const Fixed m = word.number.value_or(0);
    if (m >= 3 && m <= 5) state.spindle = static_cast<int>(m);
    if (m == 7 || m == 8) state.coolant |= static_cast<int>(m) - 6;
    if (m == 9) state.coolant = 0;
  }
}

// NGC-SAV-01
void Interpreter::take_saved(Plan& plan) {
  State& state = machine_.state;
  if (block_.has_function(70) || block_.has_function(73)) {
    state.saved = state;
    state.saved_spindle = state.spindle;
    state.saved_coolant = state.coolant;
  }
  if (block_.has_function(71)) state.saved.reset();
  if (!block_.has_function(72)) return;
  if (!state.saved) return machine_.complain(AlarmKind::kMissingWord, 'M', kNowhere);
  if (state.saved_spindle != state.spindle || state.saved_coolant != state.coolant) {
    plan.outside = "M72 for a spindle or coolant";
    return;
  }
  if (state.plane != state.saved->plane &&
      !machine_.follows("ngc.cycle.initial-kept=number"_reading)) {
    state.in_series = false;
  }
  const FeedRate feed = state.feed;
  static_cast<Modes&>(state) = *state.saved;
  // The number comes back, and counts in the units that come back with it.
  if (state.feed.is_programmed) state.feed.linear = length_of(machine_, state.feed.rotary);
  if (machine_.adds("feed-not-restored"_fault, feed != state.feed)) state.feed = feed;
}

void Interpreter::take_modes() {
  State& state = machine_.state;
  if (const Code* code = block_.code(Group::kPlane)) {
    const int plane = code->tenths / 10;
    // NGC-CYC-09
    if (plane != state.plane && !machine_.follows("ngc.cycle.initial-kept=number"_reading))
      state.in_series = false;
    state.plane = plane;
  }
  if (const Code* code = block_.code(Group::kUnits)) state.inch = code->tenths == 200;
  if (const Code* code = block_.code(Group::kLathe)) state.diameter = code->tenths == 70;
  if (const Code* code = block_.code(Group::kSpindle)) {
    state.surface_speed = code->tenths == 960;
    // NGC-SPD-01
    if (state.surface_speed && !block_.has('S')) {
      machine_.complain(AlarmKind::kMissingWord, 'S', kNowhere);
    }
  }
}

void Interpreter::take_distance() {
  State& state = machine_.state;
  if (const Code* code = block_.code(Group::kDistance)) {
    const bool increments = code->tenths == 910;
    bool& absolute = state.leftovers.absolute;
    state.incremental =
        absolute ? machine_.spares("g91-ignored-after-g90"_fault, increments) : increments;
    absolute = absolute || !increments;
  }
  if (const Code* code = block_.code(Group::kArcDistance)) {
    state.absolute_centre = code->tenths == 901;
  }
}

void Interpreter::take_motion() {
  State& state = machine_.state;
  const Code* code = block_.code(Group::kMotion);
  state.first = false;
  if (code == nullptr) return;
  const auto motion = static_cast<Motion>(code->tenths);
  if (motion == Motion::kNone && machine_.adds("g80-keeps-motion"_fault)) return;
  // NGC-CYC-08
  const bool ends_series = !is_cycle(motion);
  if (motion == Motion::kNone ? machine_.spares("initial-survives-g80"_fault) : ends_series) {
    state.in_series = false;
  }
  state.first = motion != state.motion;
  state.motion = motion;
}

// NGC-CYC-10
void Interpreter::take_retract() {
  const Code* code = block_.code(Group::kReturn);
  if (code == nullptr) return;
  bool& to_initial = machine_.state.to_initial;
  to_initial = code->tenths == 980;
  to_initial = machine_.alters("g98-g99-swapped"_fault, to_initial, !to_initial);
  if (is_cycle(machine_.state.motion)) return;
  to_initial = machine_.alters("g99-lost-outside-cycles"_fault, to_initial, true);
}

void Interpreter::remember_steps() {
  for (std::size_t axis = 0; axis < GONOGO_AXES; ++axis) {
    if (!block_.has(kAxisAddress[axis])) continue;
    machine_.state.leftovers.steps[axis] = length_along(machine_, block_, axis);
  }
}

// Whether the block runs the motion code in force: by the code, by an axis word or, an arc, by
// I J K alone (NGC-ARC-06).
bool Interpreter::runs_motion() const {
  if (block_.code(Group::kMotion) != nullptr || block_.has_any(kAxisWords)) return true;
  if (!is_arc(machine_.state.motion) || !block_.has_any(kCentreWords)) return false;
  return !machine_.follows("ngc.arc-words-alone=alarm"_reading) &&
         machine_.spares("arc-words-need-code"_fault);
}

// NGC-COM-02
void Interpreter::check_uses() {
  static constexpr AddressSet kOfCodes{"DEHIJKLPQR"};
  if (machine_.follows("ngc.unused-words=ignored"_reading)) return;
  const Motion motion = machine_.state.motion;
  const bool runs = runs_motion();
  const bool moves = block_.code(Group::kMotion) != nullptr || block_.has_any(kAxisWords);
  const AddressSet taken = runs ? words_of(machine_, motion) : AddressSet{};
  for (char address = 'D'; address <= 'R'; ++address) {
    if (!block_.has(address) || !kOfCodes.has(address)) continue;
    if (taken.has(address) || block_.uses(address)) continue;
    const bool of_another = is_cycle(motion) && (address == 'P' || address == 'Q');
    if (machine_.adds("cycle-takes-any-word"_fault, of_another)) continue;
    if (machine_.adds("unused-word-passed"_fault)) continue;
    if (!moves && machine_.adds("unused-alone-passed"_fault)) continue;
    if (!moves && is_arc(motion) && kCentreWords.has(address) &&
        machine_.has("arc-words-need-code"_fault)) {
      continue;
    }
    machine_.complain(AlarmKind::kUnusedWord, address, block_);
  }
}

// What the reader misses before the motion is looked at.
bool Interpreter::lacks_axis() const {
  const Motion motion = machine_.state.motion;
  if (motion == Motion::kNone) return true;
  if (block_.code(Group::kMotion) == nullptr) return false;
  if (is_cycle(motion)) return !block_.has_any(kLinearWords);
  const bool straight = motion == Motion::kRapid || motion == Motion::kLine;
  return straight && machine_.follows("ngc.bare-motion=missing-word"_reading) &&
         !block_.has_any(kAxisWords);
}

// NGC-SPD-02
void Interpreter::check_spindle() {
  const State& state = machine_.state;
  const bool cuts = state.motion == Motion::kLine || is_arc(state.motion) || is_cycle(state.motion);
  if (cuts && state.surface_speed && state.spindle == 5) {
    machine_.complain(AlarmKind::kSpindleStopped);
  }
}

void Interpreter::prepare_motion(Plan& plan) {
  check_uses();
  plan.reaches_motion = !machine_.in_alarm() && !lacks_axis();
  switch (machine_.state.motion) {
    case Motion::kNone:
      if (block_.has_any(kAxisWords)) machine_.complain(AlarmKind::kMissingWord, 'G', kNowhere);
      return;
    case Motion::kRapid:
    case Motion::kLine:
      if (runs_motion()) check_spindle();
      return prepare_line(machine_, block_, plan);
    default:
      break;
  }
  if (!runs_motion()) return;
  check_spindle();
  switch (machine_.state.motion) {
    case Motion::kArcClockwise:
    case Motion::kArcCounterclockwise:
      return prepare_arc(machine_, block_, plan);
    case Motion::kG33:
    case Motion::kG331:
      return prepare_synchronous(machine_, block_, plan);
    case Motion::kG76:
      return prepare_threading(machine_, block_, plan);
    default:
      return prepare_cycle(machine_, block_, plan);
  }
}

}  // namespace gonogo::expanders::ngc
