// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "expanders/common/plan.hpp"
#include "expanders/ngc/polar.hpp"

namespace gonogo::expanders::ngc {

// What a block will do. Preparing a plan checks every rule of the block and complains to the
// machine; performing it cannot fail (false: the sink has asked to stop). So an alarming block
// moves nothing, but where a fault is to be found late.

/// G73, G74, G81 to G86 and G89.
struct Cycle {
  /// How far the first hole gets; less than all of it where a fault is found late.
  enum Extent : std::uint8_t { kLift, kApproach, kAll };

  Motion code = Motion::kNone;
  const Plane* plane = nullptr;
  // Levels.
  Fixed r = 0;
  Fixed bottom = 0;
  Fixed clear = 0;
  Fixed initial = 0;
  // Hole n (0, 1, ...) is at first + n * step, along the axes of the plane.
  Point first{};
  Point step{};
  std::optional<PolarWay> polar;  ///< instead of them
  Fixed count = 1;
  Fixed drift = 0;  ///< of the levels from hole to hole: a planted fault
  Fixed dwell = 0;  ///< seconds
  Fixed infeed = 0;
  Fixed clearance = 0;
  Feed feed;
  int spindle = 5;
  Extent extent = kAll;
};

/// G76, along Z.
struct Threading {
  Fixed x = 0;  ///< drive line
  Fixed z_start = 0;
  Fixed z_end = 0;
  int side = -1;  ///< 1: inside
  int way = -1;   ///< along Z
  Fixed peak = 0;
  Fixed infeed = 0;
  Fixed depth = 0;
  long double degression = 1;
  long double slide = 0;  ///< along Z for a depth of 1
  Fixed springs = 0;
  Fixed taper = 0;
  bool tapers_in = false;
  bool tapers_out = false;
  Fixed lead = 0;
  Fixed taper_lead = 0;
  Fixed entry_lead = 0;
  Feed feed;
  Point end{};
  Axes end_axes = 0;
};

struct Plan {
  Fixed dwell = 0;  ///< seconds; before the motion
  expanders::Plan motion;
  bool alarms_late = false;     ///< the machine is in alarm, and moves before
  bool reaches_motion = false;  ///< nothing is wrong but what the motion finds
  std::string_view outside;     ///< what is not implemented; empty: nothing
};

/// NGC-FED-01: the speed at which a way takes 1/F minutes.
Fixed timed_feed(const Block& block, long double way);
void prepare_line(Machine& machine, const Block& block, Plan& plan);
void prepare_arc(Machine& machine, const Block& block, Plan& plan);
void prepare_cycle(Machine& machine, const Block& block, Plan& plan);
void prepare_synchronous(Machine& machine, const Block& block, Plan& plan);
void prepare_threading(Machine& machine, const Block& block, Plan& plan);

/// False when the sink has asked to stop.
bool run_cycle(Machine& machine, const Cycle& planned);
bool run_passes(Machine& machine, const Threading& thread);

/// Addresses that the motion code takes besides axes, D to R.
AddressSet words_of(const Machine& machine, Motion motion);

}  // namespace gonogo::expanders::ngc
