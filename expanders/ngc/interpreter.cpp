// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/interpreter.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "expanders/common/program_loop.hpp"

namespace gonogo::expanders::ngc {
namespace {

// Words whose size matters to the path; of the others any number of digits will do.
constexpr AddressSet kMeasured{"XYZACIJKRPF@^"};

bool is_end(Fixed m) {
  return m == 2 || m == 30;
}

// Stops; every other function runs before the motion of its block.
bool is_after_motion(Fixed m) {
  return is_end(m) || m == 0 || m == 1 || m == 60;
}

// With blanks in their place.
std::string without_lone_cr(std::string_view program) {
  std::string text{program};
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool last = i + 1 == text.size();
    if (text[i] == '\r' && (last || text[i + 1] != '\n')) text[i] = ' ';
  }
  return text;
}

}  // namespace

gonogo_answer Interpreter::run(std::string_view program) {
  std::string blank;
  if (machine_.follows("ngc.lone-cr=blank"_reading)) program = blank = without_lone_cr(program);
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
  if (ended_ || machine_.follows("ngc.program-end=free"_reading)) return Flow::kContinue;
  if (opened_ && machine_.adds("second-tape-mark-optional"_fault)) return Flow::kContinue;
  machine_.complain(AlarmKind::kProgramEnd);
  return Flow::kAlarm;
}

Block::Manner Interpreter::manner() const {
  return {.block_delete = machine_.profile.block_skip,
          .reads_skipped = machine_.follows("ngc.block-delete=read"_reading),
          .forgets_g80 = machine_.follows("ngc.g80-beside=ignored"_reading),
          .whole = machine_.whole,
          .faults = machine_};
}

Flow Interpreter::refuse_line() {
  machine_.complain(AlarmKind::kSyntax, block_.last_address(), 0);
  return Flow::kAlarm;
}

Flow Interpreter::run_line(std::string_view line) {
  static constexpr std::size_t kLongest = 256;
  if (line.size() > kLongest && machine_.follows("ngc.long-line=syntax"_reading))
    return refuse_line();
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
      if (machine_.follows("ngc.o-name=syntax"_reading)) return refuse_line();
      return machine_.alters("name-ends-program"_fault, Flow::kContinue, Flow::kEnd);
    case Block::Reading::kBlank:
    case Block::Reading::kSkipped:
      return Flow::kContinue;
    case Block::Reading::kWords:
      break;
  }
  if (block_.aborts()) {  // NGC-COM-10
    machine_.complain(AlarmKind::kProgramEnd);
    return Flow::kAlarm;
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
  return machine_.follows("ngc.line-number=whole"_reading) && block_.long_number();
}

Flow Interpreter::run_block() {
  const Flow covered = check_coverage();
  if (covered != Flow::kContinue) return covered;
  if (refuses_number()) return refuse_line();
  check_block();
  if (machine_.in_alarm()) return Flow::kAlarm;
  Plan plan;
  prepare(plan);
  if (machine_.in_alarm() && !plan.alarms_late) {
    // NGC-G4-02
    const bool dwells = plan.reaches_motion && machine_.follows("ngc.alarm-dwell=dwells"_reading);
    return dwells && !machine_.tracer.dwell(plan.dwell) ? Flow::kStopped : Flow::kAlarm;
  }
  return plan.outside.empty() ? perform_plan(plan) : unsupported(plan.outside);
}

Flow Interpreter::unsupported(std::string_view what) {
  return not_implemented(machine_.tracer, what);
}

// What is in force once the codes of the block have acted.
Motion Interpreter::coming_motion() const {
  const Code* code = block_.code(Group::kMotion);
  return code != nullptr ? static_cast<Motion>(code->tenths) : machine_.state.motion;
}

int Interpreter::coming_plane() const {
  const Code* plane = block_.code(Group::kPlane);
  return plane != nullptr ? plane->tenths / 10 : machine_.state.plane;
}

bool Interpreter::coming_diameters() const {
  const Code* lathe = block_.code(Group::kLathe);
  return lathe != nullptr ? lathe->tenths == 70 : machine_.state.diameter;
}

// NGC-DIA-02
Flow Interpreter::check_diameters() {
  const State& state = machine_.state;
  if (coming_diameters() != state.diameter && block_.has('X')) {
    return unsupported("X where G7 or G8 changes the mode");
  }
  if (!coming_diameters()) return Flow::kContinue;
  const Code* centre = block_.code(Group::kArcDistance);
  const bool absolute = centre != nullptr ? centre->tenths == 901 : state.absolute_centre;
  if (block_.has('I') && absolute) return unsupported("I under G7 and G90.1");
  return is_cycle(coming_motion()) && coming_plane() == 19 ? unsupported("A cycle along X under G7")
                                                           : Flow::kContinue;
}

// NGC-POL-04
Flow Interpreter::check_polar_words() {
  const Motion motion = coming_motion();
  if (!is_polar(block_) || motion == Motion::kNone) return Flow::kContinue;
  const bool ends = motion == Motion::kRapid || motion == Motion::kLine || is_arc(motion);
  const bool in_xy = machine_.state.plane == 17 && coming_plane() == 17;
  const Code* distance = block_.code(Group::kDistance);
  const State& state = machine_.state;
  const bool adds = distance != nullptr ? distance->tenths == 910 : state.incremental;
  const bool has_angle =
      adds || block_.has('^') || state.position[GONOGO_X] != 0 || state.position[GONOGO_Y] != 0;
  const bool is_clear = in_xy && !block_.twice_polar() && !coming_diameters() && has_angle;
  return (ends || is_cycle(motion)) && is_clear ? Flow::kContinue
                                                : unsupported("polar words of this motion");
}

// What the control can do and this expander cannot; it goes before every alarm of the block but
// that of a code that the control does not know, which may have been another motion.
Flow Interpreter::check_coverage() {
  if (const Code* code = block_.outside()) return unsupported(code_name('G', code->tenths));
  for (const char address : {'B', 'U', 'V', 'W'}) {
    if (block_.has(address)) return unsupported({&address, 1});
  }
  if (const Flow lathe = check_diameters(); lathe != Flow::kContinue) return lathe;
  if (const Flow polar = check_polar_words(); polar != Flow::kContinue) return polar;
  const Motion motion = coming_motion();
  const bool synchronous = motion == Motion::kG33 || motion == Motion::kG331;
  if (synchronous && !block_.unknown_code() && block_.has_any(kRotaryWords))
    return unsupported("G33 with a rotary axis");
  for (const FunctionWord& word : block_.functions()) {
    if (word.kind != nullptr && word.kind->group == FunctionGroup::kOutside) {
      return unsupported(code_name('M', *word.number * 10));
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
  check_numbers();
  for (const FunctionWord& word : block_.functions()) check_signal(word);
}

namespace {

bool is_below_zero(const Decimal& number) {
  return number.minus && (number.value != 0 || number.finer || number.overflow);
}

}  // namespace

// NGC-COM-09
void Interpreter::check_numbers() {
  for (const char address : {'S', 'T'}) {
    if (!block_.has(address)) continue;
    const Decimal& number = block_.number(address);
    if (is_below_zero(number)) {
      machine_.complain(AlarmKind::kValueSign, address, block_);
    } else if (address == 'T' && !number.overflow && !machine_.whole.function(number)) {
      machine_.complain(AlarmKind::kNotAnInteger, 'T', block_);
    } else if (address == 'T' && number.value > 0 &&
               machine_.follows("ngc.missing-tool=alarm"_reading)) {
      machine_.complain(AlarmKind::kNoTool, 'T', block_);  // no profile with tools is taken
    }
  }
}

// NGC-COM-09: the words of M61 to M68.
void Interpreter::check_signal(const FunctionWord& word) {
  const auto need = [&](char address) {
    if (!block_.has(address)) {
      machine_.complain(AlarmKind::kMissingWord, address, word.position);
    } else if (address != 'P' && is_below_zero(block_.number(address))) {
      machine_.complain(AlarmKind::kValueSign, address, block_);
    }
  };
  const Fixed m = word.number.value_or(0);
  if (m == 61) {
    need('Q');
    if (block_.has('Q') && block_.number('Q').value > 0 &&
        machine_.follows("ngc.missing-tool=alarm"_reading)) {
      machine_.complain(AlarmKind::kNoTool, 'Q', block_);
    }
  }
  if (m >= 62 && m <= 65) need('P');
  if (m == 66) check_input(word);
  if (m == 67 || m == 68) need('E');
}

void Interpreter::check_input(const FunctionWord& word) {
  if (block_.has('P') && block_.has('E')) {
    return machine_.complain(AlarmKind::kConflictingWords, 'E', block_);
  }
  const char input = block_.has('E') ? 'E' : 'P';
  if (!block_.has(input)) {
    machine_.complain(AlarmKind::kMissingWord, 'P', word.position);
  } else if (is_below_zero(block_.number(input))) {
    machine_.complain(AlarmKind::kValueSign, input, block_);
  }
  if (!block_.has('L')) return;
  const Decimal& mode = block_.number('L');
  if (is_below_zero(mode)) return machine_.complain(AlarmKind::kValueSign, 'L', block_);
  const auto whole = machine_.whole.function(mode);
  if (!whole && !mode.overflow) return machine_.complain(AlarmKind::kNotAnInteger, 'L', block_);
  if (whole && *whole == 0) return;
  if (input == 'E') machine_.complain(AlarmKind::kConflictingWords, 'L', block_);
  if (!block_.has('Q')) return machine_.complain(AlarmKind::kMissingWord, 'Q', word.position);
  const Decimal& wait = block_.number('Q');
  const bool waits = !wait.minus && (wait.value != 0 || wait.finer || wait.overflow);
  if (!waits) machine_.complain(AlarmKind::kValueSign, 'Q', block_);
}

bool Interpreter::check_functions() {
  constexpr std::size_t kMost = 4;
  std::uint32_t groups = 0;
  if (block_.functions().size() > kMost) {  // NGC-COM-01
    machine_.complain(AlarmKind::kDuplicateWord, 'M', block_.functions()[kMost].position);
    return false;
  }
  for (const FunctionWord& word : block_.functions()) {
    if (word.kind != nullptr) {
      const auto group = static_cast<unsigned>(word.kind->group);
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

Flow Interpreter::perform_plan(Plan& plan) {
  const Flow before = run_functions(true);
  if (before != Flow::kContinue) return before;
  if (!machine_.tracer.dwell(plan.dwell)) return Flow::kStopped;
  if (!plan.motion.perform()) return Flow::kStopped;
  return plan.alarms_late ? Flow::kAlarm : run_functions(false);
}

// The M functions of the block that run before or after its motion, and the end of the program.
Flow Interpreter::run_functions(bool before) {
  // Each group has one at most.
  std::array<const FunctionWord*, kFunctionGroups> by_group{};
  for (const FunctionWord& word : block_.functions()) {
    by_group[static_cast<std::size_t>(word.kind->group)] = &word;
  }
  for (const FunctionWord* word : by_group) {
    if (word == nullptr) continue;
    const Fixed m = *word->number;
    if (is_after_motion(m) == before) continue;
    if (!machine_.tracer.function(static_cast<int>(m))) return Flow::kStopped;
    if (!is_end(m)) continue;
    ended_ = true;
    if (machine_.spares("end-ignored"_fault)) return Flow::kEnd;
  }
  return Flow::kContinue;
}

}  // namespace gonogo::expanders::ngc
