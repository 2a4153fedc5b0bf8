// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/complaints.hpp"
#include "expanders/common/flow.hpp"
#include "expanders/common/tracer.hpp"
#include "expanders/ngc/alarms.hpp"
#include "expanders/ngc/block.hpp"
#include "expanders/ngc/faults.hpp"
#include "expanders/ngc/state.hpp"

namespace gonogo::expanders::ngc {

/// What every code works on.
class Machine : public Complaints<AlarmText>, public Faults {
 public:
  Machine(const MachineProfile& machine_profile, const gonogo_sink_v1& sink, const Faults& planted)
      : Faults(planted),
        profile(machine_profile),
        state(machine_profile),
        tracer(sink, state.position, state.line),
        whole(machine_profile.readings, *this) {}
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  const MachineProfile& profile;
  State state;
  Tracer tracer;
  WholeNumbers whole;

  /// Whether the machine follows this alternative.
  bool follows(Reading reading) const { return profile.readings.follows(reading); }

  using Complaints::complain;
  void complain(const AlarmText& kind, char word, const Block& block) {
    complain(kind, word, block.position(word));
  }
};

/// The feed in force, by G94 or G95.
inline Feed feed_of(const State& state) {
  return {state.feed.linear, state.feed_mode == FeedMode::kPerTurn};
}

/// In the order of gonogo_axis.
inline constexpr char kAxisAddress[] = "XYZAC";
inline constexpr AddressSet kAxisWords{"XYZAC@^"};
inline constexpr AddressSet kLinearWords{"XYZ@^"};
inline constexpr AddressSet kRotaryWords{"AC"};
inline constexpr Axes kLinearAxes = axis_bit(GONOGO_X) | axis_bit(GONOGO_Y) | axis_bit(GONOGO_Z);

/// Point that the axis words of the block command, by G90 or G91; `axes` are those with a word.
/// Complains when it is out of reach.
Point commanded_point(Machine& machine, const Block& block, Axes& axes);

/// A number that stands for a length, in mm, by the units in force (NGC-UNI-01).
Fixed length_of(const Machine& machine, Fixed number);
/// The length of `address`; the word must be there.
Fixed length_of(const Machine& machine, const Block& block, char address);
/// The length that the word of `axis` moves it by or to; the word must be there.
Fixed length_along(const Machine& machine, const Block& block, std::size_t axis);

/// `place`; complains about `address` and gives 0 when it is out of reach.
Fixed reached(Machine& machine, const Block& block, Wide place, char address);

/// Complains about numbers of words of the set that are too large to compute with.
void check_sizes(Machine& machine, const Block& block, AddressSet words);

}  // namespace gonogo::expanders::ngc
