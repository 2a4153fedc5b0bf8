// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "expanders/ngc/configuration.hpp"

namespace gonogo::expanders::ngc {

/// Modal code of the motion group.
enum class Motion { kNone, kRapid, kLine, kArcClockwise, kArcCounterclockwise };

/// `code`: 0 to 3; any other (G80, a negative number) is none.
inline constexpr Motion motion_of(int code) {
  return code >= 0 && code <= 3 ? static_cast<Motion>(code + 1) : Motion::kNone;
}

/// F in force; 0: none.
struct FeedRate {
  Fixed linear = 0;  ///< mm a minute
  Fixed rotary = 0;  ///< degrees a minute: the number as it was written
};

/// All that one block hands to the next.
struct State {
  explicit State(const Configuration& configuration)
      : position(configuration.position),
        inch(configuration.inch),
        plane(configuration.plane),
        feed{configuration.feed, configuration.feed},
        motion(motion_of(configuration.motion)) {}

  Point position;
  bool inch;
  bool incremental = false;
  bool absolute_centre = false;  // G90.1
  int plane;
  FeedRate feed;
  Motion motion;
  bool seen_absolute = false;  // a G90, for the fault that latches it
  std::uint64_t line = 0;
};

}  // namespace gonogo::expanders::ngc
