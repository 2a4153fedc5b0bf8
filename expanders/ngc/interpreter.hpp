// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "expanders/ngc/plan.hpp"

namespace gonogo::expanders::ngc {

/// Runs one program from the state of power-on, block by block: reads a block, takes its words in
/// the order of their action, checks, moves. Uses no memory that grows with the program.
class Interpreter {
 public:
  Interpreter(const Configuration& configuration, const gonogo_sink_v1& sink, Fault fault)
      : machine_(configuration, sink, fault) {}

  /// What `run` of the C interface answers.
  gonogo_answer run(std::string_view program);

  Machine& machine() { return machine_; }

 private:
  Flow run_line(std::string_view line);
  Flow run_block();
  Flow check_coverage();
  void check_block();
  bool check_functions();
  void prepare(Plan& plan);
  void take_feed();
  void take_modes();
  void take_distance();
  void take_motion();
  void prepare_motion(Plan& plan);
  Flow perform_plan(const Plan& plan);
  Flow run_functions(bool before);
  Flow unsupported(std::string_view what);
  Flow unsupported(char letter, unsigned tenths);

  Machine machine_;
  Block block_;
  bool any_block_ = false;
};

}  // namespace gonogo::expanders::ngc
