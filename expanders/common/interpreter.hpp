// SPDX-License-Identifier: GPL-3.0-or-later
// The loops that the makers' interpreters share: over lines, and over blocks of letters.
#pragma once

#include "expanders/common/flow.hpp"
#include "expanders/common/letter_block.hpp"
#include "expanders/common/machine.hpp"
#include "expanders/common/plan.hpp"

namespace gonogo::expanders {

/// Runs one program from the state of power-on, line by line. Uses no memory that grows with it.
class Interpreter {
 public:
  Interpreter(const Interpreter&) = delete;
  Interpreter& operator=(const Interpreter&) = delete;
  virtual ~Interpreter() = default;

  /// What `run` of the C interface answers.
  gonogo_answer run(std::string_view program);

 protected:
  /// Faults of the numbering of lines.
  struct Lines {
    Counting counting = Counting::kAll;
    bool late = false;  ///< alarms name the line after
  };
  Interpreter(Machine& machine, const AlarmNumbers& numbers)
      : machine_(machine), numbers_(numbers) {}

  Machine& machine() { return machine_; }
  virtual Lines lines() const = 0;
  virtual Flow run_line(std::string_view line) = 0;
  /// Says that the expander lacks something that the control has.
  Flow unsupported(std::string_view what);
  /// `prepare(plan)`, and performs the plan between the functions of the block.
  template <typename Prepare, typename RunFunctions>
  Flow run_plan(Prepare prepare, RunFunctions run_functions) {
    Plan plan;
    prepare(plan);
    if (machine_.in_alarm()) return Flow::kAlarm;
    if (!machine_.lacking.empty()) return unsupported(machine_.lacking);
    const Flow before = run_functions(true);
    if (before != Flow::kContinue) return before;
    return plan.perform() ? run_functions(false) : Flow::kStopped;
  }

 private:
  Machine& machine_;
  const AlarmNumbers& numbers_;
};

/// For programs of letters and numbers with one M function a block.
class LetterInterpreter : public Interpreter {
 protected:
  using Interpreter::Interpreter;

  virtual LetterBlock::Manner manner() const = 0;
  /// Notes in `lacking` what the control can do and this expander cannot: that goes before every
  /// alarm of the block.
  virtual void check_coverage() {}
  /// Rules of the block that do not depend on its codes.
  virtual void check_words() = 0;
  /// Takes the codes of the block in and prepares its motion.
  virtual void prepare(Plan& plan) = 0;
  enum class Moment { kBefore, kBehind, kNever };
  /// When the M function is put out, seen from the motion.
  virtual Moment moment_of(Fixed m) const;

  const LetterBlock& block() const { return block_; }

 private:
  Flow run_line(std::string_view line) final;
  Flow run_block();
  void check_outside();
  void check_block();
  Flow run_function(bool before);

  LetterBlock block_;
  bool any_block_ = false;
};

/// Letter of the first of the block's words that are in neither set; 0: none.
char stray_word(const LetterBlock& block, AddressSet known, AddressSet anywhere);

}  // namespace gonogo::expanders
