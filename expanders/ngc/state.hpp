// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "expanders/ngc/profile.hpp"

namespace gonogo::expanders::ngc {

/// Code of the motion group in force, in tenths.
enum class Motion : std::uint16_t {
  kRapid = 0,
  kLine = 10,
  kArcClockwise = 20,
  kArcCounterclockwise = 30,
  kG33 = 330,
  kG331 = 331,
  kG73 = 730,
  kG74 = 740,
  kG76 = 760,
  kNone = 800,
  kG81 = 810,
  kG82 = 820,
  kG83 = 830,
  kG84 = 840,
  kG85 = 850,
  kG86 = 860,
  kG89 = 890
};

inline constexpr bool is_arc(Motion motion) {
  return motion == Motion::kArcClockwise || motion == Motion::kArcCounterclockwise;
}

/// G73, G74 and G81 to G89.
inline constexpr bool is_cycle(Motion motion) {
  return motion > Motion::kNone || motion == Motion::kG73 || motion == Motion::kG74;
}

/// F in force; 0: none.
struct FeedRate {
  Fixed linear = 0;  ///< mm a minute
  Fixed rotary = 0;  ///< degrees a minute: the number as it was written
  bool is_programmed = false;
  bool operator==(const FeedRate&) const = default;
};

/// How F counts, by its code in tenths.
enum class FeedMode : std::uint16_t { kInverseTime = 930, kPerMinute = 940, kPerTurn = 950 };

/// What the words of later blocks mean, and what M70 and M73 put aside of it.
struct Modes {
  bool inch = false;
  bool incremental = false;
  bool absolute_centre = false;  // G90.1
  bool diameter = false;         // G7
  int plane = 17;
  FeedRate feed;
  FeedMode feed_mode = FeedMode::kPerMinute;
  bool surface_speed = false;  // G96
  bool to_initial = false;     // G98
};

/// What one block of a hole cycle hands to the next (NGC-CYC-03, 08).
struct CycleStore {
  // Numbers as they were written; nothing: not yet.
  std::optional<Fixed> r;
  std::optional<Fixed> depth;  // of the third axis
  std::optional<Fixed> p;
  std::optional<Fixed> q;
  // The same two as places, for the reading ngc.cycle.sticky.
  Fixed r_level = 0;
  Fixed bottom = 0;
};

/// What some planted faults remember.
struct Leftovers {
  bool absolute = false;         // there was a G90
  Point steps{};                 // the last word of each axis
  std::optional<Fixed> count;    // L
  std::optional<Fixed> lead;     // K
  std::optional<FeedRate> feed;  // before a cycle
};

/// All that one block hands to the next.
struct State : Modes {
  explicit State(const MachineProfile& profile)
      : position(profile.position),
        motion(profile.motion < 0 ? Motion::kNone : static_cast<Motion>(profile.motion * 10)),
        spindle(profile.spindle) {
    inch = profile.inch;
    plane = profile.plane;
    feed = {profile.feed, profile.feed};
    to_initial = profile.readings.follows("ngc.cycle.retract-start=initial"_reading);
  }

  Point position;
  Motion motion;
  bool first = true;  // the block before had another motion code in force
  int spindle;        // M3, M4 or M5
  int coolant = 0;    // M7: 1, M8: 2
  std::optional<Modes> saved;
  int saved_spindle = 5;
  int saved_coolant = 0;
  std::uint64_t line = 0;

  CycleStore cycle;
  Fixed dwell = 0;  // the last P of a cycle (reading ngc.tap.p)
  bool in_series = false;
  Fixed initial = 0;             // initial level of the series, mm
  bool initial_in_inch = false;  // units in which it was taken
  Leftovers leftovers;
};

}  // namespace gonogo::expanders::ngc
