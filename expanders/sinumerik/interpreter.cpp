// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/interpreter.hpp"

#include <algorithm>
#include <limits>

namespace gonogo::expanders::sinumerik {
namespace {

constexpr Fixed kLargestFunction = std::numeric_limits<std::int32_t>::max();

// In the order of AlarmKind.
constexpr AlarmNumbers kNumbers{"B01", "B02", "B03", "B04", "B05", "V01", "V02", "V03",
                                "P01", "P06", "P02", "P03", "P04", "P05", "F01", "",
                                "F02", "",    "",    "C05", "",    "",    "",    "",
                                "C01", "C02", "C03", "C04", "C06", "C07"};

// Stops and ends; every other function runs before the motion of its block.
bool is_after_motion(Fixed m) {
  return ends_program(m) || m == 0 || m == 1;
}

bool is_whole(const Decimal& number) {
  return !number.overflow && !number.finer && number.value % kOne == 0;
}

Motion motion_of(const Code& code) {
  if (code.tenths == kThroughPointCode.tenths) return Motion::kThroughPoint;
  return code.tenths == kTangentCode.tenths ? Motion::kTangent
                                            : static_cast<Motion>(code.tenths / 10);
}

}  // namespace

Machine::Machine(const MachineProfile& machine_profile, const gonogo_sink_v1& sink,
                 Planted<Fault> planted)
    : expanders::Machine(machine_profile, sink, output_position_, planted), frame(plain_frame()) {
  std::copy(profile.position.begin(), profile.position.end(), state.position.begin());
  state.inch = profile.inch;
  state.plane = profile.plane;
  state.feed = profile.feed;
  const bool rapid = follows("sie.initial-motion=g0"_reading);
  state.motion = profile.motion >= 0 ? static_cast<Motion>(profile.motion)
                 : rapid             ? Motion::kRapid
                                     : Motion::kLine;
  state.spindle_turns = state.speed_given = profile.spindle_turns;
  output_position_ = output(state.position);
}

Control Machine::control() const {
  return profile.dialect == "sinumerik802s" ? Control::k802S : Control::k840D;
}

Frame Machine::plain_frame() const {
  Frame plain;
  if (has("rotation-about-base"_fault)) plain.turn_about_machine_zero();
  if (has("rotation-flipped-in-g18"_fault)) plain.turn_the_other_way_in_g18();
  return plain;
}

Interpreter::Interpreter(const MachineProfile& profile, const gonogo_sink_v1& sink,
                         Planted<Fault> planted)
    : expanders::Interpreter(machine_, kNumbers), machine_(profile, sink, planted) {}

Interpreter::Lines Interpreter::lines() const {
  const bool twice = machine_.has("cr-lf-counted-twice"_fault);
  return {twice ? Counting::kPairTwice : Counting::kAll, machine_.has("alarm-next-block"_fault)};
}

Flow Interpreter::run_line(std::string_view line) {
  switch (block_.read(line, machine_)) {
    case Block::Reading::kSyntax:
      machine_.complain(AlarmKind::kSyntax, 0, 0);
      return Flow::kAlarm;
    case Block::Reading::kOutside:
      return unsupported(block_.outside());
    case Block::Reading::kTapeMark:
      return any_block_ ? Flow::kEnd : Flow::kContinue;
    case Block::Reading::kSkipped:
      return Flow::kContinue;
    case Block::Reading::kWords:
      break;
  }
  if (block_.items() == 0) return Flow::kContinue;
  any_block_ = true;
  return run_block();
}

// No text says how far the M functions of the 802S go; to 99 every one has them.
bool Interpreter::has_large_function() const {
  if (machine_.control() != Control::k802S) return false;
  const auto& words = block_.functions();
  return std::any_of(words.begin(), words.end(), [](const FunctionWord& word) {
    const Decimal& number = word.number;
    return is_whole(number) && number.value > 99 * kOne && number.value / kOne <= kLargestFunction;
  });
}

// SIE-MOD-07
bool Interpreter::dwells_for_unknown_turns() const {
  const Code* once = block_.code(Group::kOnce);
  return once != nullptr && once->tenths == 40 && block_.has(Address::kSpindle) &&
         machine_.state.turns_unknown;
}

Flow Interpreter::run_block() {
  const bool is_known = !block_.unknown().found() && !block_.undefined().found();
  if (is_known && has_large_function()) return unsupported("A large M function");
  if (is_known && dwells_for_unknown_turns()) return unsupported("A dwell of unknown revolutions");
  check_block();
  if (machine_.in_alarm()) return Flow::kAlarm;
  return run_plan([this](Plan& plan) { prepare(plan); },
                  [this](bool before) { return run_functions(before); });
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
  for (const FunctionWord& word : block_.functions()) {
    const Decimal& number = word.number;
    if (!number.overflow && !is_whole(number)) {
      machine_.complain(AlarmKind::kNotAnInteger, 'M', word.position);
    } else if (number.overflow || number.value < 0 || number.value / kOne > kLargestFunction) {
      machine_.complain(AlarmKind::kValueOutOfRange, 'M', word.position);
    }
  }
}

// SIE-FRM-04, SIE-LC82-03: frames and cycles, which share their block with nothing.
bool Interpreter::prepare_alone(Plan& plan) {
  const Code* frame = block_.code(Group::kProgrammedFrame);
  const Code* cycle = block_.code(Group::kCycle);
  if (frame != nullptr) {
    take_frame(machine_, block_, frame->tenths / 10u);
  } else if (cycle != nullptr && cycle->tenths == kPocketCode.tenths) {
    prepare_pocket(machine_, block_, plan);
  } else if (cycle != nullptr) {
    prepare_drilling(machine_, block_, plan);
  }
  return frame != nullptr || cycle != nullptr;
}

void Interpreter::prepare(Plan& plan) {
  if (prepare_alone(plan)) return;
  refuse(machine_, block_, bit(Address::kRotation));
  if (const Code* once = block_.code(Group::kOnce)) {
    if (once->tenths == 40) return prepare_dwell(machine_, block_, plan);
    return take_pole(machine_, block_, once->tenths / 10u);
  }
  take_modes();
  take_feed();
  take_spindle();
  take_tool();
  prepare_motion(plan);
}

void Interpreter::take_modes() {
  State& state = machine_.state;
  if (const Code* code = block_.code(Group::kPlane)) {
    const int plane = code->tenths / 10;
    // SIE-FRM-04
    if (!machine_.frame.allows(plane)) machine_.complain(AlarmKind::kPlaneNotAllowed);
    // SIE-POL-02, SIE-POL-04
    const bool stays = plane == state.plane && machine_.follows("sie.pole.same-plane=kept"_reading);
    if (!stays && !machine_.has("pole-kept-by-plane"_fault)) place_pole(state, Pole{});
    state.plane = plane;
  }
  if (const Code* code = block_.code(Group::kUnits)) state.inch = code->tenths == 700;
  if (const Code* code = block_.code(Group::kDimension)) state.incremental = code->tenths == 910;
  if (const Code* code = block_.code(Group::kFeedMode)) take_feed_mode(*code);
  if (const Code* code = block_.code(Group::kMotion)) state.motion = motion_of(*code);
}

// SIE-MOD-07, SIE-MOD-08
void Interpreter::take_feed_mode(const Code& code) {
  State& state = machine_.state;
  const bool speed_mode = code.tenths == 960 || code.tenths == 970;
  const bool per_revolution =
      code.tenths == 950 || (speed_mode && !machine_.has("cutting-speed-feeds-per-minute"_fault));
  const bool changes = per_revolution != state.feed_per_revolution;
  if (changes && machine_.follows("sie.feed-change=deleted"_reading)) state.feed = 0;
  state.feed_per_revolution = per_revolution;
  state.constant_cutting_speed = code.tenths == 960 || code.tenths == 9610;
}

void Interpreter::take_feed() {
  if (!block_.has(Address::kFeed)) return;
  const Fixed written = block_.number(Address::kFeed).value;
  if (written < 0) return machine_.complain(AlarmKind::kValueSign, Address::kFeed, block_);
  machine_.state.feed = written;
  machine_.state.feed_of_cycle = false;
}

void Interpreter::take_spindle() {
  State& state = machine_.state;
  if (block_.has(Address::kSpindle)) {
    const Decimal& number = block_.number(Address::kSpindle);
    if (number.value < 0) machine_.complain(AlarmKind::kValueSign, Address::kSpindle, block_);
    state.speed = number.overflow ? kLargest : number.value;
    state.speed_given = state.speed > 0;
    state.turns_unknown = false;
  }
  if (state.constant_cutting_speed) state.turns_unknown = true;
  for (const FunctionWord& word : block_.functions()) {
    const Fixed m = word.number.value / kOne;
    if (m >= 3 && m <= 5) state.spindle_turns = m != 5;
  }
}

// T brings D1 into force.
void Interpreter::take_tool() {
  State& state = machine_.state;
  if (block_.has(Address::kTool)) {
    const Decimal& number = block_.number(Address::kTool);
    state.tool = is_whole(number) ? number.value / kOne : 0;
    state.has_edge = true;
  }
  if (block_.has(Address::kCuttingEdge)) {
    state.has_edge = block_.number(Address::kCuttingEdge).value != 0;
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
    case Motion::kLine:
      return prepare_line(machine_, block_, machine_.state.motion == Motion::kRapid, plan);
    case Motion::kClockwise:
    case Motion::kCounterclockwise:
      return prepare_arc(machine_, block_, machine_.state.motion == Motion::kCounterclockwise,
                         plan);
    case Motion::kThroughPoint:
      return prepare_through_point(machine_, block_, plan);
    case Motion::kTangent:
      return prepare_tangent(machine_, block_, plan);
  }
}

// The M functions of the block that run before or after its motion, and the end of the program.
Flow Interpreter::run_functions(bool before) {
  for (const FunctionWord& word : block_.functions()) {
    const Fixed m = word.number.value / kOne;
    if (is_after_motion(m) == before) continue;
    if (!machine_.tracer.function(static_cast<int>(m))) return Flow::kStopped;
    if (ends_program(m) && !machine_.has("end-ignored"_fault)) return Flow::kEnd;
  }
  return Flow::kContinue;
}

}  // namespace gonogo::expanders::sinumerik
