// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/interpreter.hpp"
#include "expanders/hnc/machine.hpp"

namespace gonogo::expanders::hnc {

/// Reads a block, sets the modal codes, checks, moves.
class Interpreter final : public LetterInterpreter {
 public:
  Interpreter(const MachineProfile& profile, const gonogo_sink_v1& sink, Fault fault);

  State& state() { return machine_.state; }

 private:
  Lines lines() const override;
  LetterBlock::Manner manner() const override;
  void check_coverage() override;
  void check_words() override;
  void prepare(Plan& plan) override;
  void take_modal_codes();
  void take_motion();
  void take_speed();
  void take_feed();
  void take_lead(char address, bool in_inches);
  void take_thread_count();
  Motion coming_motion() const;
  /// G04 or G92: the axis words of the block are not the motion code's.
  bool is_apart() const;
  AddressSet words_of(Motion motion) const;

  Machine machine_;
};

}  // namespace gonogo::expanders::hnc
