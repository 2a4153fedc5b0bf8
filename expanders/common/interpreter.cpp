// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/common/interpreter.hpp"

#include <limits>

#include "expanders/common/program_loop.hpp"

namespace gonogo::expanders {
namespace {

constexpr Fixed kLargestFunction = std::numeric_limits<std::int32_t>::max();

}  // namespace

gonogo_answer Interpreter::run(std::string_view program) {
  const Lines manner = lines();
  const Flow flow = run_lines(program, manner.counting, machine_.line,
                              [this](std::string_view text) { return run_line(text); });
  const auto send_alarm = [&] {
    const auto& [kind, word] = machine_.alarm();
    const AlarmText text{numbers_[static_cast<std::size_t>(kind)], class_of(kind)};
    machine_.tracer.alarm(text, word, machine_.line + (manner.late ? 1 : 0));
  };
  return close_program(flow, send_alarm, [this] { return machine_.tracer.end(); });
}

Flow Interpreter::unsupported(std::string_view what) {
  return not_implemented(machine_.tracer, what);
}

Flow LetterInterpreter::run_line(std::string_view line) {
  switch (block_.read(line, manner())) {
    case LetterBlock::Reading::kSyntax:
      machine().complain(AlarmKind::kSyntax, block_.last_address(), 0);
      return Flow::kAlarm;
    case LetterBlock::Reading::kMacro:
      return unsupported(block_.macro());
    case LetterBlock::Reading::kTapeMark:
      return any_block_ ? Flow::kEnd : Flow::kContinue;
    case LetterBlock::Reading::kSkipped:
      return Flow::kContinue;
    case LetterBlock::Reading::kWords:
      break;
  }
  if (block_.begins_program() && any_block_) return unsupported("A second program");
  if (block_.empty()) return Flow::kContinue;
  any_block_ = true;
  return run_block();
}

Flow LetterInterpreter::run_block() {
  check_outside();
  check_coverage();
  if (!machine().lacking.empty()) return unsupported(machine().lacking);
  check_block();
  if (machine().in_alarm()) return Flow::kAlarm;
  return run_plan([this](Plan& plan) { prepare(plan); },
                  [this](bool before) { return run_function(before); });
}

// Codes and functions of the control that this expander does not have.
void LetterInterpreter::check_outside() {
  if (const Code* code = block_.outside()) machine().lacking = code_name('G', code->tenths);
  if (!block_.has('M') || block_.has_fraction('M') || block_.number('M').overflow) return;
  const Fixed m = block_.number('M').value / kOne;
  if (m == 98 || m == 99) machine().lacking = code_name('M', m * 10);
  if (m > 9'999 && m <= kLargestFunction) machine().lacking = "A large M function";
}

// What can be said of the block before any code takes effect.
void LetterInterpreter::check_block() {
  if (block_.unknown_code()) return machine().complain(AlarmKind::kUndefinedCode, 'G', 0);
  if (block_.duplicate() != 0) {
    return machine().complain(AlarmKind::kDuplicateWord, block_.duplicate(),
                              block_.duplicate_position());
  }
  if (block_.has('M')) {
    const Decimal& m = block_.number('M');
    if (!m.overflow && block_.has_fraction('M')) {
      machine().complain(AlarmKind::kNotAnInteger, 'M', block_);
    } else if (m.overflow || m.value < 0 || m.value / kOne > kLargestFunction) {
      machine().complain(AlarmKind::kValueOutOfRange, 'M', block_);
    }
  }
  check_words();
}

LetterInterpreter::Moment LetterInterpreter::moment_of(Fixed m) const {
  return runs_after_motion(m) ? Moment::kBehind : Moment::kBefore;
}

// The M function of the block: passed on before or after its motion, and the end of the program.
Flow LetterInterpreter::run_function(bool before) {
  if (!block_.has('M')) return Flow::kContinue;
  const Fixed m = block_.number('M').value / kOne;
  if (moment_of(m) != (before ? Moment::kBefore : Moment::kBehind)) return Flow::kContinue;
  if (!machine().tracer.function(static_cast<int>(m))) return Flow::kStopped;
  return ends_program(m) ? Flow::kEnd : Flow::kContinue;
}

char stray_word(const LetterBlock& block, AddressSet known, AddressSet anywhere) {
  for (char address = 'A'; address <= 'Z'; ++address) {
    if (block.has(address) && !known.has(address) && !anywhere.has(address)) return address;
  }
  return 0;
}

}  // namespace gonogo::expanders
