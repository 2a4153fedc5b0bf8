// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "expanders/common/axes.hpp"
#include "expanders/common/profile_reader.hpp"

namespace gonogo::expanders::gsk {

enum class Decimals { kKeep, kNearest, kAlarm };

/// How a thread mill leaves the thread: to a point by radius and angle, or straight at an angle
/// from the normal or the tangent. kOwn, where the profile leaves it open, is kPolar.
enum class RunOut { kOwn, kPolar, kRadial, kTangent };

/// The machine: what its parameters and options fix. Lengths are true millimetres.
struct Configuration {
  bool fine = false;  ///< increment system ISC
  bool x_diameter = true;
  bool block_skip = false;
  Fixed radius_tolerance = kOne / 100;  ///< parameter 3410
  Fixed run_out_angle = 0;              ///< parameter 5920, degrees
  Fixed run_out_distance = 0;           ///< parameter 5921
  Point reference_point{};

  // State at power-on.
  Point position{};
  Fixed feed = 0;
  bool inch = false;
  int plane = 18;
  int motion = 0;

  // Options; false is the standard machine.
  bool pocket_ends_at_r_plane = false;      ///< gsk.pocket.end
  bool g94_rewrite_clears = false;          ///< gsk.g94.rewrite
  bool g94_cancelled_by_00 = false;         ///< gsk.g94.after-00
  bool g94_repeats_empty = false;           ///< gsk.g94.empty-block
  bool incomplete_positions = false;        ///< gsk.missing-axis
  bool zero_depth_alarms = false;           ///< gsk.zero-depth
  bool pockets_apart = false;               ///< gsk.pocket.pair
  bool pocket_r_modal = false;              ///< gsk.pocket.R
  bool x_depth_radius = false;              ///< gsk.x-depth
  bool later_wins = false;                  ///< gsk.duplicate, parameter 3403#6
  bool g94_cleared_by_cycles = false;       ///< gsk.g94.in-mode
  bool zero_depth_ends_at_r_plane = false;  ///< gsk.zero-depth-end
  bool lead_is_feed = false;                ///< gsk.g92.lead
  bool dwell_may_be_empty = false;          ///< gsk.dwell-without-word
  bool zero_tolerance_checks = false;       ///< gsk.arc.tolerance-zero
  bool initial_plane_kept = false;          ///< gsk.g50.initial-plane
  bool helix_enters_at_p = false;           ///< gsk.helix.entry-side
  bool helix_ends_flat = false;             ///< gsk.helix.flat
  bool helix_turns_modal = false;           ///< gsk.helix.L
  bool thread_path_plain = false;           ///< gsk.thread.path
  bool thread_depth_from_initial = false;   ///< gsk.thread.v-from
  bool threads_one_mode = false;            ///< gsk.thread.mode
  bool thread_not_modal = false;            ///< gsk.thread.modal
  bool thread_direction_free = false;       ///< gsk.thread.direction
  bool thread_r_required = false;           ///< gsk.thread.r
  bool thread_angle_unlimited = false;      ///< gsk.thread.k-range
  Decimals decimals = Decimals::kKeep;      ///< gsk.decimals
  RunOut run_out = RunOut::kOwn;            ///< gsk.thread.runout
};

/// Reads {"dialect", "profile"}. When it cannot, `message` says what is not implemented or wrong.
ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message);

}  // namespace gonogo::expanders::gsk
