// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/interpreter.hpp"
#include "expanders/sinumerik/machine.hpp"

namespace gonogo::expanders::sinumerik {

/// Reads a block and reckons its values, takes its words in the order of their action, checks,
/// moves.
class Interpreter final : public expanders::Interpreter {
 public:
  Interpreter(const MachineProfile& profile, const gonogo_sink_v1& sink, Fault fault);

  State& state() { return machine_.state; }

 private:
  Lines lines() const override;
  Flow run_line(std::string_view line) override;
  Flow run_block();
  void check_block();
  void check_functions();
  bool has_large_function() const;
  void prepare(Plan& plan);
  bool prepare_alone(Plan& plan);
  void take_modes();
  void take_feed();
  void take_spindle();
  void take_tool();
  void prepare_motion(Plan& plan);
  Flow run_functions(bool before);

  Machine machine_;
  Block block_;
};

}  // namespace gonogo::expanders::sinumerik
