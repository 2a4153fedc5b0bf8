// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "expanders/gsk/configuration.hpp"
#include "expanders/gsk/fixed.hpp"

namespace gonogo::expanders::gsk {

/// The axes of a plane: first, second, and the one normal to it (indices into Point).
struct Plane {
  int number;
  std::size_t p;
  std::size_t q;
  std::size_t d;
};

inline constexpr Plane kPlanes[] = {{17, GONOGO_X, GONOGO_Y, GONOGO_Z},
                                    {18, GONOGO_Z, GONOGO_X, GONOGO_Y},
                                    {19, GONOGO_Y, GONOGO_Z, GONOGO_X}};

inline constexpr const Plane& plane_of(int number) {
  return kPlanes[number - 17];
}

/// A set of axes, one bit each.
using Axes = unsigned;
inline constexpr Axes axis_bit(std::size_t axis) {
  return 1u << axis;
}

/// Modal code of group 01.
enum class Motion { kRapid, kLine, kArcClockwise, kArcCounterclockwise, kFaceCycle };

/// Modal code of group 10.
enum class Cycle { kNone, kPocketClockwise, kPocketCounterclockwise };

/// A length that a modal word left behind.
struct Retained {
  bool present = false;
  bool incremental = false;
  Fixed value = 0;
};

/// What G94 keeps from block to block, in mm.
struct FaceStore {
  std::array<Retained, 3> end{};  // X, Y, Z
  Retained taper;

  bool empty() const {
    return !end[0].present && !end[1].present && !end[2].present && !taper.present;
  }
};

/// What G110 and G111 keep from block to block, in mm.
struct PocketStore {
  Retained radius;       // I
  Retained step;         // L
  Retained step_down;    // Q
  Retained tool_radius;  // D
  Retained r_plane;      // R, from the initial plane
  Retained clearance;    // P
  Fixed initial_plane = 0;
};

/// All that one block hands to the next.
struct State {
  explicit State(const Configuration& configuration)
      : position(configuration.position),
        plane(&plane_of(configuration.plane)),
        inch(configuration.inch),
        feed(configuration.feed),
        motion(static_cast<Motion>(configuration.motion)) {}

  Point position;
  const Plane* plane;
  bool inch;
  bool per_revolution = false;
  Fixed feed;  // mm a minute or a revolution; 0: none in force
  Motion motion;
  Cycle cycle = Cycle::kNone;
  FaceStore face;
  PocketStore pocket;
  std::uint64_t line = 0;
};

}  // namespace gonogo::expanders::gsk
