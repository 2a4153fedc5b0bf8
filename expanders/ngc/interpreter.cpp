// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/interpreter.hpp"

#include <algorithm>
#include <cstdio>

#include "expanders/common/program_loop.hpp"

namespace gonogo::expanders::ngc {
namespace {

constexpr AddressSet kCentreWords{"IJK"};
// Words whose size matters to the path; of the others any number of digits will do.
constexpr AddressSet kMeasured{"XYZACIJKRPF"};

bool is_end(Fixed m) {
  return m == 2 || m == 30;
}

// Stops; every other function runs before the motion of its block.
bool is_after_motion(Fixed m) {
  return is_end(m) || m == 0 || m == 1 || m == 60;
}

}  // namespace

gonogo_answer Interpreter::run(std::string_view program) {
  const bool pairs = program.find("\r\n") != std::string_view::npos;
  const Counting counting =
      machine_.adds("cr-lf-counted-twice"_fault, pairs) ? Counting::kPairTwice : Counting::kAll;
  std::uint64_t& line = machine_.state.line;
  Flow flow =
      run_lines(program, counting, line, [this](std::string_view text) { return run_line(text); });
  if (flow == Flow::kContinue) flow = check_end();
  auto send_alarm = [&] {
    const std::uint64_t block = machine_.alters("alarm-next-block"_fault, line, line + 1);
    machine_.tracer.alarm(machine_.alarm().kind, machine_.alarm().word, block);
  };
  return close_program(flow, send_alarm, [this] { return machine_.tracer.end(); });
}

// NGC-COM-08
Flow Interpreter::check_end() {
  machine_.state.line = std::max<std::uint64_t>(machine_.state.line, 1);
  if (ended_ || machine_.configuration.needs_no_end) return Flow::kContinue;
  if (opened_ && machine_.adds("second-tape-mark-optional"_fault)) return Flow::kContinue;
  machine_.complain(AlarmKind::kProgramEnd);
  return Flow::kAlarm;
}

Block::Manner Interpreter::manner() const {
  const Configuration& configuration = machine_.configuration;
  return {.block_delete = configuration.block_delete,
          .forgets_g80 = configuration.forgets_g80 != 0,
          .whole = machine_.whole,
          .faults = machine_};
}

Flow Interpreter::refuse_line() {
  machine_.complain(AlarmKind::kSyntax, block_.last_address(), 0);
  return Flow::kAlarm;
}

Flow Interpreter::run_line(std::string_view line) {
  const Block::Reading reading = block_.read(line, manner());
  if (reading == Block::Reading::kBlank) return Flow::kContinue;
  const bool first = !any_line_;
  const bool comment = reading == Block::Reading::kWords && block_.empty();
  if (!comment || machine_.spares("tape-mark-after-comment"_fault)) any_line_ = true;
  switch (reading) {
    case Block::Reading::kSyntax:
      return refuse_line();
    case Block::Reading::kMacro:
      return unsupported(block_.macro());
    case Block::Reading::kTapeMark:
      return run_tape_mark(first);
    case Block::Reading::kName:
      if (machine_.configuration.refuses_names) return refuse_line();
      return machine_.alters("name-ends-program"_fault, Flow::kContinue, Flow::kEnd);
    case Block::Reading::kBlank:
    case Block::Reading::kSkipped:
      return Flow::kContinue;
    case Block::Reading::kWords:
      break;
  }
  if (block_.empty()) return refuses_number() ? refuse_line() : Flow::kContinue;
  return run_block();
}

// NGC-COM-07
Flow Interpreter::run_tape_mark(bool first) {
  if (first) {
    opened_ = true;
    return Flow::kContinue;
  }
  if (!opened_ && machine_.spares("tape-mark-anywhere"_fault)) return refuse_line();
  ended_ = true;
  return machine_.alters("tape-mark-ignored"_fault, Flow::kEnd, Flow::kContinue);
}

// NGC-COM-05
bool Interpreter::refuses_number() const {
  return machine_.configuration.whole_line_numbers && block_.long_number();
}

Flow Interpreter::run_block() {
  const Flow covered = check_coverage();
  if (covered != Flow::kContinue) return covered;
  if (refuses_number()) return refuse_line();
  check_block();
  if (machine_.in_alarm()) return Flow::kAlarm;
  Plan plan;
  prepare(plan);
  if (machine_.in_alarm() && !plan.alarms_late) return Flow::kAlarm;
  return plan.outside.empty() ? perform_plan(plan) : unsupported(plan.outside);
}

Flow Interpreter::unsupported(std::string_view what) {
  return not_implemented(machine_.tracer, what);
}

Flow Interpreter::unsupported(char letter, unsigned tenths) {
  char code[24];
  const char* form = tenths % 10 == 0 ? "%c%u" : "%c%u.%u";
  const int size = std::snprintf(code, sizeof code, form, letter, tenths / 10, tenths % 10);
  return unsupported(std::string_view{code, static_cast<std::size_t>(size)});
}

// What the control can do and this expander cannot; it goes before every alarm of the block.
Flow Interpreter::check_coverage() {
  if (const Code* code = block_.outside()) return unsupported('G', code->tenths);
  for (const char address : {'B', 'U', 'V', 'W'}) {
    if (block_.has(address)) return unsupported({&address, 1});
  }
  const Code* code = block_.code(Group::kMotion);
  const Motion motion = code != nullptr ? static_cast<Motion>(code->tenths) : machine_.state.motion;
  const bool synchronous = motion == Motion::kG33 || motion == Motion::kG331;
  if (synchronous && block_.has_any(kRotaryWords)) return unsupported("G33 with a rotary axis");
  for (const FunctionWord& word : block_.functions()) {
    if (word.number && find_function(*word.number) == Function::kOutside) {
      return unsupported('M', static_cast<unsigned>(*word.number * 10));
    }
  }
  return Flow::kContinue;
}

// What can be said of the block before any word takes effect.
void Interpreter::check_block() {
  if (block_.unknown_code()) return machine_.complain(AlarmKind::kUndefinedCode, 'G', 0);
  if (!check_functions()) return;
  if (block_.duplicate() != 0) {
    return machine_.complain(AlarmKind::kDuplicateWord, block_.duplicate(),
                             block_.duplicate_position());
  }
  check_sizes(machine_, block_, kMeasured);
}

bool Interpreter::check_functions() {
  std::uint32_t groups = 0;
  for (const FunctionWord& word : block_.functions()) {
    if (word.number && find_function(*word.number) == Function::kKnown) {
      const auto group = static_cast<unsigned>(group_of(*word.number));
      if ((groups >> group & 1U) != 0) {  // NGC-COM-01
        machine_.complain(AlarmKind::kDuplicateWord, 'M', word.position);
        return false;
      }
      groups |= 1U << group;
      continue;
    }
    const bool fraction = !word.number && !word.too_large;
    machine_.complain(fraction ? AlarmKind::kNotAnInteger : AlarmKind::kUndefinedCode, 'M',
                      word.position);
    return false;
  }
  return true;
}

// NGC-MOD-01, NGC-CYC-01: in a fixed order, whatever that of the line.
void Interpreter::prepare(Plan& plan) {
  State& state = machine_.state;
  const int plane = state.plane;
  const FeedRate feed = state.feed;
  take_feed();
  const FeedRate coming_feed = state.feed;
  if (machine_.adds("feed-after-motion"_fault, coming_feed != feed)) state.feed = feed;
  take_spindle();
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
  state.feed = coming_feed;
  if (is_cycle(state.motion) && machine_.adds("cycle-feed-lost"_fault, coming_feed != feed)) {
    state.feed = feed;
  }
  if (block_.has_dwell() &&
      machine_.adds("motion-lost-after-dwell"_fault, state.motion != Motion::kNone)) {
    state.motion = Motion::kNone;
  }
}

// F counts in the units of the block before: G20 and G21 act later.
void Interpreter::take_feed() {
  if (!block_.has('F')) return;
  const Fixed written = block_.number('F').value;
  if (written < 0) return machine_.complain(AlarmKind::kValueSign, 'F', block_);
  machine_.state.feed = {
      machine_.alters("inch-feed-unscaled"_fault, length_of(machine_, written), written), written};
}

void Interpreter::take_spindle() {
  for (const FunctionWord& word : block_.functions()) {
    const Fixed m = word.number.value_or(0);
    if (m >= 3 && m <= 5) machine_.state.spindle = static_cast<int>(m);
  }
}

void Interpreter::take_modes() {
  State& state = machine_.state;
  if (const Code* code = block_.code(Group::kPlane)) {
    const int plane = code->tenths / 10;
    // NGC-CYC-09
    if (plane != state.plane && !machine_.configuration.initial_is_number) state.in_series = false;
    state.plane = plane;
  }
  if (const Code* code = block_.code(Group::kUnits)) state.inch = code->tenths == 200;
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
    const char address = kAxisAddress[axis];
    if (!block_.has(address)) continue;
    machine_.state.leftovers.steps[axis] = length_of(machine_, block_, address);
  }
}

// Whether the block runs the motion code in force: by the code, by an axis word or, an arc, by
// I J K alone (NGC-ARC-06).
bool Interpreter::runs_motion() const {
  if (block_.code(Group::kMotion) != nullptr || block_.has_any(kAxisWords)) return true;
  if (!is_arc(machine_.state.motion) || !block_.has_any(kCentreWords)) return false;
  return !machine_.configuration.arc_needs_axis && machine_.spares("arc-words-need-code"_fault);
}

// NGC-COM-02
void Interpreter::check_uses() {
  static constexpr AddressSet kOfCodes{"DEHIJKLPQR"};
  if (machine_.configuration.passes_over_words) return;
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

void Interpreter::prepare_motion(Plan& plan) {
  check_uses();
  switch (machine_.state.motion) {
    case Motion::kNone:
      if (block_.has_any(kAxisWords)) machine_.complain(AlarmKind::kMissingWord, 'G', kNowhere);
      return;
    case Motion::kRapid:
    case Motion::kLine:
      return prepare_line(machine_, block_, plan);
    default:
      break;
  }
  if (!runs_motion()) return;
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

Flow Interpreter::perform_plan(const Plan& plan) {
  const Flow before = run_functions(true);
  if (before != Flow::kContinue) return before;
  if (!machine_.tracer.dwell(plan.dwell)) return Flow::kStopped;
  const bool goes_on =
      std::visit([&](const auto& motion) { return perform(machine_, motion); }, plan.motion);
  if (!goes_on) return Flow::kStopped;
  return plan.alarms_late ? Flow::kAlarm : run_functions(false);
}

// The M functions of the block that run before or after its motion, and the end of the program.
Flow Interpreter::run_functions(bool before) {
  for (const FunctionWord& word : block_.functions()) {
    const Fixed m = *word.number;
    if (is_after_motion(m) == before) continue;
    if (!machine_.tracer.function(static_cast<int>(m))) return Flow::kStopped;
    if (!is_end(m)) continue;
    ended_ = true;
    if (machine_.spares("end-ignored"_fault)) return Flow::kEnd;
  }
  return Flow::kContinue;
}

}  // namespace gonogo::expanders::ngc
