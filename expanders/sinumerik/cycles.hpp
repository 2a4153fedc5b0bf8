// SPDX-License-Identifier: GPL-3.0-or-later
// What LCYC75 and LCYC82 have in common, and a pocket as its rules have left it. Lengths in counts.
#pragma once

#include "expanders/sinumerik/machine.hpp"

namespace gonogo::expanders::sinumerik {

/// The R parameters of a cycle in counts; what none can be is complained of.
class CycleParameters {
 public:
  explicit CycleParameters(Machine& machine) : machine_(machine) {}

  Fixed operator()(int number);

  /// Complains of R`number`.
  void complain(AlarmKind kind, int number);
  /// SIE-LC82-02: the planes R101 to R104.
  void check_planes();
  /// Complains of R`number` below 0.
  void check_not_negative(int number);

 private:
  bool counts_inches(int number) const;

  Machine& machine_;
};

/// Whether the cycle stands alone in its block; complains if not.
bool stands_alone(Machine& machine, const Block& block);

/// Way straight along the third axis, for what goes on from the cycle.
Direction heading_along_depth(const Plane& plane);

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
};

/// From one pass over a wide strip to the next, in radii of the tool.
inline constexpr double kBetweenPasses = 1.3;

struct Pocket {
  int plane = 17;
  Real centre_p = 0;
  Real centre_q = 0;
  Fixed retract = 0;
  Fixed start = 0;  ///< down to it there is no material
  Levels levels;
  Area area;
  double radius = 0;          ///< of the tool
  bool strip_only = false;    ///< above the last level only the rest that roughing has left is cut
  bool contour_only = false;  ///< at the last level too
  int inner_passes = 0;       ///< over that rest, besides the one along the border
  int sense = 1;              ///< of the contour: 1 counterclockwise, -1 clockwise
  Feed depth_feed;
  Feed plane_feed;
};

/// The way of the tool, from where it is to `target`; false when the sink has asked to stop.
bool mill_pocket(Machine& machine, const Pocket& pocket, const Target& target);

}  // namespace gonogo::expanders::sinumerik
