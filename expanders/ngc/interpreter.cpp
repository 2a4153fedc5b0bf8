// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/interpreter.hpp"

#include <algorithm>
#include <cstdio>

#include "expanders/common/program_loop.hpp"

namespace gonogo::expanders::ngc {
namespace {

constexpr AddressSet kAxisWords{"XYZAC"};
constexpr AddressSet kCentreWords{"IJK"};

bool is_end(Fixed m) {
  return m == 2 || m == 30;
}

// Stops; every other function runs before the motion of its block.
bool is_after_motion(Fixed m) {
  return is_end(m) || m == 0 || m == 1 || m == 60;
}

}  // namespace

gonogo_answer Interpreter::run(std::string_view program) {
  const bool pairs_twice = machine_.has(Fault::kCrLfCountedTwice);
  const Counting counting = pairs_twice ? Counting::kPairTwice : Counting::kAll;
  std::uint64_t& line = machine_.state.line;
  Flow flow =
      run_lines(program, counting, line, [this](std::string_view text) { return run_line(text); });
  if (flow == Flow::kContinue) flow = check_end();
  const unsigned late = machine_.has(Fault::kAlarmNextBlock) ? 1 : 0;
  auto send_alarm = [&] {
    machine_.tracer.alarm(text_of(machine_.alarm().kind), machine_.alarm().word, line + late);
  };
  return close_program(flow, send_alarm, [this] { return machine_.tracer.end(); });
}

// NGC-COM-08
Flow Interpreter::check_end() {
  machine_.state.line = std::max<std::uint64_t>(machine_.state.line, 1);
  const bool closed = opened_ && machine_.has(Fault::kSecondTapeMarkOptional);
  if (ended_ || closed || machine_.configuration.needs_no_end) return Flow::kContinue;
  machine_.complain(AlarmKind::kProgramEnd);
  return Flow::kAlarm;
}

Block::Manner Interpreter::manner() const {
  return {
      .block_delete =
          machine_.configuration.block_delete || machine_.has(Fault::kBlockDeleteAlways),
      .capitals_only = machine_.has(Fault::kCapitalsOnly),
      .forgets_g80 = machine_.configuration.forgets_g80,
      .last_motion_wins = machine_.has(Fault::kLastMotionWins),
      .blanks_end_numbers = machine_.has(Fault::kBlanksEndNumbers),
      .open_line_numbers = machine_.has(Fault::kOpenLineNumbers),
      .whole = machine_.whole,
  };
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
  if (!(comment && machine_.has(Fault::kTapeMarkAfterComment))) any_line_ = true;
  switch (reading) {
    case Block::Reading::kSyntax:
      return refuse_line();
    case Block::Reading::kMacro:
      return unsupported(block_.macro());
    case Block::Reading::kTapeMark:
      return run_tape_mark(first);
    case Block::Reading::kName:
      if (machine_.configuration.refuses_names) return refuse_line();
      return machine_.has(Fault::kNameEndsProgram) ? Flow::kEnd : Flow::kContinue;
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
  if (!opened_ && !machine_.has(Fault::kTapeMarkAnywhere)) return refuse_line();
  ended_ = true;
  return machine_.has(Fault::kTapeMarkIgnored) ? Flow::kContinue : Flow::kEnd;
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
  return machine_.in_alarm() ? Flow::kAlarm : perform_plan(plan);
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
  check_sizes(machine_, block_);
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

// NGC-MOD-01: in a fixed order, whatever that of the line.
void Interpreter::prepare(Plan& plan) {
  const bool feed_last = machine_.has(Fault::kFeedAfterMotion);
  const bool plane_last = machine_.has(Fault::kPlaneAfterMotion);
  const int plane = machine_.state.plane;
  if (!feed_last) take_feed();
  if (block_.has_dwell()) prepare_dwell(machine_, block_, plan);
  take_modes();
  const int coming = machine_.state.plane;
  if (plane_last) machine_.state.plane = plane;
  take_distance();
  take_motion();
  prepare_motion(plan);
  machine_.state.plane = coming;
  if (feed_last) take_feed();
  if (machine_.has(Fault::kMotionLostAfterDwell) && block_.has_dwell()) {
    machine_.state.motion = Motion::kNone;
  }
}

// F counts in the units of the block before: G20 and G21 act later.
void Interpreter::take_feed() {
  if (!block_.has('F')) return;
  const Fixed written = block_.number('F').value;
  if (written < 0) return machine_.complain(AlarmKind::kValueSign, 'F', block_);
  const bool unscaled = machine_.has(Fault::kInchFeedUnscaled);
  machine_.state.feed.linear = unscaled ? written : length_of(machine_, block_, 'F');
  machine_.state.feed.rotary = written;
}

void Interpreter::take_modes() {
  State& state = machine_.state;
  if (const Code* code = block_.code(Group::kPlane)) state.plane = code->tenths / 10;
  if (const Code* code = block_.code(Group::kUnits)) state.inch = code->tenths == 200;
}

void Interpreter::take_distance() {
  State& state = machine_.state;
  if (const Code* code = block_.code(Group::kDistance)) {
    const bool latched = machine_.has(Fault::kG91IgnoredAfterG90) && state.seen_absolute;
    state.incremental = code->tenths == 910 && !latched;
    state.seen_absolute = state.seen_absolute || code->tenths == 900;
  }
  if (const Code* code = block_.code(Group::kArcDistance)) {
    state.absolute_centre = code->tenths == 901;
  }
}

void Interpreter::take_motion() {
  const Code* code = block_.code(Group::kMotion);
  if (code == nullptr) return;
  const Motion motion = motion_of(code->tenths / 10);
  if (motion == Motion::kNone && machine_.has(Fault::kG80KeepsMotion)) return;
  machine_.state.motion = motion;
}

// An arc by its code, by an axis word or, alone, by I J K (NGC-ARC-06).
bool Interpreter::moves_in_arc() const {
  const Motion motion = machine_.state.motion;
  if (motion != Motion::kArcClockwise && motion != Motion::kArcCounterclockwise) return false;
  if (block_.code(Group::kMotion) != nullptr || block_.has_any(kAxisWords)) return true;
  const bool alone = block_.has_any(kCentreWords) && !machine_.has(Fault::kArcWordsNeedCode);
  return alone && !machine_.configuration.arc_needs_axis;
}

// NGC-COM-02
void Interpreter::check_uses() {
  static constexpr AddressSet kOfArcs{"IJKRP"};
  static constexpr AddressSet kOfCodes{"DEHIJKLPQR"};
  if (machine_.configuration.passes_over_words || machine_.has(Fault::kUnusedWordPassed)) return;
  const bool moves = block_.code(Group::kMotion) != nullptr || block_.has_any(kAxisWords);
  if (!moves && machine_.has(Fault::kUnusedAlonePassed)) return;
  const bool arc = moves_in_arc();
  const Motion motion = machine_.state.motion;
  const bool of_arc = motion == Motion::kArcClockwise || motion == Motion::kArcCounterclockwise;
  const bool forgets = of_arc && !moves && machine_.has(Fault::kArcWordsNeedCode);
  for (char address = 'A'; address <= 'Z'; ++address) {
    if (!block_.has(address) || !kOfCodes.has(address)) continue;
    if ((arc && kOfArcs.has(address)) || block_.uses(address)) continue;
    if (forgets && kCentreWords.has(address)) continue;
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
    case Motion::kArcClockwise:
    case Motion::kArcCounterclockwise:
      if (moves_in_arc()) prepare_arc(machine_, block_, plan);
      return;
  }
}

Flow Interpreter::perform_plan(const Plan& plan) {
  const Flow before = run_functions(true);
  if (before != Flow::kContinue) return before;
  if (!machine_.tracer.dwell(plan.dwell)) return Flow::kStopped;
  const bool goes_on =
      std::visit([&](const auto& motion) { return perform(machine_, motion); }, plan.motion);
  return goes_on ? run_functions(false) : Flow::kStopped;
}

// The M functions of the block that run before or after its motion, and the end of the program.
Flow Interpreter::run_functions(bool before) {
  for (const FunctionWord& word : block_.functions()) {
    const Fixed m = *word.number;
    if (is_after_motion(m) == before) continue;
    if (!machine_.tracer.function(static_cast<int>(m))) return Flow::kStopped;
    if (!is_end(m)) continue;
    ended_ = true;
    if (!machine_.has(Fault::kEndIgnored)) return Flow::kEnd;
  }
  return Flow::kContinue;
}

}  // namespace gonogo::expanders::ngc
