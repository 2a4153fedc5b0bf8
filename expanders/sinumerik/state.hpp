// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "expanders/sinumerik/configuration.hpp"
#include "expanders/sinumerik/expression.hpp"
#include "expanders/sinumerik/real.hpp"

namespace gonogo::expanders::sinumerik {

/// Modal code of the motion group.
enum class Motion { kRapid, kLine, kClockwise, kCounterclockwise, kThroughPoint, kTangent };

/// What AP and RP count from, along the axes of the plane.
struct Pole {
  Fixed p = 0;
  Fixed q = 0;
  bool rounded = false;  ///< it came from an angle
  Real rest_p = 0;       ///< what rounding took
  Real rest_q = 0;
  bool coarse = false;  ///< more was taken than is known
};

/// AP and RP in force.
struct Polar {
  bool has_angle = false;
  Fixed angle = 0;             ///< degrees, 0 to below 360
  bool angle_rounded = false;  ///< it was no whole number of counts
  bool has_radius = false;
  Fixed radius = 0;             ///< mm
  bool radius_rounded = false;  ///< it was no whole number of counts
};

/// The direction of a motion at its end, of any length.
struct Heading {
  std::array<Real, 3> along{};  ///< X, Y, Z
  bool exact = false;           ///< whole numbers up to kLargestWhole
  Real doubt = 0;               ///< by what angle it may be beside, where a place is coarse
  bool known() const { return along != std::array<Real, 3>{}; }
};

/// All that one block hands to the next; places are those of the workpiece.
struct State {
  explicit State(const Configuration& configuration)
      : position(configuration.position),
        inch(configuration.inch),
        plane(configuration.plane),
        feed(configuration.feed),
        motion(configuration.motion >= 0    ? static_cast<Motion>(configuration.motion)
               : configuration.starts_rapid ? Motion::kRapid
                                            : Motion::kLine),
        spindle_turns(configuration.spindle_turns),
        speed_given(configuration.spindle_turns) {}

  Point position;
  Axes rounded = 0;       ///< axes whose position is only nearly what was asked for
  Remainder remainder{};  ///< of the position, where it is known
  Axes coarse = 0;        ///< axes whose remainder is not known
  bool inch;
  bool incremental = false;
  int plane;
  Fixed feed;  ///< F as it was written; 0: none
  bool feed_per_revolution = false;
  Motion motion;
  bool spindle_turns;
  Fixed speed = 0;   ///< S
  bool speed_given;  ///< S above 0
  Pole pole;
  Polar polar;
  Heading heading;
  Fixed tool = 0;        ///< T; 0: none
  bool has_edge = true;  ///< D is not 0
  Parameters parameters{};
  std::uint64_t line = 0;
};

}  // namespace gonogo::expanders::sinumerik
