// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "expanders/sinumerik/machine.hpp"
#include "expanders/sinumerik/pocket.hpp"

namespace gonogo::expanders::sinumerik {

// What a block will do. Preparing a plan checks every rule of the block and complains to the
// machine; performing it cannot fail (false: the sink has asked to stop). So an alarming block
// moves nothing.

struct Idle {};

/// G4.
struct Dwell {
  Fixed seconds = 0;
};

/// G0, G1, and what CIP and CT make straight.
struct Line {
  Target target;
  bool rapid = false;
  Feed feed;
};

/// G2, G3, CT.
struct Arc {
  int plane = 17;
  Target target;
  Wide centre_p = 0;
  Wide centre_q = 0;
  int rot = 0;
  Feed feed;
};

/// CIP.
struct SpaceArc {
  Point via{};
  Target target;
  Feed feed;
};

/// LCYC82; ends at `target`.
struct Drilling {
  std::size_t axis = GONOGO_Z;
  Fixed start = 0;
  Fixed depth = 0;
  Fixed seconds = 0;
  Feed feed;
  Target target;
};

/// LCYC75; ends at `target`.
struct Pocketing {
  Pocket pocket;
  Target target;
};

struct Plan {
  std::variant<Idle, Dwell, Line, Arc, SpaceArc, Drilling, Pocketing> motion;
  Heading heading;  ///< at the end; not known: as before
};

void prepare_dwell(Machine& machine, const Block& block, Plan& plan);
void prepare_line(Machine& machine, const Block& block, bool rapid, Plan& plan);
void prepare_arc(Machine& machine, const Block& block, bool counterclockwise, Plan& plan);
void prepare_through_point(Machine& machine, const Block& block, Plan& plan);
void prepare_tangent(Machine& machine, const Block& block, Plan& plan);

bool perform(Machine& machine, const Idle& motion);
bool perform(Machine& machine, const Dwell& motion);
bool perform(Machine& machine, const Line& motion);
bool perform(Machine& machine, const Arc& motion);
bool perform(Machine& machine, const SpaceArc& motion);
bool perform(Machine& machine, const Drilling& motion);
bool perform(Machine& machine, const Pocketing& motion);

/// The place from which the block starts, as a target.
Target start_of(const State& state);

/// The way along X, Y, Z in counts, with what rounding took; none at all between places that may be
/// one place reckoned twice.
std::array<Real, 3> way_between(const Target& from, const Target& to);

/// What each end of a way may be beside, in counts, where a place is coarse.
Real doubt_between(const Target& from, const Target& to, Axes axes);

/// The direction of the straight way to `target`.
Heading straight_heading(const State& state, const Target& target);

/// What Machine::lacking says of arcs whose centre the digits of the processor do not reach.
inline constexpr std::string_view kFlatArc = "An arc as flat as this";
inline constexpr std::string_view kUnclearArc = "An arc as near its limit as this";

}  // namespace gonogo::expanders::sinumerik
