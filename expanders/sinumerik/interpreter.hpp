// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "expanders/sinumerik/plan.hpp"

namespace gonogo::expanders::sinumerik {

/// Runs one program from the state of power-on, block by block: reads a block and reckons its
/// values, takes its words in the order of their action, checks, moves. Uses no memory that grows
/// with the program.
class Interpreter {
 public:
  Interpreter(const Configuration& configuration, const gonogo_sink_v1& sink, Fault fault)
      : machine_(configuration, sink, fault) {}

  /// What `run` of the C interface answers.
  gonogo_answer run(std::string_view program);

  Machine& machine() { return machine_; }

 private:
  Block::Manner manner() const;
  Flow run_line(std::string_view line);
  Flow run_block();
  Flow unsupported();
  void warn();
  void check_block();
  void check_functions();
  bool has_large_function() const;
  void prepare(Plan& plan);
  void take_feed();
  void take_spindle();
  void take_tool();
  bool prepare_alone(Plan& plan);
  void take_modes();
  void prepare_motion(Plan& plan);
  Flow perform_plan(const Plan& plan);
  void take_position(const Plan& plan);
  Flow run_functions(bool before);

  Machine machine_;
  Block block_;
};

}  // namespace gonogo::expanders::sinumerik
