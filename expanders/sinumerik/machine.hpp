// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "expanders/common/machine.hpp"
#include "expanders/common/plan.hpp"
#include "expanders/sinumerik/block.hpp"
#include "expanders/sinumerik/faults.hpp"
#include "expanders/sinumerik/frame.hpp"
#include "expanders/sinumerik/profile.hpp"

namespace gonogo::expanders::sinumerik {

/// Modal code of the motion group.
enum class Motion { kRapid, kLine, kClockwise, kCounterclockwise, kThroughPoint, kTangent };

/// AP and RP in force.
struct Polar {
  bool has_angle = false;
  Real angle = 0;  ///< degrees, in counts
  bool has_radius = false;
  Real radius = 0;
};

/// What AP and RP count from, along the axes of the plane.
struct Pole {
  Real p = 0;
  Real q = 0;
};

/// All that one block hands to the next; places are those of the workpiece.
struct State {
  Place position{};
  Direction untravelled{};  ///< changes of the shift since each axis moved, of the machine
  bool inch = false;
  bool incremental = false;
  int plane = 17;
  Fixed feed = 0;              ///< F as it was written; 0: none
  bool feed_of_cycle = false;  ///< it is R123, which counts millimetres
  bool feed_per_revolution = false;
  Motion motion = Motion::kLine;
  bool spindle_turns = false;
  Fixed speed = 0;                      ///< S
  bool speed_given = false;             ///< S above 0
  bool constant_cutting_speed = false;  ///< G96, G961
  bool turns_unknown = false;           ///< S was a cutting speed
  Pole pole;
  Polar polar;
  Direction heading{};   ///< of the last motion at its end, of any length; none: there was none
  Fixed tool = 0;        ///< T; 0: none
  bool has_edge = true;  ///< D is not 0
  Parameters parameters{};
};

/// What every code works on.
class Machine : public expanders::Machine {
 public:
  Machine(const MachineProfile& machine_profile, const gonogo_sink_v1& sink,
          Planted<Fault> planted);

  State state;
  Frame frame;

  Control control() const;
  /// Without translation and rotation.
  Frame plain_frame() const;
  const Plane& plane() const { return plane_of(state.plane); }
  /// A place of the workpiece as it is put out.
  Point output(const Place& place) const { return rounded(frame.to_machine(place)); }

  using expanders::Machine::complain;
  void complain(AlarmKind kind, Address address, const Block& block) {
    complain(kind, letter_of(address), block.position(address));
  }

 private:
  Point output_position_;
};

inline constexpr Axes kLinearAxes = axis_bit(GONOGO_X) | axis_bit(GONOGO_Y) | axis_bit(GONOGO_Z);
inline constexpr Axes plane_axes(const Plane& plane) {
  return axis_bit(plane.p) | axis_bit(plane.q);
}
inline bool in_reach(Real value) {
  return std::fabs(value) <= static_cast<Real>(kReach);
}

/// Where a motion ends.
struct Target {
  Place to{};
  Axes axes = 0;  ///< those with a word, of a polar target both of the plane
};

// In words.cpp.

/// The axes with a word in the block.
Axes axes_of(const Block& block);
/// The length of `address`, by the units in force; the word must be there.
Real length_of(const Machine& machine, const Block& block, Address address);
/// Whether a word counts from the position: as G90 or G91 say, or its brackets.
bool is_incremental(const State& state, Value::Mode mode);
/// What an increment along X, Y or Z goes beside its number.
Real untravelled(const Machine& machine, std::size_t axis);
/// The point that the words command, polar ones or those of axes. Complains when it is out of
/// reach.
Target target_of(Machine& machine, const Block& block);
Target cartesian_target(Machine& machine, const Block& block);
/// Complains about numbers that are too large to compute with.
void check_sizes(Machine& machine, const Block& block);
/// The feed of a cut to `to`. Complains when there is none or the spindle stands.
Feed cutting_feed(Machine& machine, const Place& to, bool curved);
/// Complains about the words of `unwanted` that the block has.
void refuse(Machine& machine, const Block& block, Addresses unwanted);
/// Complains about TURN, except one of 0.
void refuse_rounds(Machine& machine, const Block& block);

// In polar.cpp.

bool is_polar(const Block& block);
/// Point that AP, RP and the words of further axes command, and keeps AP and RP for later blocks.
Target polar_target(Machine& machine, const Block& block);
/// A pole block: G110, G111, G112.
void take_pole(Machine& machine, const Block& block, unsigned code);
/// Position, zero or pole; AP and RP are forgotten.
void place_pole(State& state, const Pole& pole);

// The motions of blocks: each prepares a plan, which moves the tool when it is performed.

void prepare_dwell(Machine& machine, const Block& block, Plan& plan);
void prepare_line(Machine& machine, const Block& block, bool rapid, Plan& plan);
void prepare_arc(Machine& machine, const Block& block, bool counterclockwise, Plan& plan);
void prepare_through_point(Machine& machine, const Block& block, Plan& plan);
void prepare_tangent(Machine& machine, const Block& block, Plan& plan);
/// A frame block: G158, G258, G259.
void take_frame(Machine& machine, const Block& block, unsigned code);
void prepare_drilling(Machine& machine, const Block& block, Plan& plan);
void prepare_pocket(Machine& machine, const Block& block, Plan& plan);

/// The tool goes straight to the target; without a feed it traverses.
void plan_line(Machine& machine, const Target& target, const std::optional<Feed>& feed, Plan& plan);
/// These axes have moved, and what was shifted along them with them.
void clear_untravelled(Machine& machine, Axes axes);
/// The tool is at the target, and goes on from there in this direction; none: as before.
void arrive(Machine& machine, const Target& target, const Direction& heading);

inline constexpr Addresses kCentreWords = addresses(Address::kI, Address::kJ, Address::kK);
inline constexpr Addresses kIntermediateWords = addresses(Address::kI1, Address::kJ1, Address::kK1);
inline constexpr Addresses kPolarWords = addresses(Address::kPolarAngle, Address::kPolarRadius);
inline constexpr Addresses kArcWords =
    kCentreWords | addresses(Address::kRadius, Address::kOpeningAngle);

}  // namespace gonogo::expanders::sinumerik
