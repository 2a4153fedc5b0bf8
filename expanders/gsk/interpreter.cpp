// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/interpreter.hpp"

#include <cstdio>
#include <limits>

#include "expanders/gsk/tokenizer.hpp"

namespace gonogo::expanders::gsk {
namespace {

Counting counting_of(const Machine& machine) {
  if (machine.has(Fault::kBlankLinesNotCounted)) return Counting::kWithoutBlank;
  if (machine.has(Fault::kPairsCountedTwice)) return Counting::kPairTwice;
  return Counting::kAll;
}

bool ends_program(Fixed m) {
  return m == 2 || m == 17 || m == 30;
}

// Stops and switch-offs run after the motion of their block, all else before (GSK-G112-01).
bool runs_after_motion(Fixed m) {
  return ends_program(m) || m == 0 || m == 1 || m == 5 || m == 9;
}

}  // namespace

gonogo_answer Interpreter::run(std::string_view program) {
  switch (run_blocks(program)) {
    case Flow::kAlarm: {
      const bool next = machine_.has(Fault::kAlarmNextBlock);
      machine_.trace.alarm(machine_.alarm, machine_.state.line + (next ? 1 : 0));
      return GONOGO_ALARM;
    }
    case Flow::kUnsupported:
      return GONOGO_UNSUPPORTED;
    case Flow::kStopped:
      return GONOGO_STOPPED;
    case Flow::kContinue:
    case Flow::kEnd:
      break;
  }
  return machine_.trace.end() ? GONOGO_OK : GONOGO_STOPPED;
}

Flow Interpreter::run_blocks(std::string_view program) {
  LineReader lines(program, counting_of(machine_));
  std::string_view line;
  while (lines.next(line)) {
    machine_.state.line = lines.number();
    const Flow flow = run_line(line);
    if (flow != Flow::kContinue) return flow;
  }
  return Flow::kContinue;
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
  return goes_on ? run_functions(false) : Flow::kStopped;
}

Flow Interpreter::unsupported(const char* letter, unsigned number) {
  char message[64];
  const int size =
      number % 10 == 0
          ? std::snprintf(message, sizeof message, "%s%u is not implemented.", letter, number / 10)
          : std::snprintf(message, sizeof message, "%s%u.%u is not implemented.", letter,
                          number / 10, number % 10);
  machine_.trace.note(GONOGO_NOTE_ERROR, {message, static_cast<std::size_t>(size)});
  return Flow::kUnsupported;
}

// What can be said of the block before any code takes effect.
Flow Interpreter::check_codes() {
  if (block_.defect()) return machine_.raise(block_.defect()->kind, block_.defect()->word);
  if (const Code* code = block_.unsupported()) return unsupported("G", code->number);
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
  if (number == 98 || number == 99) return unsupported("M", static_cast<unsigned>(number) * 10);
  return Flow::kContinue;
}

Flow Interpreter::take_modal_codes() {
  State& state = machine_.state;
  if (const Code* units = block_.code(Group::kUnits)) state.inch = units->number == 200;
  if (const Code* plane = block_.code(Group::kPlane)) state.plane = &plane_of(plane->number / 10);
  if (const Code* mode = block_.code(Group::kFeedMode)) state.per_revolution = mode->number == 990;
  const Flow words = check_words(machine_, block_);
  if (words != Flow::kContinue) return words;
  const bool in_cycle = state.cycle != Cycle::kNone || state.motion == Motion::kFaceCycle;
  const bool coded =
      block_.code(Group::kMotion) != nullptr || block_.code(Group::kCycle) != nullptr;
  const Flow feed = take_feed(in_cycle && !coded);
  if (feed != Flow::kContinue) return feed;
  take_cycle_code();
  take_motion_code();
  // GSK-G94-07, GSK-MOD-08: 00 codes but G04 clear what G94 retained.
  if (block_.code(Group::kNonModal) != nullptr) {
    const bool spared = is_dwell() ? !machine_.has(Fault::kDwellClearsTaper)
                                   : machine_.has(Fault::kTaperLeaksPastNonModal);
    if (!spared) state.face = {};
    const bool cancels = machine_.configuration.g94_cancelled_by_00 && !is_dwell();
    if (cancels && state.motion == Motion::kFaceCycle) state.motion = Motion::kRapid;
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
  machine_.state.feed = converts ? static_cast<Fixed>(scaled(written, 254, 10)) : written;
  return Flow::kContinue;
}

// GSK-MOD-01, GSK-MOD-05, GSK-MOD-06.
void Interpreter::take_cycle_code() {
  State& state = machine_.state;
  entering_ = false;
  if (const Code* code = block_.code(Group::kCycle)) {
    if (code->number == 800) {
      state.cycle = Cycle::kNone;
      const bool keeps = machine_.has(Fault::kG80KeepsG94) && state.motion == Motion::kFaceCycle;
      if (!keeps) {
        state.face = {};
        state.motion = Motion::kRapid;
      }
    } else {
      const Cycle cycle =
          code->number == 1100 ? Cycle::kPocketClockwise : Cycle::kPocketCounterclockwise;
      const bool changes = machine_.configuration.pockets_apart && cycle != state.cycle;
      entering_ = state.cycle == Cycle::kNone || changes;
      state.cycle = cycle;
      state.face = {};
      if (entering_) state.pocket = {};
    }
  }
  if (state.cycle != Cycle::kNone && (entering_ || block_.code(Group::kPlane) != nullptr)) {
    state.pocket.initial_plane = state.position[state.plane->d];
  }
}

void Interpreter::take_motion_code() {
  const Code* code = block_.code(Group::kMotion);
  if (code == nullptr) return;
  State& state = machine_.state;
  const Motion motion =
      code->number == 940 ? Motion::kFaceCycle : static_cast<Motion>(code->number / 10);
  const bool again =
      motion == Motion::kFaceCycle && state.motion == motion && state.cycle == Cycle::kNone;
  if (!again) {
    // GSK-G94-07: another code of the group.
    const Retained taper = state.face.taper;
    state.face = {};
    if (machine_.has(Fault::kTaperLeaksPastMotion)) state.face.taper = taper;
  } else if (machine_.configuration.g94_rewrite_clears && !block_.has('R')) {
    state.face.taper = {};
  }
  state.motion = motion;
  // GSK-G110-15
  if (!machine_.has(Fault::kPocketLeaksPastMotion)) state.cycle = Cycle::kNone;
}

// Of the codes in force one takes the words of the block.
Flow Interpreter::prepare(Plan& plan) {
  const State& state = machine_.state;
  if (state.cycle != Cycle::kNone && entering_ && block_.code(Group::kNonModal) != nullptr) {
    const Flow flow = prepare_pocket(machine_, block_, true, false, plan);
    if (flow != Flow::kContinue) return flow;
  }
  if (is_dwell()) return prepare_dwell(machine_, block_, plan);
  if (block_.has_code(Group::kNonModal, 280)) return prepare_home(machine_, block_, plan);
  if (block_.has_code(Group::kNonModal, 500)) return prepare_rename(machine_, block_, plan);
  if (state.cycle != Cycle::kNone) return prepare_pocket(machine_, block_, entering_, true, plan);
  switch (state.motion) {
    case Motion::kFaceCycle:
      return prepare_face_cycle(machine_, block_, plan);
    case Motion::kArcClockwise:
    case Motion::kArcCounterclockwise:
      return prepare_arc(machine_, block_, plan);
    case Motion::kRapid:
    case Motion::kLine:
      break;
  }
  return prepare_line(machine_, block_, plan);
}

// The M function of the block: passed on before or after its motion, and the end of the program.
Flow Interpreter::run_functions(bool before) {
  if (!block_.has('M')) return Flow::kContinue;
  const Fixed m = block_.number('M').value / kOne;
  if (runs_after_motion(m) == before) return Flow::kContinue;
  if (!machine_.trace.function(static_cast<int>(m))) return Flow::kStopped;
  return ends_program(m) ? Flow::kEnd : Flow::kContinue;
}

}  // namespace gonogo::expanders::gsk
