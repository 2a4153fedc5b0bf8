// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/hnc/interpreter.hpp"

#include <cstdio>
#include <limits>

#include "expanders/common/program_loop.hpp"

namespace gonogo::expanders::hnc {

Motion motion_of(int code) {
  switch (code) {
    case 32:
      return Motion::kThread;
    case 74:
      return Motion::kDrill;
    case 75:
      return Motion::kGroove;
    case 80:
      return Motion::kTurn;
    case 81:
      return Motion::kFace;
    case 82:
      return Motion::kThreadCycle;
    default:
      return static_cast<Motion>(code);
  }
}

gonogo_answer Interpreter::run(std::string_view program) {
  const bool blanks_lost = machine_.has(Fault::kBlankLinesNotCounted);
  const Counting counting = blanks_lost ? Counting::kWithoutBlank : Counting::kAll;
  std::uint64_t& line = machine_.state.line;
  const Flow flow =
      run_lines(program, counting, line, [this](std::string_view text) { return run_line(text); });
  const unsigned late = machine_.has(Fault::kAlarmNextBlock) ? 1 : 0;
  auto send_alarm = [&] {
    machine_.tracer.alarm(text_of(machine_.alarm().kind), machine_.alarm().word, line + late);
  };
  return close_program(flow, send_alarm, [this] { return machine_.tracer.end(); });
}

Flow Interpreter::run_line(std::string_view line) {
  switch (block_.read(line, machine_.configuration.block_skip)) {
    case Block::Reading::kSyntax:
      machine_.complain(AlarmKind::kSyntax, block_.last_address(), 0);
      return Flow::kAlarm;
    case Block::Reading::kMacro:
      return unsupported(block_.macro());
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
  const Flow covered = check_coverage();
  if (covered != Flow::kContinue) return covered;
  check_block();
  if (machine_.in_alarm()) return Flow::kAlarm;
  Plan plan;
  take_modal_codes();
  take_motion();
  take_speed();
  prepare(plan);
  if (machine_.in_alarm()) return Flow::kAlarm;
  const Flow before = run_function(true);
  if (before != Flow::kContinue) return before;
  const bool goes_on = std::visit([&](const auto& p) { return perform(machine_, p); }, plan);
  return goes_on ? run_function(false) : Flow::kStopped;
}

Flow Interpreter::unsupported(std::string_view what) {
  return not_implemented(machine_.tracer, what);
}

Flow Interpreter::unsupported(char letter, unsigned number) {
  char code[16];
  const int size = std::snprintf(code, sizeof code, "%c%u", letter, number);
  return unsupported(std::string_view{code, static_cast<std::size_t>(size)});
}

// The motion code in force once the block is read.
Motion Interpreter::coming_motion() const {
  const Code* code = block_.code(Group::kMotion);
  return code == nullptr ? machine_.state.motion : motion_of(code->number);
}

// Words that this expander has a use for, or may pass over, under a motion code; an empty set is
// that of G00 and G01. HNC-MOD-05: the cycles take in each other's words.
AddressSet Interpreter::words_of(Motion motion) const {
  constexpr AddressSet kPlain{"XUZW"};
  constexpr AddressSet kCycle{"XUZWIKRECAPJQ"};
  if (block_.has_code(Group::kOnce, 4)) return AddressSet{"P"};
  if (is_apart()) return kPlain;
  switch (motion) {
    case Motion::kArcClockwise:
    case Motion::kArcCounterclockwise:
      return AddressSet{"XUZWRIK"};
    case Motion::kThread:
      return AddressSet{"XUZWJREPCQKI"};
    default:
      return is_cycle(motion) ? kCycle : kPlain;
  }
}

// A word that a control may chamfer, round or offset by; 0: none.
char Interpreter::stray_word(Motion motion) const {
  constexpr AddressSet kAnywhere{"FMSTYV"};
  const AddressSet known = words_of(motion);
  for (char address = 'A'; address <= 'Z'; ++address) {
    if (block_.has(address) && !known.has(address) && !kAnywhere.has(address)) return address;
  }
  return 0;
}

// What the control can do and this expander cannot; it goes before every alarm of the block.
Flow Interpreter::check_coverage() {
  if (const Code* code = block_.outside()) return unsupported('G', code->number);
  if (block_.has('M')) {
    const Decimal& m = block_.number('M');
    if (!has_fraction(block_, 'M') && (m.value == 98 * kOne || m.value == 99 * kOne)) {
      return unsupported('M', static_cast<unsigned>(m.value / kOne));
    }
    const Fixed number = m.value / kOne;
    const bool fits_record = number <= std::numeric_limits<std::int32_t>::max();
    if (!has_fraction(block_, 'M') && !m.overflow && number > 9'999 && fits_record) {
      return unsupported("A large M function");
    }
  }
  const Motion motion = coming_motion();
  // A program with Y outside of the turning cycles is one for a mill.
  for (const char address : {'Y', 'V'}) {
    if (block_.has(address) && !is_cycle(motion)) return unsupported({&address, 1});
  }
  const char stray = block_.unknown_code() ? char{0} : stray_word(motion);
  if (stray != 0) return unsupported({&stray, 1});
  if (motion != Motion::kThread || is_apart()) return Flow::kContinue;
  for (const char address : {'R', 'E', 'P', 'C', 'Q', 'K', 'I'}) {
    const bool shapes =
        block_.has(address) && (block_.number(address).value != 0 || block_.number(address).finer);
    if (shapes) return unsupported('G', 32);
  }
  return Flow::kContinue;
}

// What can be said of the block before any code takes effect.
void Interpreter::check_block() {
  if (block_.unknown_code()) return machine_.complain(AlarmKind::kUndefinedCode, 'G', 0);
  if (block_.duplicate() != 0) {
    machine_.complain(AlarmKind::kDuplicateWord, block_.duplicate(), block_.duplicate_position());
  }
  const Code* plane = block_.code(Group::kPlane);
  if (plane != nullptr && plane->number != 18) {  // HNC-MOD-05
    machine_.complain(AlarmKind::kPlaneNotAllowed, 'G', block_.code_position(Group::kPlane));
  }
  for (const char address : {'Y', 'V'}) {
    if (block_.has(address)) machine_.complain(AlarmKind::kUndefinedCode, address, block_);
  }
  check_function();
  check_words(machine_, block_);
}

void Interpreter::check_function() {
  if (!block_.has('M')) return;
  const Decimal& m = block_.number('M');
  constexpr Fixed kMost = std::numeric_limits<std::int32_t>::max();
  if (has_fraction(block_, 'M') && !m.overflow) {
    machine_.complain(AlarmKind::kNotAnInteger, 'M', block_);
  }
  if (m.overflow || m.value < 0 || m.value / kOne > kMost) {
    machine_.complain(AlarmKind::kValueOutOfRange, 'M', block_);
  }
}

void Interpreter::take_modal_codes() {
  State& state = machine_.state;
  if (const Code* code = block_.code(Group::kUnits)) state.inch = code->number == 20;
  if (const Code* code = block_.code(Group::kDiameter)) state.diameter = code->number == 36;
  if (const Code* code = block_.code(Group::kDistance)) state.incremental = code->number == 91;
  if (const Code* code = block_.code(Group::kFeedMode)) state.per_revolution = code->number == 95;
  if (const Code* code = block_.code(Group::kFrame)) {
    state.frame = &machine_.configuration.offsets[code->number - 54u];
  }
}

// HNC-MOD-01: another command forgets the words of the one in force; the same code is none.
void Interpreter::take_motion() {
  State& state = machine_.state;
  const Motion coming = coming_motion();
  repeats_ = block_.code(Group::kMotion) == nullptr;
  if (coming == state.motion) return;
  const Motion before = state.motion;
  if (machine_.has(Fault::kCycleSurvivesRapid) && is_cycle(before) && coming == Motion::kRapid) {
    return;
  }
  const CycleStore left = state.store;
  state.store = {};
  state.motion = coming;
  const bool plain = coming == Motion::kRapid || coming == Motion::kLine;
  const bool was_plain = before == Motion::kRapid || before == Motion::kLine;
  if (machine_.has(Fault::kTaperLeaksPastRapid) && (plain || was_plain)) {
    state.store.taper = left.taper;
  }
  if (machine_.has(Fault::kWithdrawalLeaksIntoGroove) && before == Motion::kDrill &&
      coming == Motion::kGroove) {
    state.store.withdrawal = left.withdrawal;
    state.store.infeed = left.infeed;
  }
}

// F, and J of threads: the feed or the lead, by the motion code in force.
void Interpreter::take_speed() {
  if (!is_thread(machine_.state.motion)) return take_feed();
  const bool inch_lead = machine_.state.inch && machine_.configuration.lead_in_units;
  const bool by_j = block_.has('J');
  // HNC-G82-07, HNC-G82-08
  if (block_.has('F') && by_j) {
    const char later = block_.position('F') < block_.position('J') ? 'J' : 'F';
    machine_.complain(AlarmKind::kConflictingWords, later, block_);
  }
  take_lead('F', inch_lead);
  if (!by_j) return;
  take_lead('J', !machine_.has(Fault::kInchLeadAsMillimetres));
  if (machine_.configuration.threads_per_inch) take_thread_count();
}

// J as threads to the inch.
void Interpreter::take_thread_count() {
  const Fixed count = block_.number('J').value;
  if (count <= 0) return;
  const Wide lead = scaled(254 * kOne / 10, kOne, count);
  if (!fits(lead)) return machine_.complain(AlarmKind::kValueOutOfRange, 'J', block_);
  machine_.state.store.lead = static_cast<Fixed>(lead);
}

void Interpreter::take_lead(char address, bool in_inches) {
  if (!block_.has(address)) return;
  const Fixed written = block_.number(address).value;
  if (written <= 0) return machine_.complain(AlarmKind::kValueSign, address, block_);
  State& state = machine_.state;
  state.store.lead = in_inches ? static_cast<Fixed>(scaled(written, 254, 10)) : written;
  if (machine_.has(Fault::kLeadLeaksIntoFeed)) state.feed = state.store.lead;
}

// HNC-MOD-04: reading hnc.modal.f decides whether a cycle's feed is the ordinary one.
void Interpreter::take_feed() {
  if (!block_.has('F')) return;
  const Fixed written = block_.number('F').value;
  if (written < 0) return machine_.complain(AlarmKind::kValueSign, 'F', block_);
  State& state = machine_.state;
  const bool cycle = is_cycle(state.motion);
  if (cycle && repeats_ && machine_.has(Fault::kCycleFeedStuck)) return;
  const bool in_inches = state.inch && !machine_.has(Fault::kInchFeed);
  const bool own = cycle && machine_.configuration.cycle_feed_forgotten;
  (own ? state.store.feed : state.feed) =
      in_inches ? static_cast<Fixed>(scaled(written, 254, 10)) : written;
}

// Of the codes in force one takes the words of the block.
void Interpreter::prepare(Plan& plan) {
  if (block_.has_code(Group::kOnce, 4)) return prepare_dwell(machine_, block_, plan);
  if (block_.has_code(Group::kOnce, 92)) return prepare_rename(machine_, block_, plan);
  switch (machine_.state.motion) {
    case Motion::kRapid:
    case Motion::kLine:
      return prepare_line(machine_, block_, plan);
    case Motion::kArcClockwise:
    case Motion::kArcCounterclockwise:
      return prepare_arc(machine_, block_, plan);
    case Motion::kThread:
      return prepare_thread(machine_, block_, plan);
    case Motion::kDrill:
      return prepare_drill(machine_, block_, plan);
    case Motion::kGroove:
      return prepare_groove(machine_, block_, plan);
    case Motion::kTurn:
      return prepare_turn_cycle(machine_, block_, plan);
    case Motion::kFace:
      return prepare_face_cycle(machine_, block_, plan);
    case Motion::kThreadCycle:
      return prepare_thread_cycle(machine_, block_, plan);
  }
}

// The M function of the block: passed on before or after its motion, and the end of the program.
Flow Interpreter::run_function(bool before) {
  if (!block_.has('M')) return Flow::kContinue;
  const Fixed m = block_.number('M').value / kOne;
  if (runs_after_motion(m) == before) return Flow::kContinue;
  if (!machine_.tracer.function(static_cast<int>(m))) return Flow::kStopped;
  return ends_program(m) ? Flow::kEnd : Flow::kContinue;
}

}  // namespace gonogo::expanders::hnc
