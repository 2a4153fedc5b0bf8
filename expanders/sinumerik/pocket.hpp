// SPDX-License-Identifier: GPL-3.0-or-later
// LCYC75: what is to be done, as the rules have left it. Lengths in counts.
#pragma once

#include "expanders/common/axes.hpp"
#include "expanders/common/tracer.hpp"

namespace gonogo::expanders::sinumerik {

/// Where the middle of the tool may be, about the middle of the pocket: a rectangle, its corners
/// rounded.
struct Area {
  double half_length = 0;  ///< along the first axis of the plane
  double half_width = 0;   ///< along the second
  double corner = 0;
};

/// The depths of the levels.
struct Levels {
  Fixed from = 0;
  Fixed floor = 0;
  Fixed most = 0;   ///< the largest infeed
  Fixed count = 1;  ///< of levels
  bool equal = true;
  /// Depth of level `k`, from 1.
  Fixed depth(Fixed k) const;
  /// Sets `count`. `rounded`: the lengths are right to a count only.
  void count_levels(bool rounded);
};

struct Pocket {
  int plane = 17;
  Fixed centre_p = 0;
  Fixed centre_q = 0;
  Fixed retract = 0;
  Fixed start = 0;  ///< down to it there is no material
  Levels levels;
  Area area;
  double radius = 0;          ///< of the tool
  bool strip_only = false;    ///< above the last level only the rest that roughing has left is cut
  bool contour_only = false;  ///< at the last level too
  bool wide_strip = false;    ///< that rest is more than one pass takes
  int sense = 1;              ///< of the contour: 1 counterclockwise, -1 clockwise
  Feed depth_feed;
  Feed plane_feed;
};

}  // namespace gonogo::expanders::sinumerik
