// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "expanders/common/axes.hpp"
#include "expanders/common/profile_reader.hpp"
#include "expanders/sinumerik/names.hpp"

namespace gonogo::expanders::sinumerik {

/// What becomes of the centre of an arc whose end is off its circle by less than the tolerance.
enum class Correction {
  kStartRadius,  ///< moved so that the radius is that of the start
  kProject,      ///< moved square onto the bisector of the chord
  kProgrammed    ///< kept
};

/// The machine: what its data and options fix. Lengths are millimetres.
struct Configuration {
  Control control = Control::k840D;
  std::map<Fixed, Fixed> tools;  ///< radius by T number
  bool block_skip = false;
  Fixed circle_error_constant = kOne / 100;  ///< mm
  Fixed circle_error_factor = kOne / 1000;   ///< of the radius at the start

  // State at power-on.
  bool inch = false;
  Point position{};
  Fixed feed = 0;
  int plane = 17;
  int motion = -1;  ///< number of the G code; below 0: by `starts_rapid`
  bool spindle_turns = false;

  // Options; the first is the standard machine.
  Correction correction = Correction::kStartRadius;  ///< sie.arc.correct
  bool radius_tolerance = false;                     ///< sie.cr.tolerance = const
  bool spindle_checked = false;                      ///< sie.spindle = alarm
  bool starts_rapid = false;                         ///< sie.initial-motion = g0
  bool feed_in_inches = false;                       ///< sie.g70.f = inch
  // Those of 802S.
  bool shifts_add = false;               ///< sie.g158 = additive
  bool rotation_only = false;            ///< sie.g258 = rotation-only
  bool rotation_is_lenient = true;       ///< sie.rpl-equals = lenient
  bool infeeds_with_rest = false;        ///< sie.infeed = max-rest
  bool infeeds_from_clearance = false;   ///< sie.infeed-from = clearance
  bool large_corners_refused = false;    ///< sie.corner = reject
  bool cycles_in_inches = false;         ///< sie.lcyc.unit = inch
  bool depth_allowance_limited = false;  ///< sie.lc75.r125-limit = alarm
};

/// Reads {"dialect", "profile"}. When it cannot, `message` says what is not implemented or wrong.
ConfigurationResult read_configuration(std::string_view json, Configuration& configuration,
                                       std::string& message);

}  // namespace gonogo::expanders::sinumerik
