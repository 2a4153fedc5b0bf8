// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "expanders/hnc/configuration.hpp"

namespace gonogo::expanders::hnc {

/// Modal code of the motion group.
enum class Motion {
  kRapid,
  kLine,
  kArcClockwise,
  kArcCounterclockwise,
  kThread,       // G32
  kDrill,        // G74
  kGroove,       // G75
  kTurn,         // G80
  kFace,         // G81
  kThreadCycle,  // G82
};

Motion motion_of(int code);

inline constexpr bool is_cycle(Motion motion) {
  return motion >= Motion::kDrill;
}
/// F and J are the lead.
inline constexpr bool is_thread(Motion motion) {
  return motion == Motion::kThread || motion == Motion::kThreadCycle;
}

/// A number that a modal word left behind.
struct Retained {
  bool present = false;
  Fixed value = 0;
};

/// What a cycle, or G32, keeps from block to block until the command changes. Lengths are true
/// millimetres, whatever the units were changed to since.
struct CycleStore {
  Retained taper;       // I of G80 and G82, K of G81
  Retained withdrawal;  // R of G74 and G75
  Retained infeed;      // Q of G74 and G75
  Retained steps;       // I (P) of G75, a count in counts of one
  Retained run_out_z;   // R of G82
  Retained run_out_x;   // E of G82
  Retained starts;      // C of G82, in counts of one
  Retained angle;       // P of G82, degrees
  Fixed lead = 0;       // mm a revolution; 0: none in force
  Fixed feed = 0;       // own to the command (reading hnc.modal.f)
  Retained end_x;       // C of the last block that ran, base frame
  Retained end_z;
};

/// All that one block hands to the next.
struct State {
  explicit State(const Configuration& configuration)
      : position(configuration.position),
        frame(configuration.no_initial_frame ? nullptr : &configuration.offsets[0]),
        inch(configuration.inch),
        diameter(configuration.x_diameter),
        feed(configuration.feed),
        motion(motion_of(configuration.motion)) {}

  Point position;      // in the base frame
  const Point* frame;  // offset of the work frame in force; null: none
  bool incremental = false;
  bool inch;
  bool diameter;
  bool per_revolution = false;
  Fixed feed;  // mm a minute or a revolution; 0: none in force
  Motion motion;
  CycleStore store;
  std::uint64_t line = 0;
};

}  // namespace gonogo::expanders::hnc
