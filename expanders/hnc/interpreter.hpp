// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/interpreter.hpp"
#include "expanders/hnc/machine.hpp"

namespace gonogo::expanders::hnc {

/// Reads a block, sets the modal codes, checks, moves.
class Interpreter final : public LetterInterpreter {
 public:
  using Memory = Fixed;  // the last feed, for the fault that lets it survive
  static constexpr std::size_t kFaultCount = kFaults.size();
  static constexpr std::string_view kDescription =
      R"({"protocol":1,"subject":{"name":"gonogo-hnc","version":"0.1.0"},)"
      R"("dialects":{"hnc21t":["basic","arc","g32","g74","g75","g80","g81","g82"]},)"
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
  void check_coverage() override;
  void check_words() override;
  void prepare(Plan& plan) override;
  void take_modal_codes();
  void take_units(bool inch);
  void take_motion();
  void take_speed();
  void take_feed();
  void store_feed(Fixed written);
  void take_lead(char address, bool in_inches);
  void take_thread_count();
  Motion coming_motion() const;
  /// G04 or G92: the axis words of the block are not the motion code's.
  bool is_apart() const;
  AddressSet words_of(Motion motion) const;

  Machine machine_;
};

}  // namespace gonogo::expanders::hnc
