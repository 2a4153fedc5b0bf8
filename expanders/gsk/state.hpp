// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "expanders/common/axes.hpp"
#include "expanders/gsk/configuration.hpp"

namespace gonogo::expanders::gsk {

/// Modal code of group 01; the last three are the turning cycles G90, G92 and G94.
enum class Motion {
  kRapid,
  kLine,
  kArcClockwise,
  kArcCounterclockwise,
  kTurnCycle,
  kThreadCycle,
  kFaceCycle
};

inline constexpr bool is_turning_cycle(Motion motion) {
  return motion >= Motion::kTurnCycle;
}

/// Modal code of group 10, in the order of the codes from G110.
enum class Cycle {
  kNone,
  kPocketClockwise,
  kPocketCounterclockwise,
  kHelixClockwise,
  kHelixCounterclockwise,
  kExternalThreadClockwise,
  kExternalThreadCounterclockwise,
  kInternalThreadClockwise,
  kInternalThreadCounterclockwise
};

/// The two senses of a cycle are one mode (GSK-MOD-01).
enum class Mode { kNone, kPocket, kHelix, kExternalThread, kInternalThread };

inline constexpr Mode mode_of(Cycle cycle) {
  return static_cast<Mode>((static_cast<int>(cycle) + 1) / 2);
}
inline constexpr bool is_thread_milling(Mode mode) {
  return mode == Mode::kExternalThread || mode == Mode::kInternalThread;
}
/// Sign of `rot`: the even codes turn clockwise.
inline constexpr int sense_of(Cycle cycle) {
  return static_cast<int>(cycle) % 2 == 1 ? -1 : 1;
}

/// A length that a modal word left behind.
struct Retained {
  bool present = false;
  bool incremental = false;
  Fixed value = 0;
};

/// What G90, G92 and G94 keep from block to block, in mm.
struct TurningStore {
  std::array<Retained, 3> end{};  // X, Y, Z
  Retained taper;

  bool empty() const {
    return !end[0].present && !end[1].present && !end[2].present && !taper.present;
  }
};

/// What G110 to G113 keep from block to block, in mm; no word of G114 to G117 is modal.
struct PocketStore {
  Retained radius;       // I
  Retained step;         // L
  Retained step_down;    // Q
  Retained tool_radius;  // D
  Retained r_plane;      // R, from the initial plane
  Retained clearance;    // P
  Retained turns;        // L of G112, in counts of a turn
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
  Fixed feed;      // mm a minute or a revolution; 0: none in force
  Fixed lead = 0;  // F of G92, mm a revolution; 0: none in force
  Motion motion;
  Cycle cycle = Cycle::kNone;
  TurningStore turning;
  PocketStore pocket;
  Fixed initial_plane = 0;  // of the cycle in force
  std::uint64_t line = 0;
};

}  // namespace gonogo::expanders::gsk
