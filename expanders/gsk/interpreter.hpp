// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "expanders/gsk/plan.hpp"

namespace gonogo::expanders::gsk {

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
  Flow check_codes();
  Flow take_modal_codes();
  Flow take_feed(bool repeats_cycle);
  void take_motion_code();
  void take_cycle_code();
  void enter_cycle(Cycle cycle);
  void cancel_cycles();
  AddressSet known_words() const;
  Flow check_stray_words();
  Flow prepare(Plan& plan);
  Flow prepare_cycle(bool mills, Plan& plan);
  Flow run_functions(bool before);
  bool is_dwell() const { return block_.has_code(Group::kNonModal, 40); }
  Flow unsupported(std::string_view what);
  Flow unsupported(char letter, unsigned tenths);

  Machine machine_;
  Block block_;
  bool entering_ = false;  // the block's code enters a mode of G110 to G117
  bool any_block_ = false;
};

}  // namespace gonogo::expanders::gsk
