// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "expanders/gsk/fixed.hpp"
#include "gonogo/subject.h"

namespace gonogo::expanders::gsk {

using Point = std::array<Fixed, GONOGO_AXES>;

enum class Decimals { kKeep, kNearest, kAlarm };

/// The machine: what its parameters and options fix. Lengths are true millimetres.
struct Configuration {
  bool fine = false;  ///< increment system ISC
  bool x_diameter = true;
  bool block_skip = false;
  Fixed radius_tolerance = kOne / 100;  ///< parameter 3410
  Point reference_point{};

  // State at power-on.
  Point position{};
  Fixed feed = 0;
  bool inch = false;
  int plane = 18;
  int motion = 0;

  // Options; false is the standard machine.
  bool pocket_ends_at_r_plane = false;  ///< gsk.pocket.end
  bool g94_rewrite_clears = false;      ///< gsk.g94.rewrite
  bool g94_cancelled_by_00 = false;     ///< gsk.g94.after-00
  bool g94_repeats_empty = false;       ///< gsk.g94.empty-block
  bool incomplete_positions = false;    ///< gsk.missing-axis
  bool zero_depth_alarms = false;       ///< gsk.zero-depth
  bool pockets_apart = false;           ///< gsk.pocket.pair
  bool pocket_r_modal = false;          ///< gsk.pocket.R
  bool x_depth_radius = false;          ///< gsk.x-depth
  bool later_wins = false;              ///< gsk.duplicate, parameter 3403#6
  Decimals decimals = Decimals::kKeep;  ///< gsk.decimals
};

enum class ConfigurationResult { kRead, kUnsupported, kMalformed };

/// Reads {"dialect", "profile"}. When it cannot, `message` says what is not implemented or wrong.
ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message);

}  // namespace gonogo::expanders::gsk
