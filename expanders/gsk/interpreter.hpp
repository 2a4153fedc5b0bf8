// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/interpreter.hpp"
#include "expanders/gsk/machine.hpp"

namespace gonogo::expanders::gsk {

/// Reads a block, sets the modal codes, checks, moves.
class Interpreter final : public LetterInterpreter {
 public:
  using Memory = Fixed;  // the last feed, for the fault that lets it survive
  static constexpr std::size_t kFaultCount = kFaults.size();
  static constexpr std::string_view kDescription =
      R"({"protocol":1,"subject":{"name":"gonogo-gsk","version":"0.1.0"},)"
      R"("dialects":{"gsk988ta":["basic","arc","g90","g92","g94","g110","g112","g114","g116"]},)"
      R"("features":["blocks","m","bytes"],)"
      R"("numeric":{"kind":"fixed","resolution":"0.001","feed_resolution":"0.001","chord":"0"},)"
      R"("readings":["*"],"max_in_flight":1})";
  static std::span<const ProfileTable> profiles();

  Interpreter(const MachineProfile& profile, const gonogo_sink_v1& sink, Planted<Fault> planted);

  void recall(Fixed feed) {
    if (feed != 0) machine_.state.feed = feed;
  }
  Memory memory() const {
    return machine_.has("feed-survives-reset"_fault) ? machine_.state.feed : 0;
  }

 private:
  Lines lines() const override;
  LetterBlock::Manner manner() const override;
  void check_words() override;
  void prepare(Plan& plan) override;
  Moment moment_of(Fixed m) const override;
  void take_codes();
  /// What lengths and feeds are counted in.
  struct Measures {
    const Plane* plane;
    bool inch;
    bool per_revolution;
  };
  void take_changes(const Measures& before);
  void keep_numbers();
  void take_feed(bool repeats_cycle);
  void take_motion_code();
  /// `other_plane`: than in the block before.
  void take_cycle_code(bool other_plane);
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
