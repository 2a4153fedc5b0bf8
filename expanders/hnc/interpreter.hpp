// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "expanders/hnc/plan.hpp"

namespace gonogo::expanders::hnc {

/// Runs one program from the state of power-on, block by block: reads a block, sets the modal
/// codes, checks, moves. Uses no memory that grows with the program.
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
  void check_function();
  void take_modal_codes();
  void take_motion();
  void take_speed();
  void take_feed();
  void take_lead(char address, bool in_inches);
  void prepare(Plan& plan);
  Flow run_function(bool before);
  Flow unsupported(std::string_view what);
  Flow unsupported(char letter, unsigned number);
  Motion coming_motion() const;
  /// G04 or G92: the axis words of the block are not the motion code's.
  bool is_apart() const { return block_.code(Group::kOnce) != nullptr; }
  void take_thread_count();
  AddressSet words_of(Motion motion) const;
  char stray_word(Motion motion) const;

  Machine machine_;
  Block block_;
  bool any_block_ = false;
  bool repeats_ = false;  // the block repeats the command in force
};

}  // namespace gonogo::expanders::hnc
