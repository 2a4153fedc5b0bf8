// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/interpreter.hpp"
#include "expanders/sinumerik/machine.hpp"

namespace gonogo::expanders::sinumerik {

/// Reads a block and computes its values, takes its words in the order of their action, checks,
/// moves.
class Interpreter final : public expanders::Interpreter {
 public:
  using Memory = Parameters;  // of the last run, for the fault that lets them survive
  static constexpr std::size_t kFaultCount = kFaults.size();
  static constexpr std::string_view kDescription =
      R"({"protocol":1,"subject":{"name":"gonogo-sinumerik","version":"0.1.0"},)"
      R"("dialects":{"sinumerik840d":["basic","arc","cr","ar","polar","planes","helix","cip","ct",)"
      R"("expressions","rotary"],)"
      R"("sinumerik802s":["basic","arc","cr","ar","polar","planes","helix","cip","ct",)"
      R"("expressions","rotary","frames","lcyc82","lcyc75"]},"features":["blocks","m","bytes"],)"
      R"("numeric":{"kind":"fixed","resolution":"0.001","feed_resolution":"0.001","chord":"0"},)"
      R"("readings":["*"],"max_in_flight":1})";
  static std::span<const ProfileTable> profiles();

  Interpreter(const MachineProfile& profile, const gonogo_sink_v1& sink, Planted<Fault> planted);

  void recall(const Memory& parameters) { machine_.state.parameters = parameters; }
  Memory memory() const {
    const bool survive = machine_.has("parameters-survive-reset"_fault);
    return survive ? machine_.state.parameters : Memory{};
  }

 private:
  Lines lines() const override;
  Flow run_line(std::string_view line) override;
  Flow run_block();
  void check_block();
  void check_functions();
  bool has_large_function() const;
  bool dwells_for_unknown_turns() const;
  void prepare(Plan& plan);
  bool prepare_alone(Plan& plan);
  void take_modes();
  void take_feed_mode(const Code& code);
  void take_feed();
  void take_spindle();
  void take_tool();
  void prepare_motion(Plan& plan);
  Flow run_functions(bool before);

  Machine machine_;
  Block block_;
  bool any_block_ = false;
};

}  // namespace gonogo::expanders::sinumerik
