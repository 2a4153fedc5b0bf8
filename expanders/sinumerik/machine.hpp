// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string_view>

#include "expanders/common/complaints.hpp"
#include "expanders/common/flow.hpp"
#include "expanders/common/tracer.hpp"
#include "expanders/sinumerik/alarms.hpp"
#include "expanders/sinumerik/block.hpp"
#include "expanders/sinumerik/faults.hpp"
#include "expanders/sinumerik/frame.hpp"
#include "expanders/sinumerik/state.hpp"

namespace gonogo::expanders::sinumerik {

/// What every code works on.
class Machine : public Complaints<AlarmKind> {
 public:
  Machine(const Configuration& machine_configuration, const gonogo_sink_v1& sink, Fault planted)
      : configuration(machine_configuration),
        state(machine_configuration),
        frame(plain_frame(planted)),
        output_position_(frame.to_machine(state.position)),
        tracer(sink, output_position_, state.line),
        fault_(planted) {}
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  const Configuration& configuration;
  State state;
  Frame frame;

 private:
  Point output_position_;

 public:
  Tracer tracer;

  bool has(Fault planted) const { return fault_ == planted; }
  /// Without translation and rotation.
  Frame plain_frame() const { return plain_frame(fault_); }

  /// What the expander would need for the block and has not; "": nothing.
  std::string_view lacking;
  /// A turn by an angle that may be beside puts nothing so far off that it would be seen.
  void check_turn(Real angle_doubt, Real distance) {
    if (angle_doubt * distance > kSharp) lacking = "A turn as far off as this";
  }
  /// The same of the frame in force, for a place of the workpiece.
  void check_distance(Real p, Real q) { check_turn(frame.doubt(), std::hypot(p, q)); }

  using Complaints::complain;
  void complain(AlarmKind kind, Address address, const Block& block) {
    complain(kind, letter_of(address), block.position(address));
  }

 private:
  static Frame plain_frame(Fault planted) {
    Frame frame;
    if (planted == Fault::kRotationAboutBase) frame.turn_about_machine_zero();
    if (planted == Fault::kRotationG18Flipped) frame.turn_the_other_way_in_g18();
    return frame;
  }

  Fault fault_;
};

inline constexpr Axes kLinearAxes = axis_bit(GONOGO_X) | axis_bit(GONOGO_Y) | axis_bit(GONOGO_Z);
inline constexpr Axes plane_axes(const Plane& plane) {
  return axis_bit(plane.p) | axis_bit(plane.q);
}

/// No coordinate or length is larger: their squares and those of chords can be reckoned with.
inline constexpr Fixed kReach = 1'000'000'000 * kOne;
inline constexpr bool in_reach(Wide value) {
  return value <= kReach && value >= -kReach;
}

/// Where a motion ends.
struct Target {
  Point to{};
  Axes axes = 0;          ///< those with a word, of a polar target both of the plane
  Axes rounded = 0;       ///< as State::rounded, after the motion
  Remainder remainder{};  ///< as State::remainder
  Axes coarse = 0;        ///< as State::coarse
};

/// Whether the frame in force brings a place of the workpiece to where it belongs.
void check_place(Machine& machine, const Point& place);

/// The axes with a word in the block.
Axes axes_of(const Block& block);

/// Point that the axis words of the block command. Complains when it is out of reach.
Target cartesian_target(Machine& machine, const Block& block);

/// Whether the block has words of a polar target.
bool is_polar(const Block& block);

/// Point that AP, RP and the words of further axes command, and keeps AP and RP for later blocks.
Target polar_target(Machine& machine, const Block& block);

/// A pole block: G110, G111, G112.
void take_pole(Machine& machine, const Block& block, int code);

/// Position, zero or pole; AP and RP are forgotten.
void place_pole(State& state, const Pole& pole);

/// The length of `address` in mm, by the units in force; the word must be there.
Fixed length_of(const Machine& machine, const Block& block, Address address);

/// Whether a word counts from the position: as G90 or G91 say, or its brackets.
bool is_incremental(const State& state, Value::Mode mode);

/// Whether the number of `address` is not whole; the word must be there.
bool has_fraction(const Block& block, Address address);

/// Complains about numbers that are too large to reckon with.
void check_sizes(Machine& machine, const Block& block);

/// The feed of a cut to `to`. Complains when there is none or the spindle stands.
Feed cutting_feed(Machine& machine, const Point& to, bool curved);

/// Complains about the words of `unwanted` that the block has.
void refuse(Machine& machine, const Block& block, Addresses unwanted);

inline constexpr Addresses kCentreWords = addresses(Address::kI, Address::kJ, Address::kK);
inline constexpr Addresses kIntermediateWords = addresses(Address::kI1, Address::kJ1, Address::kK1);
inline constexpr Addresses kPolarWords = addresses(Address::kPolarAngle, Address::kPolarRadius);
inline constexpr Addresses kArcWords =
    kCentreWords | addresses(Address::kRadius, Address::kOpeningAngle);

}  // namespace gonogo::expanders::sinumerik
