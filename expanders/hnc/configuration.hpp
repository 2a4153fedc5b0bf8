// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "expanders/common/axes.hpp"
#include "expanders/common/profile_reader.hpp"

namespace gonogo::expanders::hnc {

/// What a coordinate that a cycle block does not give stands for.
enum class MissingAxis { kReject, kKeep, kNone, kNothing };

inline constexpr std::size_t kFrames = 6;  // G54 to G59

/// The machine: what its parameters and options fix. Lengths are true millimetres.
struct Configuration {
  bool block_skip = false;
  Fixed radius_tolerance = kOne / 100;  ///< parameter 3410; negative: not checked
  std::array<Point, kFrames> offsets{};

  // State at power-on.
  bool x_diameter = true;
  bool inch = false;
  Point position{};  ///< in the base frame
  Fixed feed = 0;
  int motion = 0;  ///< number of the G code

  // Options; false is the standard machine.
  bool count_in_p = false;                          ///< hnc.g75.i
  bool one_place_less = false;                      ///< hnc.g75.steps
  bool groove_ends_at_last = false;                 ///< hnc.g75.end
  bool approach_mode = false;                       ///< hnc.g75.mode3
  bool groove_depth_diameter = false;               ///< hnc.g75.depth-scale
  bool peck_from_withdrawn = false;                 ///< hnc.peck.from
  bool withdraw_at_feed = false;                    ///< hnc.peck.withdraw
  bool withdrawal_clamped = false;                  ///< hnc.peck.clamp
  bool thread_out_to_start = false;                 ///< hnc.g82.exit
  bool run_out_diameter = false;                    ///< hnc.g82.e-scale
  bool one_start_a_block = false;                   ///< hnc.g82.starts
  bool cycle_feed_forgotten = false;                ///< hnc.modal.f
  bool no_initial_frame = false;                    ///< hnc.offset.initial
  bool lead_in_units = false;                       ///< hnc.lead.unit: F under G20
  bool threads_per_inch = false;                    ///< hnc.lead.unit: J
  bool zero_radius_allowed = false;                 ///< hnc.arc.zero-radius
  MissingAxis missing_axis = MissingAxis::kReject;  ///< hnc.missing-axis
};

/// Reads {"dialect", "profile"}. When it cannot, `message` says what is not implemented or wrong.
ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message);

}  // namespace gonogo::expanders::hnc
