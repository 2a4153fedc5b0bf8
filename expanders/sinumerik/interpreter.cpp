// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/interpreter.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "expanders/common/program_loop.hpp"
#include "expanders/sinumerik/cycles.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// Stops and ends; every other function runs before the motion of its block.
bool is_after_motion(Fixed m) {
  return ends_program(m) || m == 0 || m == 1;
}

bool is_whole(const Decimal& number) {
  return !number.overflow && !number.finer && number.value % kOne == 0;
}

Motion motion_of(const Code& code) {
  if (code.number == kThroughPointCode) return Motion::kThroughPoint;
  return code.number == kTangentCode ? Motion::kTangent : static_cast<Motion>(code.number);
}

bool is_arc(Motion motion) {
  return motion == Motion::kClockwise || motion == Motion::kCounterclockwise;
}

const Target* target_of(const Plan& plan) {
  if (const auto* line = std::get_if<Line>(&plan.motion)) return &line->target;
  if (const auto* arc = std::get_if<Arc>(&plan.motion)) return &arc->target;
  if (const auto* arc = std::get_if<SpaceArc>(&plan.motion)) return &arc->target;
  if (const auto* drilling = std::get_if<Drilling>(&plan.motion)) return &drilling->target;
  if (const auto* pocketing = std::get_if<Pocketing>(&plan.motion)) return &pocketing->target;
  return nullptr;
}

}  // namespace

gonogo_answer Interpreter::run(std::string_view program) {
  const bool pairs_twice = machine_.has(Fault::kCrLfCountedTwice);
  const Counting counting = pairs_twice ? Counting::kPairTwice : Counting::kAll;
  std::uint64_t& line = machine_.state.line;
  const Flow flow =
      run_lines(program, counting, line, [this](std::string_view text) { return run_line(text); });
  const unsigned late = machine_.has(Fault::kAlarmNextBlock) ? 1 : 0;
  auto send_alarm = [&] {
    machine_.tracer.alarm(text_of(machine_.alarm().kind), machine_.alarm().word, line + late);
  };
  return close_program(flow, send_alarm, [this] { return machine_.tracer.end(); });
}

Block::Manner Interpreter::manner() const {
  Block::Manner manner;
  // SIE-MOD-05
  manner.skips = machine_.configuration.block_skip || machine_.has(Fault::kBlockSkipAlways);
  manner.assigns_late = machine_.has(Fault::kAssignmentLate);
  manner.tokens.capitals_only = machine_.has(Fault::kCapitalsOnly);
  manner.tokens.left_to_right = machine_.has(Fault::kLeftToRight);
  manner.tokens.ignores_absolute = machine_.has(Fault::kAbsoluteIgnored);
  manner.tokens.ignores_incremental = machine_.has(Fault::kIncrementalIgnored);
  manner.tokens.control = machine_.configuration.control;
  // SIE-FRM-03
  manner.tokens.rotation_needs_equals = !machine_.configuration.rotation_is_lenient;
  return manner;
}

Flow Interpreter::run_line(std::string_view line) {
  switch (block_.read(line, manner(), machine_.state.parameters)) {
    case Block::Reading::kSyntax:
      machine_.complain(AlarmKind::kSyntax, 0, 0);
      return Flow::kAlarm;
    case Block::Reading::kOutside:
      return unsupported();
    case Block::Reading::kSkipped:
      return Flow::kContinue;
    case Block::Reading::kWords:
      break;
  }
  return block_.items() == 0 ? Flow::kContinue : run_block();
}

// No text says how far the M functions of the 802S go; to 99 every one has them.
bool Interpreter::has_large_function() const {
  if (machine_.configuration.control != Control::k802S) return false;
  constexpr Fixed kMost = std::numeric_limits<std::int32_t>::max();
  const auto& words = block_.functions();
  return std::any_of(words.begin(), words.end(), [](const FunctionWord& word) {
    const Decimal& number = word.value.number;
    return is_whole(number) && number.value > 99 * kOne && number.value / kOne <= kMost;
  });
}

Flow Interpreter::run_block() {
  warn();
  const bool is_known = !block_.unknown().found() && !block_.undefined().found();
  if (is_known && has_large_function()) {
    return not_implemented(machine_.tracer, "A large M function");
  }
  check_block();
  if (machine_.in_alarm()) return Flow::kAlarm;
  Plan plan;
  prepare(plan);
  if (machine_.in_alarm()) return Flow::kAlarm;
  if (!machine_.lacking.empty()) return not_implemented(machine_.tracer, machine_.lacking);
  return perform_plan(plan);
}

// What the control can do and this expander cannot; it goes before every alarm of the block.
Flow Interpreter::unsupported() {
  return not_implemented(machine_.tracer, block_.outside());
}

void Interpreter::warn() {
  if (block_.has_loose_rotation()) {
    machine_.tracer.note(GONOGO_NOTE_WARNING, "RPL stands without its =.");
  }
  for (const std::string_view name : block_.warnings()) {
    char message[64];
    const int size = std::snprintf(message, sizeof message, "%.*s is passed over.",
                                   static_cast<int>(name.size()), name.data());
    machine_.tracer.note(GONOGO_NOTE_WARNING, {message, static_cast<std::size_t>(size)});
  }
}

// What can be said of the block before any word takes effect.
void Interpreter::check_block() {
  if (block_.unknown().found()) {
    return machine_.complain(AlarmKind::kUndefinedCode, block_.unknown().letter, 0);
  }
  const Defect& undefined = block_.undefined();
  if (undefined.found()) {
    machine_.complain(AlarmKind::kValueOutOfRange, undefined.letter, undefined.position);
  }
  const Defect& duplicate = block_.duplicate();
  if (duplicate.found()) {
    machine_.complain(AlarmKind::kDuplicateWord, duplicate.letter, duplicate.position);
  }
  check_functions();
  check_sizes(machine_, block_);
}

void Interpreter::check_functions() {
  constexpr Fixed kMost = std::numeric_limits<std::int32_t>::max();
  for (const FunctionWord& word : block_.functions()) {
    const Decimal& number = word.value.number;
    if (!number.overflow && !is_whole(number)) {
      machine_.complain(AlarmKind::kNotAnInteger, 'M', word.position);
    } else if (number.overflow || number.value < 0 || number.value / kOne > kMost) {
      machine_.complain(AlarmKind::kValueOutOfRange, 'M', word.position);
    }
  }
}

// SIE-FRM-04, SIE-LC82-03: frames and cycles, which share their block with nothing.
bool Interpreter::prepare_alone(Plan& plan) {
  const Code* frame = block_.code(Group::kProgrammedFrame);
  const Code* cycle = block_.code(Group::kCycle);
  if (frame != nullptr) {
    take_frame(machine_, block_, frame->number);
  } else if (cycle != nullptr && cycle->number == kPocketCode) {
    prepare_pocket(machine_, block_, plan);
  } else if (cycle != nullptr) {
    prepare_drilling(machine_, block_, plan);
  }
  return frame != nullptr || cycle != nullptr;
}

void Interpreter::prepare(Plan& plan) {
  if (prepare_alone(plan)) return;
  refuse(machine_, block_, bit(Address::kRotation));
  const Code* once = block_.code(Group::kOnce);
  if (once == nullptr) {
    take_modes();
    take_feed();
    take_spindle();
    take_tool();
    return prepare_motion(plan);
  }
  if (once->number == 4) return prepare_dwell(machine_, block_, plan);
  take_pole(machine_, block_, once->number);
}

void Interpreter::take_modes() {
  State& state = machine_.state;
  if (const Code* code = block_.code(Group::kPlane)) {
    // SIE-FRM-04
    if (!machine_.frame.allows(code->number)) machine_.complain(AlarmKind::kPlaneNotAllowed);
    state.plane = code->number;
    // SIE-POL-02
    if (!machine_.has(Fault::kPoleKeptByPlane)) place_pole(state, Pole{});
  }
  if (const Code* code = block_.code(Group::kUnits)) state.inch = code->number == 70;
  if (const Code* code = block_.code(Group::kDimension)) state.incremental = code->number == 91;
  if (const Code* code = block_.code(Group::kFeedMode)) {
    state.feed_per_revolution = code->number == 95;
  }
  if (const Code* code = block_.code(Group::kMotion)) state.motion = motion_of(*code);
}

void Interpreter::take_feed() {
  if (!block_.has(Address::kFeed)) return;
  const Fixed written = block_.value(Address::kFeed).number.value;
  if (written < 0) return machine_.complain(AlarmKind::kValueSign, Address::kFeed, block_);
  machine_.state.feed = written;
}

void Interpreter::take_spindle() {
  State& state = machine_.state;
  if (block_.has(Address::kSpindle)) {
    const Decimal& number = block_.value(Address::kSpindle).number;
    if (number.value < 0) machine_.complain(AlarmKind::kValueSign, Address::kSpindle, block_);
    state.speed = number.overflow ? kLargest : number.value;
    state.speed_given = state.speed > 0;
  }
  for (const FunctionWord& word : block_.functions()) {
    const Fixed m = word.value.number.value / kOne;
    if (m >= 3 && m <= 5) state.spindle_turns = m != 5;
  }
}

// T brings D1 into force.
void Interpreter::take_tool() {
  State& state = machine_.state;
  if (block_.has(Address::kTool)) {
    const Decimal& number = block_.value(Address::kTool).number;
    state.tool = is_whole(number) ? number.value / kOne : 0;
    state.has_edge = true;
  }
  if (block_.has(Address::kCuttingEdge)) {
    state.has_edge = block_.value(Address::kCuttingEdge).number.value != 0;
  }
}

// Words that ask for a motion.
void Interpreter::prepare_motion(Plan& plan) {
  constexpr Addresses kAxisWords =
      addresses(Address::kX, Address::kY, Address::kZ, Address::kA, Address::kC);
  constexpr Addresses kWords =
      kAxisWords | kPolarWords | kArcWords | kIntermediateWords | bit(Address::kTurn);
  if (!block_.has_any(kWords)) return;
  switch (machine_.state.motion) {
    case Motion::kRapid:
      return prepare_line(machine_, block_, true, plan);
    case Motion::kLine:
      return prepare_line(machine_, block_, false, plan);
    case Motion::kClockwise:
      return prepare_arc(machine_, block_, false, plan);
    case Motion::kCounterclockwise:
      return prepare_arc(machine_, block_, true, plan);
    case Motion::kThroughPoint:
      return prepare_through_point(machine_, block_, plan);
    case Motion::kTangent:
      return prepare_tangent(machine_, block_, plan);
  }
}

Flow Interpreter::perform_plan(const Plan& plan) {
  const Flow before = run_functions(true);
  if (before != Flow::kContinue) return before;
  const bool goes_on =
      std::visit([&](const auto& motion) { return perform(machine_, motion); }, plan.motion);
  if (!goes_on) return Flow::kStopped;
  take_position(plan);
  return run_functions(false);
}

void Interpreter::take_position(const Plan& plan) {
  State& state = machine_.state;
  if (const Target* target = target_of(plan)) {
    state.position = target->to;
    state.rounded = target->rounded;
    state.remainder = target->remainder;
    state.coarse = target->coarse;
  }
  // SIE-CT-02: motions without length leave it.
  if (plan.heading.known()) state.heading = plan.heading;
  const bool moved = target_of(plan) != nullptr;
  if (moved && machine_.has(Fault::kArcNotModal) && is_arc(state.motion)) {
    state.motion = Motion::kLine;
  }
}

// The M functions of the block that run before or after its motion, and the end of the program.
Flow Interpreter::run_functions(bool before) {
  for (const FunctionWord& word : block_.functions()) {
    const Fixed m = word.value.number.value / kOne;
    if (is_after_motion(m) == before) continue;
    if (!machine_.tracer.function(static_cast<int>(m))) return Flow::kStopped;
    if (ends_program(m) && !machine_.has(Fault::kEndIgnored)) return Flow::kEnd;
  }
  return Flow::kContinue;
}

}  // namespace gonogo::expanders::sinumerik
