// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "expanders/ngc/plan.hpp"

namespace gonogo::expanders::ngc {

/// Runs one program from the state of power-on, block by block: reads a block, takes its words in
/// the order of their action, checks, moves. Uses no memory that grows with the program.
class Interpreter {
 public:
  using Memory = FeedRate;  // the last feed, for the fault that lets it survive
  static constexpr std::size_t kFaultCount = kFaults.size();
  static constexpr std::string_view kDescription =
      R"({"protocol":1,"subject":{"name":"gonogo-ngc","version":"0.1.0"},)"
      R"("dialects":{"rs274":["basic","arc","arc-r","planes","helix","arc-distance","turns",)"
      R"("lines",)"
      R"("g81","g73","g83","g84","g74","g85","g86","cycle-modal","cycle-steps","cycle-planes",)"
      R"("g33","g33.1","g76","rotary","feed-modes","linuxcnc","polar-words"]},)"
      R"("features":["blocks","m","bytes"],)"
      R"("numeric":{"kind":"fixed","resolution":"0.0001","feed_resolution":"0.0001","chord":"0"},)"
      R"("readings":["*"],"max_in_flight":1})";
  static std::span<const ProfileTable> profiles();

  Interpreter(const MachineProfile& profile, const gonogo_sink_v1& sink, const Faults& planted)
      : machine_(profile, sink, planted) {}

  void recall(const FeedRate& last) {
    FeedRate& feed = machine_.state.feed;
    feed = machine_.alters("feed-survives-reset"_fault, feed, last.linear != 0 ? last : feed);
  }
  Memory memory() const { return machine_.state.feed; }

  /// What `run` of the C interface answers.
  gonogo_answer run(std::string_view program);

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
  Flow perform_plan(Plan& plan);
  Flow run_functions(bool before);
  Flow unsupported(std::string_view what);

  Machine machine_;
  Block block_;
  bool any_line_ = false;  // a line that is not blank
  bool opened_ = false;    // by a tape mark
  bool ended_ = false;
};

}  // namespace gonogo::expanders::ngc
