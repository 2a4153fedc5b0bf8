// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "expanders/ngc/plan.hpp"

namespace gonogo::expanders::ngc {

/// Runs one program from the state of power-on, block by block: reads a block, takes its words in
/// the order of their action, checks, moves. Uses no memory that grows with the program.
class Interpreter {
 public:
  Interpreter(const Configuration& configuration, const gonogo_sink_v1& sink, const Faults& planted)
      : machine_(configuration, sink, planted) {}

  /// What `run` of the C interface answers.
  gonogo_answer run(std::string_view program);

  Machine& machine() { return machine_; }

 private:
  Block::Manner manner() const;
  Flow run_line(std::string_view line);
  Flow run_tape_mark(bool first);
  Flow refuse_line();
  bool refuses_number() const;
  Flow check_end();
  Flow run_block();
  Motion coming_motion() const;
  int coming_plane() const;
  bool coming_diameters() const;
  Flow check_diameters();
  Flow check_polar_words();
  Flow check_coverage();
  void check_block();
  void check_numbers();
  void check_signal(const FunctionWord& word);
  void check_input(const FunctionWord& word);
  bool check_functions();
  void prepare(Plan& plan);
  void take_feed_mode();
  void take_feed();
  void take_saved(Plan& plan);
  void take_spindle();
  void take_modes();
  void take_distance();
  void take_motion();
  void take_retract();
  void remember_steps();
  bool runs_motion() const;
  void check_uses();
  bool lacks_axis() const;
  void check_spindle();
  void prepare_motion(Plan& plan);
  Flow perform_plan(const Plan& plan);
  Flow run_functions(bool before);
  Flow unsupported(std::string_view what);
  Flow unsupported(char letter, unsigned tenths);

  Machine machine_;
  Block block_;
  bool any_line_ = false;  // a line that is not blank
  bool opened_ = false;    // by a tape mark
  bool ended_ = false;
};

}  // namespace gonogo::expanders::ngc
