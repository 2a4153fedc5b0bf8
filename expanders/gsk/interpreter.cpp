// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/interpreter.hpp"

#include <cstdio>
#include <limits>

#include "expanders/common/program_loop.hpp"

namespace gonogo::expanders::gsk {
namespace {

Counting counting_of(const Machine& machine) {
  if (machine.has(Fault::kBlankLinesNotCounted)) return Counting::kWithoutBlank;
  if (machine.has(Fault::kPairsCountedTwice)) return Counting::kPairTwice;
  return Counting::kAll;
}

Motion motion_of(const Code& code) {
  switch (code.number) {
    case 900:
      return Motion::kTurnCycle;
    case 920:
      return Motion::kThreadCycle;
    case 940:
      return Motion::kFaceCycle;
    default:
      return static_cast<Motion>(code.number / 10);
  }
}

}  // namespace

gonogo_answer Interpreter::run(std::string_view program) {
  std::uint64_t& line = machine_.state.line;
  const Flow flow = run_lines(program, counting_of(machine_), line,
                              [this](std::string_view text) { return run_line(text); });
  const unsigned late = machine_.has(Fault::kAlarmNextBlock) ? 1 : 0;
  auto send_alarm = [&] { machine_.trace.alarm(machine_.alarm, line + late); };
  return close_program(flow, send_alarm, [this] { return machine_.trace.end(); });
}

Flow Interpreter::run_line(std::string_view line) {
  const Configuration& configuration = machine_.configuration;
  switch (block_.read(line, configuration.block_skip, configuration.later_wins)) {
    case Block::Reading::kSyntax:
      return machine_.raise(AlarmKind::kSyntax, block_.last_address());
    case Block::Reading::kTapeMark:
      return any_block_ ? Flow::kEnd : Flow::kContinue;
    case Block::Reading::kSkipped:
      return Flow::kContinue;
    case Block::Reading::kWords:
      break;
  }
  if (block_.begins_program() && any_block_) return unsupported("A second program");
  if (block_.empty()) return Flow::kContinue;
  any_block_ = true;
  return run_block();
}

Flow Interpreter::run_block() {
  Flow flow = check_codes();
  if (flow == Flow::kContinue) flow = take_modal_codes();
  Plan plan;
  if (flow == Flow::kContinue) flow = prepare(plan);
  if (flow == Flow::kContinue) flow = run_functions(true);
  if (flow != Flow::kContinue) return flow;
  const bool goes_on = std::visit([&](const auto& p) { return perform(machine_, p); }, plan);
  // Reading gsk.thread.modal: no longer than its block.
  const bool leaves =
      machine_.configuration.thread_not_modal != machine_.has(Fault::kThreadModeLost);
  if (leaves && is_thread_milling(mode_of(machine_.state.cycle))) {
    machine_.state.cycle = Cycle::kNone;
  }
  return goes_on ? run_functions(false) : Flow::kStopped;
}

Flow Interpreter::unsupported(std::string_view what) {
  return not_implemented(machine_.trace, what);
}

Flow Interpreter::unsupported(char letter, unsigned tenths) {
  char code[16];
  const char* form = tenths % 10 == 0 ? "%c%u" : "%c%u.%u";
  const int size = std::snprintf(code, sizeof code, form, letter, tenths / 10, tenths % 10);
  return unsupported(std::string_view{code, static_cast<std::size_t>(size)});
}

// What can be said of the block before any code takes effect.
Flow Interpreter::check_codes() {
  if (block_.defect()) return machine_.raise(block_.defect()->kind, block_.defect()->word);
  if (const Code* code = block_.unsupported()) return unsupported('G', code->number);
  const Code* cycle = block_.code(Group::kCycle);
  const bool enters = cycle != nullptr && cycle->number != 800;
  if (enters && block_.code(Group::kMotion) != nullptr) {
    return machine_.raise(AlarmKind::kConflictingWords, 'G');  // GSK-MOD-09
  }
  if (!block_.has('M')) return Flow::kContinue;
  const Decimal& m = block_.number('M');
  if (m.finer || (!m.overflow && m.value % kOne != 0)) {
    return machine_.raise(AlarmKind::kNotAnInteger, 'M');
  }
  if (m.overflow || m.value < 0 || m.value / kOne > std::numeric_limits<std::int32_t>::max()) {
    return machine_.raise(AlarmKind::kValueOutOfRange, 'M');
  }
  const Fixed number = m.value / kOne;
  if (number == 98 || number == 99) return unsupported('M', static_cast<unsigned>(number) * 10);
  if (number > 9'999) return unsupported("A large M function");
  return Flow::kContinue;
}

Flow Interpreter::take_modal_codes() {
  State& state = machine_.state;
  if (const Code* units = block_.code(Group::kUnits)) state.inch = units->number == 200;
  if (const Code* plane = block_.code(Group::kPlane)) state.plane = &plane_of(plane->number / 10);
  if (const Code* mode = block_.code(Group::kFeedMode)) state.per_revolution = mode->number == 990;
  const Flow words = check_words(machine_, block_);
  if (words != Flow::kContinue) return words;
  const bool in_cycle = state.cycle != Cycle::kNone || is_turning_cycle(state.motion);
  const bool coded =
      block_.code(Group::kMotion) != nullptr || block_.code(Group::kCycle) != nullptr;
  take_cycle_code();
  take_motion_code();
  const Flow feed = take_feed(in_cycle && !coded);
  if (feed != Flow::kContinue) return feed;
  // GSK-G94-07, GSK-MOD-08: 00 codes but G04 clear what G94 retained.
  if (block_.code(Group::kNonModal) != nullptr) {
    const bool spared = is_dwell() ? !machine_.has(Fault::kDwellClearsTaper)
                                   : machine_.has(Fault::kTaperLeaksPastNonModal);
    if (!spared) state.turning = {};
    const bool cancels = machine_.configuration.g94_cancelled_by_00 && !is_dwell();
    if (cancels && is_turning_cycle(state.motion)) state.motion = Motion::kRapid;
  }
  return Flow::kContinue;
}

Flow Interpreter::take_feed(bool repeats_cycle) {
  if (!block_.has('F')) return Flow::kContinue;
  if (block_.number('F').value < 0)
    return machine_.raise(AlarmKind::kValueSign, 'F');  // GSK-COM-08
  if (repeats_cycle && machine_.has(Fault::kCycleFeedStuck)) return Flow::kContinue;
  const bool converts = machine_.state.inch && !machine_.has(Fault::kInchFeed);
  const Fixed written = block_.number('F').value;
  State& state = machine_.state;
  const bool is_lead = state.motion == Motion::kThreadCycle && state.cycle == Cycle::kNone &&
                       !machine_.configuration.lead_is_feed;
  (is_lead ? state.lead : state.feed) =
      converts ? static_cast<Fixed>(scaled(written, 254, 10)) : written;
  return Flow::kContinue;
}

// GSK-MOD-01, GSK-MOD-05, GSK-MOD-06.
void Interpreter::take_cycle_code() {
  State& state = machine_.state;
  entering_ = false;
  if (const Code* code = block_.code(Group::kCycle)) {
    if (code->number == 800) {
      cancel_cycles();
    } else {
      enter_cycle(static_cast<Cycle>((code->number - 1100) / 10 + 1));
    }
  }
  if (state.cycle != Cycle::kNone && (entering_ || block_.code(Group::kPlane) != nullptr)) {
    state.initial_plane = state.position[state.plane->d];
  }
}

// G80.
void Interpreter::cancel_cycles() {
  State& state = machine_.state;
  const bool from_mode = state.cycle != Cycle::kNone;
  state.cycle = Cycle::kNone;
  if (machine_.has(Fault::kG80KeepsG94) && is_turning_cycle(state.motion)) return;
  if (machine_.has(Fault::kG80RestoresMotion) && from_mode) return;
  state.turning = {};
  state.motion = Motion::kRapid;
}

void Interpreter::enter_cycle(Cycle cycle) {
  State& state = machine_.state;
  const Mode mode = mode_of(cycle);
  const Mode before = mode_of(state.cycle);
  const bool apart = machine_.configuration.pockets_apart && !is_thread_milling(mode);
  const bool one = machine_.configuration.threads_one_mode && is_thread_milling(mode) &&
                   is_thread_milling(before);
  entering_ = (mode != before && !one) || (apart && cycle != state.cycle);
  state.cycle = cycle;
  // Reading gsk.g94.in-mode.
  if (machine_.configuration.g94_cleared_by_cycles) state.turning = {};
  if (!entering_) return;
  const Retained tool = state.pocket.tool_radius;
  state.pocket = {};
  const bool leaks = machine_.has(Fault::kToolLeaksIntoHelix) && before == Mode::kPocket;
  if (leaks) state.pocket.tool_radius = tool;
}

void Interpreter::take_motion_code() {
  const Code* code = block_.code(Group::kMotion);
  if (code == nullptr) return;
  State& state = machine_.state;
  const Motion motion = motion_of(*code);
  if (!is_turning_cycle(motion) || state.motion != motion) {
    // GSK-G94-07: another code of the group.
    const Retained taper = state.turning.taper;
    const bool leaks = machine_.has(Fault::kTurnLeaksIntoFace) && is_turning_cycle(state.motion) &&
                       is_turning_cycle(motion);
    if (!leaks) state.turning = {};
    if (machine_.has(Fault::kTaperLeaksPastMotion)) state.turning.taper = taper;
  } else if (machine_.configuration.g94_rewrite_clears && !block_.has('R')) {
    state.turning.taper = {};
  }
  state.motion = motion;
  // GSK-G110-15
  if (!machine_.has(Fault::kPocketLeaksPastMotion)) state.cycle = Cycle::kNone;
}

// Words that this expander has a use for, or holds to their range, beside the codes in force.
AddressSet Interpreter::known_words() const {
  constexpr AddressSet kAxes{"XUYVZWCH"};
  constexpr AddressSet kCycle{"XUYVZWCHRILQDEJKP"};
  const bool in_cycle = machine_.state.cycle != Cycle::kNone;
  const bool enters = block_.code(Group::kCycle) != nullptr && in_cycle;
  if (is_dwell()) {
    if (enters) return AddressSet{"RILQDEJKPXU"};
    return block_.has('P') ? AddressSet{"P"} : AddressSet{"XU"};
  }
  if (block_.code(Group::kNonModal) != nullptr) return enters ? kCycle : kAxes;
  if (in_cycle || is_turning_cycle(machine_.state.motion)) return kCycle;
  const Motion motion = machine_.state.motion;
  if (motion != Motion::kArcClockwise && motion != Motion::kArcCounterclockwise) return kAxes;
  AddressSet known = kAxes;
  known.add('R');
  const std::size_t across = machine_.state.plane->d;
  for (const std::size_t axis : {GONOGO_X, GONOGO_Y, GONOGO_Z}) {
    if (block_.has('R') || axis != across) known.add(static_cast<char>('I' + (axis - GONOGO_X)));
  }
  return known;
}

// A word that a control may chamfer or round by.
Flow Interpreter::check_stray_words() {
  constexpr AddressSet kAnywhere{"FMST"};
  const AddressSet known = known_words();
  for (char address = 'A'; address <= 'Z'; ++address) {
    if (!block_.has(address) || known.has(address) || kAnywhere.has(address)) continue;
    return unsupported({&address, 1});
  }
  return Flow::kContinue;
}

// Of the codes in force one takes the words of the block.
Flow Interpreter::prepare(Plan& plan) {
  const Flow known = check_stray_words();
  if (known != Flow::kContinue) return known;
  const bool in_cycle = machine_.state.cycle != Cycle::kNone;
  if (in_cycle && entering_ && block_.code(Group::kNonModal) != nullptr) {
    const Flow flow = prepare_cycle(false, plan);
    if (flow != Flow::kContinue) return flow;
  }
  if (is_dwell()) return prepare_dwell(machine_, block_, plan);
  if (block_.has_code(Group::kNonModal, 280)) return prepare_home(machine_, block_, plan);
  if (block_.has_code(Group::kNonModal, 500)) return prepare_rename(machine_, block_, plan);
  if (in_cycle) return prepare_cycle(true, plan);
  switch (machine_.state.motion) {
    case Motion::kFaceCycle:
      return prepare_face_cycle(machine_, block_, plan);
    case Motion::kTurnCycle:
      return prepare_turn_cycle(machine_, block_, plan);
    case Motion::kThreadCycle:
      return prepare_thread_cycle(machine_, block_, plan);
    case Motion::kArcClockwise:
    case Motion::kArcCounterclockwise:
      return prepare_arc(machine_, block_, plan);
    case Motion::kRapid:
    case Motion::kLine:
      break;
  }
  return prepare_line(machine_, block_, plan);
}

// `mills`: the axis words of the block are the cycle's.
Flow Interpreter::prepare_cycle(bool mills, Plan& plan) {
  switch (mode_of(machine_.state.cycle)) {
    case Mode::kPocket:
      return prepare_pocket(machine_, block_, entering_, mills, plan);
    case Mode::kHelix:
      return prepare_helix(machine_, block_, entering_, mills, plan);
    case Mode::kExternalThread:
    case Mode::kInternalThread:
      return prepare_thread_milling(machine_, block_, mills, plan);
    case Mode::kNone:
      break;
  }
  return Flow::kContinue;
}

// The M function of the block: passed on before or after its motion, and the end of the program.
Flow Interpreter::run_functions(bool before) {
  if (!block_.has('M')) return Flow::kContinue;
  const Fixed m = block_.number('M').value / kOne;
  const bool clamp = m == 35 && machine_.state.cycle != Cycle::kNone;
  if (clamp && machine_.has(Fault::kClampDropped)) return Flow::kContinue;
  // GSK-G112-01
  const bool after = runs_after_motion(m) || (clamp && machine_.has(Fault::kClampLate));
  if (after == before) return Flow::kContinue;
  if (!machine_.trace.function(static_cast<int>(m))) return Flow::kStopped;
  return ends_program(m) ? Flow::kEnd : Flow::kContinue;
}

}  // namespace gonogo::expanders::gsk
