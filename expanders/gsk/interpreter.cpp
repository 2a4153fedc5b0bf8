// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/interpreter.hpp"

namespace gonogo::expanders::gsk {
namespace {

// In the order of AlarmKind.
constexpr AlarmNumbers kNumbers{"0003", "0002", "0010", "0014", "0206", "0012", "0023", "0013",
                                "0192", "",     "0021", "",     "",     "0018", "0024", "0196",
                                "",     "0230", "0193", "0207", "0224", "0198"};

/// Codes of one group exclude each other; their numbers in the manual.
enum class Group : GroupNumber {
  kNonModal,  // 00
  kMotion,    // 01
  kSpindle,   // 02
  kFeedMode,  // 05
  kUnits,     // 06
  kRadius,    // 07
  kStroke,    // 09
  kCycle,     // 10
  kMacro,     // 12
  kOffset,    // 14
  kExact,     // 15
  kPlane,     // 16
  kPolar,     // 21
  kCylinder   // 22
};

constexpr CodeRow kRows[] = {
    {Group::kNonModal, Support::kFull, "4 28 50"},
    {Group::kNonModal, Support::kOutside,
     "6.4 6.5 6.6 7.9 10 10.9 25 26 30 31 35 36 37 51.2 51.3 52 53 53.3 65 68.1 70 71 72 73 74 75 "
     "76 78 165 166 211"},
    {Group::kMotion, Support::kFull, "0 1 2 3 90 92 94"},
    {Group::kMotion, Support::kOutside, "2.1 2.2 3.1 3.2 5 32 32.1 32.2 32.3 33 34 92.1 92.2"},
    {Group::kSpindle, Support::kNoEffect, "96 97"},
    {Group::kFeedMode, Support::kFull, "98 99"},
    {Group::kUnits, Support::kFull, "20 21"},
    {Group::kRadius, Support::kNoEffect, "40"},
    {Group::kRadius, Support::kOutside, "41 42"},
    {Group::kStroke, Support::kOutside, "22 23"},
    {Group::kCycle, Support::kFull, "80 110 111 112 113 114 115 116 117"},
    {Group::kCycle, Support::kOutside, "83 84 85 87 88 89"},
    {Group::kMacro, Support::kOutside, "66 67"},
    {Group::kOffset, Support::kNoEffect, "54"},
    {Group::kOffset, Support::kOutside, "55 56 57 58 59"},
    {Group::kExact, Support::kNoEffect, "61 64"},
    {Group::kPlane, Support::kFull, "17 18 19"},
    {Group::kPolar, Support::kOutside, "12.1 13.1"},
    {Group::kCylinder, Support::kOutside, "7.1"},
};
constexpr CodeTable kCodes{kRows};

Motion motion_of(const Code& code) {
  switch (code.tenths) {
    case 900:
      return Motion::kTurnCycle;
    case 920:
      return Motion::kThreadCycle;
    case 940:
      return Motion::kFaceCycle;
    default:
      return static_cast<Motion>(code.tenths / 10);
  }
}

}  // namespace

Machine::Machine(const MachineProfile& machine_profile, const gonogo_sink_v1& sink,
                 Planted<Fault> planted)
    : expanders::Machine(machine_profile, sink, state.position, planted) {
  state.position = profile.position;
  state.plane = &plane_of(profile.plane);
  state.inch = profile.inch;
  state.feed = profile.feed;
  state.motion = static_cast<Motion>(profile.motion);
  state.path_motion = state.motion;
}

Interpreter::Interpreter(const MachineProfile& profile, const gonogo_sink_v1& sink,
                         Planted<Fault> planted)
    : LetterInterpreter(machine_, kNumbers), machine_(profile, sink, planted) {}

Interpreter::Lines Interpreter::lines() const {
  const Counting counting = machine_.has("blank-lines-not-counted"_fault) ? Counting::kWithoutBlank
                            : machine_.has("pairs-counted-twice"_fault)   ? Counting::kPairTwice
                                                                          : Counting::kAll;
  return {counting, machine_.has("alarm-next-block"_fault)};
}

// GSK-COM-07: parameter 3403#6 decides, not gsk.duplicate.
LetterBlock::Manner Interpreter::manner() const {
  const Fixed alarms = machine_.profile.parameters[kDuplicatesAlarm];
  const bool later = alarms < 0 ? machine_.follows("gsk.duplicate=last"_reading) : alarms == 0;
  return {.codes = kCodes, .block_skip = machine_.profile.block_skip, .later_wins = later};
}

bool Interpreter::is_dwell() const {
  return block().has_code(Group::kNonModal, 4);
}

bool Interpreter::is_once() const {
  return block().code(Group::kNonModal) != nullptr;
}

void Interpreter::check_words() {
  const Code* cycle = block().code(Group::kCycle);
  const bool enters = cycle != nullptr && cycle->tenths != 800;
  if (enters && block().code(Group::kMotion) != nullptr) {
    machine_.raise(AlarmKind::kConflictingWords, 'G');  // GSK-MOD-09
  }
}

// GSK-MOD-07, and F: what earlier blocks have left, where the modes of the block are others.
void Interpreter::take_changes(const Measures& before) {
  State& state = machine_.state;
  const bool other_lengths = state.inch != before.inch || state.plane != before.plane;
  if (other_lengths && machine_.follows("gsk.retained=clear"_reading)) state.turning = {};
  if (other_lengths && machine_.follows("gsk.retained=in-plane"_reading)) {
    state.turning.end[state.plane->d] = {};
  }
  if (state.inch != before.inch) keep_numbers();
  const bool other_feed = state.per_revolution != before.per_revolution;
  if (other_feed && machine_.follows("gsk.feed-change=deleted"_reading)) state.feed = 0;
}

// In other units: what the readings have for numbers.
void Interpreter::keep_numbers() {
  State& state = machine_.state;
  const auto rescale = [&](Retained& word) {
    word.value =
        static_cast<Fixed>(state.inch ? scaled(word.value, 254, 10) : scaled(word.value, 10, 254));
  };
  if (machine_.follows("gsk.retained=number"_reading)) {
    for (Retained& word : state.turning.end) rescale(word);
    rescale(state.turning.taper);
  }
  if (!machine_.follows("gsk.pocket.retained=number"_reading)) return;
  PocketStore& pocket = state.pocket;
  for (Retained* word : {&pocket.radius, &pocket.step, &pocket.step_down, &pocket.tool_radius,
                         &pocket.r_plane, &pocket.clearance}) {
    rescale(*word);
  }
  ThreadWords& thread = state.thread;
  for (Retained* word : {&thread.lead, &thread.diameter, &thread.height, &thread.tool,
                         &thread.infeed, &thread.run_out}) {
    rescale(*word);
  }
}

void Interpreter::take_codes() {
  State& state = machine_.state;
  const Measures before{state.plane, state.inch, state.per_revolution};
  if (const Code* units = block().code(Group::kUnits)) state.inch = units->tenths == 200;
  if (const Code* plane = block().code(Group::kPlane)) state.plane = &plane_of(plane->tenths / 10);
  if (const Code* mode = block().code(Group::kFeedMode)) {
    state.per_revolution = mode->tenths == 990;
  }
  take_changes(before);
  gsk::check_words(machine_, block());
  if (machine_.in_alarm()) return;
  const bool in_cycle = state.cycle != Cycle::kNone || is_turning_cycle(state.motion);
  const bool coded =
      block().code(Group::kMotion) != nullptr || block().code(Group::kCycle) != nullptr;
  take_cycle_code(state.plane != before.plane);
  take_motion_code();
  take_feed(in_cycle && !coded);
  if (!is_once()) return;
  // GSK-G94-07, GSK-MOD-08: 00 codes but G04 clear what G94 retained.
  const bool spared = is_dwell() ? !machine_.has("dwell-clears-taper"_fault)
                                 : machine_.has("taper-leaks-past-nonmodal"_fault);
  if (!spared) state.turning = {};
  const bool cancels = machine_.follows("gsk.g94.after-00=cancelled"_reading) && !is_dwell();
  if (cancels && is_turning_cycle(state.motion)) state.motion = Motion::kRapid;
}

void Interpreter::take_feed(bool repeats_cycle) {
  if (!block().has('F')) return;
  const Fixed written = block().number('F').value;
  if (written < 0) return machine_.raise(AlarmKind::kValueSign, 'F');  // GSK-COM-08
  if (repeats_cycle && machine_.has("cycle-feed-stuck"_fault)) return;
  State& state = machine_.state;
  const bool converts = state.inch && !machine_.has("inch-feed"_fault);
  const bool is_lead = state.motion == Motion::kThreadCycle && state.cycle == Cycle::kNone &&
                       !machine_.follows("gsk.g92.lead=feed"_reading);
  (is_lead ? state.lead : state.feed) =
      converts ? static_cast<Fixed>(scaled(written, 254, 10)) : written;
}

// GSK-MOD-01, GSK-MOD-05, GSK-MOD-06.
void Interpreter::take_cycle_code(bool other_plane) {
  State& state = machine_.state;
  entering_ = false;
  if (const Code* code = block().code(Group::kCycle)) {
    if (code->tenths == 800) {
      cancel_cycles();
    } else {
      enter_cycle(static_cast<Cycle>((code->tenths - 1100) / 10 + 1));
    }
  }
  if (state.cycle != Cycle::kNone && (entering_ || other_plane)) {
    state.initial_plane = state.position[state.plane->d];
  }
}

// G80.
void Interpreter::cancel_cycles() {
  State& state = machine_.state;
  const bool from_mode = state.cycle != Cycle::kNone;
  state.cycle = Cycle::kNone;
  if (machine_.has("g80-keeps-g94"_fault) && is_turning_cycle(state.motion)) return;
  if (machine_.has("g80-restores-motion"_fault) && from_mode) return;
  state.turning = {};
  const bool kept = machine_.follows("gsk.g80.motion=kept"_reading);
  if (!kept) state.motion = Motion::kRapid;
  if (kept && is_turning_cycle(state.motion)) state.motion = state.path_motion;
}

void Interpreter::enter_cycle(Cycle cycle) {
  State& state = machine_.state;
  const Mode mode = mode_of(cycle);
  const Mode before = mode_of(state.cycle);
  const bool apart = machine_.follows("gsk.pocket.pair=each"_reading) && !is_thread_milling(mode);
  const bool one = machine_.follows("gsk.thread.mode=one"_reading) && is_thread_milling(mode) &&
                   is_thread_milling(before);
  entering_ = (mode != before && !one) || (apart && cycle != state.cycle);
  state.cycle = cycle;
  // Reading gsk.g94.in-mode.
  if (machine_.follows("gsk.g94.in-mode=clear"_reading)) state.turning = {};
  if (!entering_) return;
  const Retained tool = state.pocket.tool_radius;
  state.pocket = {};
  state.thread = {};
  const bool leaks = machine_.has("tool-leaks-into-helix"_fault) && before == Mode::kPocket;
  if (leaks) state.pocket.tool_radius = tool;
}

void Interpreter::take_motion_code() {
  const Code* code = block().code(Group::kMotion);
  machine_.motion_coded = code != nullptr;
  if (code == nullptr) return;
  State& state = machine_.state;
  const Motion motion = motion_of(*code);
  if (!is_turning_cycle(motion) || state.motion != motion) {
    // GSK-G94-07: another code of the group.
    const Retained taper = state.turning.taper;
    const bool leaks = machine_.has("turning-words-leak"_fault) && is_turning_cycle(state.motion) &&
                       is_turning_cycle(motion);
    if (!leaks) state.turning = {};
    if (machine_.has("taper-leaks-past-motion"_fault)) state.turning.taper = taper;
  } else if (!is_once()) {
    // The words of the block are taken in later.
    if (machine_.follows("gsk.g94.rewrite=clear-all"_reading)) state.turning = {};
    if (machine_.follows("gsk.g94.rewrite=clear"_reading)) state.turning.taper = {};
  }
  state.motion = motion;
  if (!is_turning_cycle(motion)) state.path_motion = motion;
  // GSK-G110-15
  if (!machine_.has("pocket-leaks-past-motion"_fault)) state.cycle = Cycle::kNone;
}

// Words that this expander has a use for, or holds to their range, beside the codes in force.
AddressSet Interpreter::known_words() const {
  constexpr AddressSet kAxes{"XUYVZWCH"};
  constexpr AddressSet kCycle{"XUYVZWCHRILQDEJKP"};
  const bool in_cycle = machine_.state.cycle != Cycle::kNone;
  const bool enters = block().code(Group::kCycle) != nullptr && in_cycle;
  if (is_dwell()) {
    if (enters) return AddressSet{"RILQDEJKPXU"};
    return block().has('P') ? AddressSet{"P"} : AddressSet{"XU"};
  }
  if (is_once()) return enters ? kCycle : kAxes;
  if (in_cycle || is_turning_cycle(machine_.state.motion)) return kCycle;
  const Motion motion = machine_.state.motion;
  if (motion != Motion::kArcClockwise && motion != Motion::kArcCounterclockwise) return kAxes;
  AddressSet known = kAxes;
  known.add('R');
  const std::size_t across = machine_.state.plane->d;
  for (const std::size_t axis : {GONOGO_X, GONOGO_Y, GONOGO_Z}) {
    if (block().has('R') || axis != across) known.add(static_cast<char>('I' + (axis - GONOGO_X)));
  }
  return known;
}

// One of the codes in force takes the words of the block.
void Interpreter::prepare(Plan& plan) {
  take_codes();
  if (machine_.in_alarm()) return;
  // A word that a control may chamfer or round by.
  constexpr AddressSet kAnywhere{"FMST"};
  const char stray = stray_word(block(), known_words(), kAnywhere);
  if (stray != 0) {
    machine_.lacking = stray;
    return;
  }
  prepare_motion(plan);
  // Reading gsk.thread.modal: no longer than its block.
  const bool leaves =
      machine_.follows("gsk.thread.modal=none"_reading) != machine_.has("thread-mode-lost"_fault);
  if (leaves && is_thread_milling(mode_of(machine_.state.cycle))) {
    machine_.state.cycle = Cycle::kNone;
  }
}

void Interpreter::prepare_motion(Plan& plan) {
  const bool in_cycle = machine_.state.cycle != Cycle::kNone;
  if (in_cycle && entering_ && is_once()) prepare_cycle(false, plan);
  if (is_dwell()) return prepare_dwell(machine_, block(), plan);
  if (block().has_code(Group::kNonModal, 28)) return prepare_home(machine_, block(), plan);
  if (block().has_code(Group::kNonModal, 50)) return prepare_rename(machine_, block(), plan);
  if (in_cycle) return prepare_cycle(true, plan);
  switch (machine_.state.motion) {
    case Motion::kFaceCycle:
      return prepare_face_cycle(machine_, block(), plan);
    case Motion::kTurnCycle:
      return prepare_turn_cycle(machine_, block(), plan);
    case Motion::kThreadCycle:
      return prepare_thread_cycle(machine_, block(), plan);
    case Motion::kArcClockwise:
    case Motion::kArcCounterclockwise:
      return prepare_arc(machine_, block(), plan);
    case Motion::kRapid:
    case Motion::kLine:
      return prepare_line(machine_, block(), plan);
  }
}

// `mills`: the axis words of the block are the cycle's.
void Interpreter::prepare_cycle(bool mills, Plan& plan) {
  switch (mode_of(machine_.state.cycle)) {
    case Mode::kPocket:
      return prepare_pocket(machine_, block(), entering_, mills, plan);
    case Mode::kHelix:
      return prepare_helix(machine_, block(), entering_, mills, plan);
    case Mode::kExternalThread:
    case Mode::kInternalThread:
      return prepare_thread_milling(machine_, block(), mills, plan);
    case Mode::kNone:
      break;
  }
}

// GSK-G112-01
LetterInterpreter::Moment Interpreter::moment_of(Fixed m) const {
  const bool clamp = m == 35 && machine_.state.cycle != Cycle::kNone;
  if (clamp && machine_.has("clamp-dropped"_fault)) return Moment::kNever;
  if (clamp && machine_.has("clamp-late"_fault)) return Moment::kBehind;
  return LetterInterpreter::moment_of(m);
}

}  // namespace gonogo::expanders::gsk
