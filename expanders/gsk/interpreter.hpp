// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/interpreter.hpp"
#include "expanders/gsk/machine.hpp"

namespace gonogo::expanders::gsk {

/// Reads a block, sets the modal codes, checks, moves.
class Interpreter final : public LetterInterpreter {
 public:
  Interpreter(const MachineProfile& profile, const gonogo_sink_v1& sink, Fault fault);

  State& state() { return machine_.state; }

 private:
  Lines lines() const override;
  LetterBlock::Manner manner() const override;
  void check_words() override;
  void prepare(Plan& plan) override;
  bool is_late(Fixed m, bool& passed) const override;
  void take_codes();
  void take_feed(bool repeats_cycle);
  void take_motion_code();
  void take_cycle_code();
  void enter_cycle(Cycle cycle);
  void cancel_cycles();
  AddressSet known_words() const;
  void prepare_motion(Plan& plan);
  void prepare_cycle(bool mills, Plan& plan);
  bool is_dwell() const;
  bool is_once() const;

  Machine machine_;
  bool entering_ = false;  // the block's code enters a mode of G110 to G117
};

}  // namespace gonogo::expanders::gsk
