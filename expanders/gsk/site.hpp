// SPDX-License-Identifier: GPL-3.0-or-later
// What G110 to G117 have in common: centre, planes and depth.
#pragma once

#include <initializer_list>

#include "expanders/gsk/machine.hpp"

namespace gonogo::expanders::gsk {

/// Where a cycle works.
struct Site {
  Point centre{};  ///< all axes but the depth axis
  Axes axes = 0;   ///< that are positioned
  Fixed initial_plane = 0;
  Fixed r_plane = 0;
  Fixed depth = 0;  ///< from the R plane, signed
};

/// A word that a cycle keeps, or has from its block.
struct GivenWord {
  char address;
  const Retained& value;
};
/// Complains of the first word that is missing.
void check_present(Machine& machine, std::initializer_list<GivenWord> words);
/// Complains of the first length that is there and not above 0.
void check_positive(Machine& machine, std::initializer_list<GivenWord> words);

/// The centre from the axis words (GSK-G110-01, 06, 14). False: there is nothing to mill; the plan
/// has then what there is to move.
bool find_centre(Machine& machine, const Block& block, Site& site, Plan& plan);

/// R plane and depth. `direction_free`: R may point away from the bottom. `from_initial`: an
/// incremental depth counts from the initial plane.
struct DepthRules {
  bool direction_free = false;
  bool from_initial = false;
};
void find_depth(Machine& machine, const Block& block, const Retained& to_r_plane,
                const DepthRules& rules, Site& site);

/// Rapid to the centre, then to the R plane (GSK-G110-06, 07; GSK-G112-03; GSK-G114-05).
bool approach(Machine& machine, const Site& site);
/// To a plane of the depth axis: at feed where it has milled and `at_feed` says so, else in rapid.
bool retract(Machine& machine, const Site& site, Fixed plane, bool at_feed);

/// G114 to G117. Radii are the tool centre's.
struct ThreadMilling {
  Site site;
  int side = 1;       ///< the free side of the thread: 1 outwards (external), -1 inwards
  Fixed surface = 0;  ///< radius at which the tool touches the uncut part
  Fixed height = 0;   ///< P
  Fixed infeed = 0;   ///< Q; at most the height
  Fixed lead = 0;
  Fixed run_out = 0;  ///< J
  Fixed angle = 0;    ///< K, degrees from 0 to below 360
  int rot = 0;
};

/// The motion, in thread_path.cpp; false when the sink has asked to stop.
bool mill_thread(Machine& machine, const ThreadMilling& thread);

}  // namespace gonogo::expanders::gsk
